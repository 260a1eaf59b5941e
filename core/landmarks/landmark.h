#pragma once

#include "core/geometry/spaces.h"
#include "core/text/json_value.h"

#include <glm/fwd.hpp> // u8vec3
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace unprojector::landmarks {

// How a landmark is held to an object. Triangles are counted through all meshes of its model from 0, vertices as its file
// counts them, from 0.

/// By nothing: its coordinates say where it is.
struct Free {
    friend bool operator==(const Free &, const Free &) = default;
};
struct OnTriangle {
    std::uint32_t triangle = 0;
    glm::dvec3 barycentric{0.0}; ///< of its three corners; their sum is 1
    friend bool operator==(const OnTriangle &, const OnTriangle &) = default;
};
struct AtVertex {
    std::uint32_t vertex = 0;
    friend bool operator==(const AtVertex &, const AtVertex &) = default;
};
struct OnEdge {
    std::array<std::uint32_t, 2> vertices{};
    double share = 0.0; ///< of the way from the first to the second, in [0, 1]
    friend bool operator==(const OnEdge &, const OnEdge &) = default;
};
using Anchor = std::variant<Free, OnTriangle, AtVertex, OnEdge>;

/// A named point that somebody placed.
struct Landmark {
    std::string name;                          ///< UTF-8; may be empty, and another one's too
    std::optional<geometry::WorldPoint> world; ///< nothing: it is missing, as on a broken bone
    std::string object;                        ///< name of the object that it lies on; empty: none
    Anchor anchor;
    std::optional<geometry::WorldVector> uncertainty; ///< how far each coordinate can be off, where that is known
    std::string note;                                 ///< UTF-8
    std::optional<glm::u8vec3> color;                 ///< none: the usual one
    bool isHidden = false;
    /// What a file said of it that has no place here, to be written again: null or an object.
    text::JsonValue extra;

    bool isMissing() const { return !world; }
    friend bool operator==(const Landmark &, const Landmark &) = default;
};

/// How a file has its axes. 3D Slicer works in RAS (right, anterior, superior) and takes model files to be in LPS (left,
/// posterior, superior): x and y have the other sign.
enum class Axes { Lps, Ras };

/// How a curve goes from each of its points to the next.
enum class CurveKind {
    Geodesic,     ///< as a thread pulled tight on the surface
    PlaneSection, ///< where the plane through both points and the surface's normals at them cuts the surface
};

inline constexpr int kMostSemilandmarks = 1000; ///< of one curve

/// A line on the surface through landmarks, and how many semilandmarks stand on it in equal steps.
struct Curve {
    std::string name;                ///< UTF-8
    std::vector<std::string> points; ///< the landmarks' names, in order; none: only `semilandmarks` are known of it
    CurveKind kind = CurveKind::Geodesic;
    std::uint32_t count = 10; ///< of semilandmarks, those at both ends included; at least 2
    /// Where they are, if somebody has worked that out: in what goes to files and comes from them.
    std::vector<geometry::WorldPoint> semilandmarks;
    text::JsonValue extra; ///< as a landmark's

    friend bool operator==(const Curve &, const Curve &) = default;
};

/// Landmarks in their order, of one specimen.
///
/// Their coordinates are always those of the mesh's own file, whatever axes the file of the landmarks had: what was read in
/// RAS has its x and y negated, and `axes` says that it is to be written so again.
struct LandmarkSet {
    std::string name; ///< of the specimen, UTF-8; may be empty
    std::string mesh; ///< the file of the mesh, as it was written; may be empty
    std::string unit; ///< "mm"; empty: not known
    Axes axes = Axes::Lps;
    std::vector<Landmark> landmarks;
    std::vector<Curve> curves;
    text::JsonValue extra; ///< as a landmark's

    friend bool operator==(const LandmarkSet &, const LandmarkSet &) = default;
};

} // namespace unprojector::landmarks
