#pragma once

#include "unprojector/scene.h"
#include "unprojector/setup.h"
#include "unprojector/unproject.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace unprojector {

/// A wrong program's answer to a click.
struct WrongPoint {
    glm::dvec2 pixel{0.0};                      ///< device pixels, origin top-left
    std::optional<double> depth = std::nullopt; ///< the right depth; empty: unknown
    glm::dvec3 got{0.0};                        ///< the wrong coordinate
    glm::dvec3 lastDigit{1e-4};                 ///< > 0: for each coordinate, the unit of its last given digit
    double depthLastDigit = 0.0;                ///< the same of the depth; 0: the depth is exact
};

/// Parses a point as programs print it; the written digits count.
/// @param pixel  "400.5,300.5"
/// @param depth  "0.838331"; empty: unknown
/// @param got    "0.7051,-0.4122,0.0918", "vec3(0.7051, -0.4122, 0.0918)" and the like
/// @return Value: the text that is wrong
UNPROJECTOR_PUBLIC Result<WrongPoint> wrongPoint(const std::string &pixel, const std::string &depth,
                                                 const std::string &got);

/// A line of code with the mistake, and the corrected line.
struct CodeChange {
    std::string mistake; ///< its id
    std::string library; ///< "GLU", "GLM", "Qt", "three.js", "NumPy"
    std::string wrong, right;
};

/// One or two mistakes, and their answer to the first point.
struct Candidate {
    std::string id;       ///< "right", "y-not-flipped", …; for two "a+b"
    std::string sentence; ///< what a program with them does; empty for "right"
    /// Solved values by name: {"far", {50}}. A value that is a word has the word instead.
    std::vector<std::pair<std::string, std::variant<std::vector<double>, std::string>>> values;
    glm::dvec3 point{0.0};
    double distance = 0.0; ///< from the given points, in units of their last digits
    bool explains = false; ///< explains all digits that count
};

struct Diagnosis {
    /// A mistake's id; "right"; "known-point": a point of the scene; "unknown".
    std::string verdict;
    std::string sentence;              ///< the verdict in words
    std::string report;                ///< several lines, as `unproject doctor` prints them
    std::string html;                  ///< the same as a fragment of HTML
    std::vector<Candidate> candidates; ///< the best first
    std::vector<CodeChange> code;      ///< of the verdict
    std::optional<glm::dvec3> right;   ///< the right answer to the first point
    std::optional<glm::dvec2> next;    ///< the pixel whose answer distinguishes the first candidates
    double chance = 0.0;               ///< that an unrelated point is explained as well
};

struct DiagnoseOptions {
    Space space = Space::World; ///< of the wrong points
    /// Another size that the program may still use, device pixels: a former size of the window.
    std::optional<std::pair<int, int>> otherSize = std::nullopt;
};

/// Finds the mistake behind wrong points of one program: all known mistakes and all pairs of them
/// are tried.
/// @param points  at most 100
/// @return Value: no point or too many, a pixel outside the window, a depth outside the depth range,
///         a last digit that is not above 0
UNPROJECTOR_PUBLIC Result<Diagnosis> diagnose(const Setup &setup, std::span<const WrongPoint> points,
                                              const DiagnoseOptions &options = {});
/// The same with the scene's meshes: an unknown depth is the mesh's, mistakes of model matrices are
/// tried, and a point that is a vertex is recognised.
UNPROJECTOR_PUBLIC Result<Diagnosis> diagnose(const Scene &scene, std::span<const WrongPoint> points,
                                              const DiagnoseOptions &options = {});

} // namespace unprojector
