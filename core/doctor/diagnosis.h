#pragma once

#include "core/geometry/box.h"
#include "core/geometry/result.h"
#include "core/geometry/setup.h"
#include "core/geometry/spaces.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Which mistake makes this wrong coordinate: every mistake is a function from what the wrong program was given to what it
/// answers; all of them and all pairs of them are tried, and ranked by how far their answers are from the point that was got.
namespace unprojector::doctor {

/// In which space the program says that its point lies.
enum class PointSpace { World, Eye, Object };

/// A model of the scene, for programs that leave its matrix in, or out.
struct PlacedModel {
    std::string name;
    glm::dmat4 worldFromObject{1.0};
};

/// A point of the scene that programs answer whatever was clicked.
struct KnownPoint {
    enum class Kind {
        Eye,
        ViewTranslation, ///< the view matrix's last column, given for a point
        CameraCentre,    ///< what gluLookAt looks at
        WorldOrigin,
        ObjectOrigin,
        Vertex
    };
    Kind kind = Kind::Eye;
    glm::dvec3 point{0.0};  ///< of Case::verticesIn in world space, of a diagnosis in that of the points
    std::string object;     ///< of an object's origin and a vertex: its name
    std::size_t vertex = 0; ///< its number in the file, see Model::vertexNumber
};

/// What the program was looking at.
struct Case {
    geometry::Setup setup;
    std::vector<PlacedModel> models; ///< those that the mistakes of the model matrix are tried with
    /// Another size that the program may still go by: the window's before, or that of another framebuffer.
    std::optional<geometry::Surface> otherSize;
    /// The depth of what is seen at a position, in the picture's depth range; nothing on the background. Empty where the
    /// scene has no mesh.
    std::function<std::optional<double>(const geometry::DevicePoint &)> depthOnMesh;
    /// The meshes' vertices in a box of world space, a few of them where there are many. Empty where the scene has no mesh.
    std::function<std::vector<KnownPoint>(const geometry::Box &)> verticesIn;
};

/// A point that a program answered, as it was given.
struct WrongPoint {
    geometry::DevicePoint pixel; ///< continuous device pixels from the framebuffer's top-left corner
    std::optional<double> depth; ///< the right one, in the picture's depth range
    glm::dvec3 got{0.0};         ///< the wrong coordinate
    glm::dvec3 lastDigit{1e-4};  ///< > 0: the unit of the last digit given, of each coordinate
    PointSpace space = PointSpace::World;
    std::size_t model = 0;       ///< of Case::models, for object space
    double depthLastDigit = 0.0; ///< the unit of the depth's last digit; 0: the depth is exact
};

/// In which of several ways a mistake is made.
struct VariantName {
    const char *words = nullptr; ///< marked for text::tr, %1 is the value: "ratio %1"; null: the value says it all
    std::string value;

    VariantName() = default;
    VariantName(const char *marked, std::string ofIt = {}) : words(marked), value(std::move(ofIt)) {}
    bool isEmpty() const { return words == nullptr && value.empty(); } ///< there are no others
};

/// How far a mistake cannot be told from the first of the candidates.
enum class Alike {
    No,
    InDigits, ///< both explain all digits given; their answers differ in further ones
    Here,     ///< both give the same answer to these clicks, and another one to others
    Always    ///< both give the same answer to every click in this scene
};

/// What two mistakes have in common, that the right program has otherwise: the first of these that it is.
enum class Shared { Window, Depth, Projection, View, Ndc, Matrix, Point };

/// One mistake, or two of them, and what it answers.
struct Candidate {
    std::string id;                ///< "right", "y-not-flipped", …, of two "a+b"
    std::vector<VariantName> ways; ///< of those of its mistakes that are made in several; see waysText
    glm::dvec3 point{0.0};         ///< its answer to the first point, in that point's space
    double distance =
        0.0;        ///< the greatest difference of a coordinate, in units of its last digit; mean over the points
    int digits = 0; ///< how many of the digits that count it explains, all coordinates of all points
    std::array<int, 3> digitsOfFirst{}; ///< of these, those of each coordinate of the first point
    bool explains = false; ///< all digits that count, of all points; the last of them may be cut off instead of rounded
    bool isCutOff = false; ///< explains, and some of the last ones are
    Alike alike = Alike::No;
    std::optional<Shared> shared; ///< where it is alike here or always
};

/// Where the wrong point lands with the right matrices: what is wrong there sorts the mistakes.
enum class ErrorKind {
    Right,
    Pixel,  ///< the depth is right, x' and y' are not: pixel, viewport or lens
    Depth,  ///< x' and y' are right, the depth is not
    Matrix, ///< neither is right
};

/// How the points' own depths were known.
enum class DepthKnown {
    Given,
    FromMesh, ///< of the scene's mesh, where the ray meets it
    ByRay,    ///< not at all: answers are rays, and mistakes of the depth cannot be told from each other
};

struct Diagnosis {
    /// An id; "right"; "known-point" where no mistake explains the points as well as that they are a point of the scene; "unknown"
    /// where nothing explains them, or anything might.
    std::string verdict;
    /// The points of the scene that the first point is, if all points are such ones; several may lie in one place. A vertex
    /// only where it is the verdict.
    std::vector<KnownPoint> known;
    std::vector<Candidate> candidates; ///< the best first, each id once; at least five
    /// x', y' (device pixels from the top-left corner) and depth of the first wrong point, by the right matrices; nothing in
    /// the plane of the eye.
    std::optional<glm::dvec3> projected;
    double depthUnsure = 0.0; ///< how far that depth moves when the point does, within its last digits; 0: not known
    ErrorKind wrong = ErrorKind::Right;
    DepthKnown depthKnown = DepthKnown::Given;
    std::optional<glm::dvec3> right; ///< what the first click gives, in its space; of an unknown depth, the nearest
    /// The unit of the last digit that `right` has, a power of ten: what rounding and the depth's last digit leave to the click,
    /// and of that seven digits of the greatest coordinate, or as many as were given.
    double rightLastDigit = 1.0;
    int digitsGiven = 0;                       ///< what Candidate::digits is at most: those that count
    int digitsWritten = 0;                     ///< all that were given, those that say nothing too
    std::optional<geometry::DevicePoint> next; ///< the pixel whose answers tell the first candidates apart best
    double nextApart = 0.0;                    ///< how far apart those of the first two are there, units of the space
    std::size_t tried = 0;                     ///< mistakes and pairs, with all their variants
    /// More digits were given than single precision holds, and only within what that leaves open is the verdict found.
    bool isSinglePrecision = false;
    double chance = 0.0; ///< that a point without any such reason is explained as well as the first candidate does

    /// Whether the verdict is a mistake, or two of them.
    bool namesMistake() const { return verdict != "right" && verdict != "unknown" && verdict != "known-point"; }
    /// Whether `wrong` tells what is wrong. A point of the scene is not computed from the click; and a mistake whose digits are too
    /// few to tell the answer from the right one lands where that does.
    bool tellsWrong() const { return verdict != "known-point" && !(namesMistake() && wrong == ErrorKind::Right); }
    /// The candidates that cannot be told from the first one, at most three; none where the verdict is no mistake.
    std::vector<Candidate> alike() const;
    /// The best of those that can be; null where there is none.
    const Candidate *runnerUp() const;
    /// Whether `next` only tells the runner-up from the first candidate: those that are alike are so everywhere.
    bool isNextFromRunnerUp() const;
};

/// Digits beyond what double precision leaves of a click's answer count for nothing; where no verdict is found, those beyond single
/// precision do neither. No digit counts for more than the distance from the eye, as the 1 of 1e9 would.
/// @param given  at least one, of one program; one that is given several times counts once
/// @return the errors of check(setup), check(otherSize) and clipFromWorld; DepthOutsideRange; NotFinite (pixel, point);
///         SingularMatrix
geometry::Result<Diagnosis> diagnose(const Case &scene, std::span<const WrongPoint> given);

/// The ids of all mistakes, by the way of a click.
std::vector<std::string> mistakeIds();

} // namespace unprojector::doctor
