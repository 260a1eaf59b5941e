#pragma once

#include "core/cameras/foreign_camera.h"
#include "core/geometry/box.h"
#include "core/geometry/precise_matrix.h"
#include "core/geometry/result.h"
#include "core/geometry/setup.h"
#include "core/geometry/spaces.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Finds the mistake behind a wrong coordinate. Every mistake is a function from the wrong
/// program's input to its answer. All mistakes and all pairs of them are tried, and ranked by the
/// distance of their answers from the given point.
namespace unprojector::doctor {

/// The space of a program's point, as the program states it.
enum class PointSpace { World, Eye, Object };

/// A model of the scene, for programs that wrongly keep or omit its matrix.
struct PlacedModel {
    std::string name;
    geometry::PreciseMatrix worldFromObject;
};

/// A point of the scene that a program returns independently of the click.
struct KnownPoint {
    enum class Kind {
        Eye,
        ViewTranslation, ///< the view matrix's last column, taken for a point
        CameraCentre,    ///< the center of gluLookAt
        WorldOrigin,
        ObjectOrigin,
        Vertex
    };
    Kind kind = Kind::Eye;
    glm::dvec3 point{0.0};  ///< from Case::verticesIn in world space; in a diagnosis in the points' space
    std::string object;     ///< for an object's origin and a vertex: the object's name
    std::size_t vertex = 0; ///< vertex number in the file, see Model::vertexNumber
};

/// The scene and the setup of the wrong program.
struct Case {
    geometry::Setup setup;
    std::vector<PlacedModel> models; ///< models with which the mistakes of the model matrix are tried
    /// Another size that the program may still use: a former size of the window, or another
    /// framebuffer's.
    std::optional<geometry::Surface> otherSize;
    /// The point of the surface on the ray of a position, world space; no value on the background.
    /// Null if the scene has no mesh.
    std::function<std::optional<geometry::WorldPoint>(const geometry::DevicePoint &)> pointOnMesh;
    /// The meshes' vertices in a box of world space, or a few of them where there are many. Null if
    /// the scene has no mesh.
    std::function<std::vector<KnownPoint>(const geometry::Box &)> verticesIn;
    /// The distortion of the pixels, of a perspective. K's centre and focal lengths are the
    /// setup's.
    std::optional<cameras::Distortion> distortion{};
};

/// A program's answer, as the user gave it.
struct WrongPoint {
    geometry::DevicePoint pixel; ///< continuous device pixels from the framebuffer's top-left corner
    std::optional<double> depth; ///< the right depth, in the setup's depth range
    glm::dvec3 got{0.0};         ///< the wrong coordinate
    glm::dvec3 lastDigit{1e-4};  ///< > 0: for each coordinate, the unit of its last given digit
    PointSpace space = PointSpace::World;
    std::size_t model = 0;       ///< index in Case::models, for object space
    double depthLastDigit = 0.0; ///< the unit of the depth's last digit; 0: the depth is exact
};

/// The variant of a mistake that has several.
struct VariantName {
    const char *words = nullptr; ///< marked for base::tr: "ratio %1"; null: the first value alone
    std::vector<std::string> values{};
    const char *sentence = nullptr; ///< marked, of the same values: "Your program scales the depth by %1."

    VariantName() = default;
    VariantName(const char *marked, std::vector<std::string> ofIt = {}, const char *asSentence = nullptr)
        : words(marked), values(std::move(ofIt)), sentence(asSentence)
    {
    }
    bool isEmpty() const { return words == nullptr && values.empty(); } ///< the mistake has no other variant
};

/// A value that was solved for: {"far", {50}}, {"rotation", nine numbers by rows}, {"about", {},
/// "eye"}.
struct SolvedValue {
    std::string name; ///< key of the command's JSON
    std::vector<double> numbers{};
    std::string word{}; ///< instead of numbers
};

/// The extent to which a mistake cannot be distinguished from the first candidate.
enum class Alike {
    No,
    InDigits, ///< both explain all given digits; their answers differ in further digits
    Here,     ///< both give the same answer to these clicks, but not to others
    Always    ///< both give the same answer to every click in this scene
};

/// The first quantity in which two mistakes agree with each other but not with the right program.
enum class Shared { Window, Depth, Projection, View, Ndc, Matrix, Point };

/// The lack of several points that keeps values from being solved.
enum class Lack {
    OtherDepth, ///< all have one depth: near and far cannot be solved
    Plane       ///< they lie on a line: another frame cannot be solved
};

/// One or two mistakes, and their answer.
struct Candidate {
    std::string id;                  ///< "right", "y-not-flipped", …; for two "a+b"
    std::vector<VariantName> ways;   ///< of its mistakes that have several variants; see waysText
    std::vector<SolvedValue> values; ///< of a mistake with free values
    glm::dvec3 point{0.0};           ///< its answer to the first point, in that point's space
    double distance =
        0.0;        ///< the greatest difference of a coordinate, in units of its last digit; mean over the points
    int digits = 0; ///< number of significant digits that it explains, all coordinates of all points
    std::array<int, 3> digitsOfFirst{}; ///< the part of `digits` for each coordinate of the first point
    bool explains = false; ///< all significant digits of all points; the last ones may be truncated instead of rounded
    bool isCutOff = false; ///< explains, and some of the last digits are truncated
    Alike alike = Alike::No;
    std::optional<Shared> shared; ///< set if alike is Here or Always

    /// True if a value is a number. The axes of another world are a value without one.
    bool hasNumbers() const;
};

/// The error of the wrong point after projection with the right matrices; it classifies the
/// mistakes.
enum class ErrorKind {
    Right,
    Pixel,  ///< the depth is right, x' and y' are not: pixel, viewport or lens
    Depth,  ///< x' and y' are right, the depth is not
    Matrix, ///< neither is right
};

/// The source of the points' depths.
enum class DepthKnown {
    Given,
    FromMesh, ///< from the scene's mesh, where the ray hits it
    ByRay,    ///< unknown: answers are rays, and depth mistakes cannot be distinguished
};

/// The one point that a verdict does not hold for.
struct Except {
    std::size_t point = 0; ///< index among the given points
    geometry::DevicePoint pixel;
};

struct Diagnosis {
    /// A mistake's id; "right"; "known-point" if no mistake explains the points as well as a point
    /// of the scene does; "unknown" if nothing explains them, or anything might.
    std::string verdict;
    /// The points of the scene that equal the first point, if all points equal one; several may
    /// coincide. Contains a vertex only if that is the verdict. If the verdict is "unknown", the
    /// digits are too few to be sure.
    std::vector<KnownPoint> known;
    std::vector<Candidate> candidates; ///< the best first, each id once; at least five
    /// x', y' (device pixels from the top-left corner) and depth of the first wrong point, by the
    /// right matrices. Empty in the plane of the eye.
    std::optional<glm::dvec3> projected;
    double depthUnsure = 0.0; ///< change of that depth when the point moves within its last digits; 0: unknown
    ErrorKind wrong = ErrorKind::Right;
    DepthKnown depthKnown = DepthKnown::Given;
    /// The right answer to the first click, in its space, to a double's last digit: the mesh's
    /// point, or the point at the given depth. It does not depend on the wrong point. Empty if the
    /// depth is unknown.
    std::optional<glm::dvec3> right;
    /// The unit of the last digit of `right`, a power of ten. It follows from rounding and a given
    /// depth's last digit. It is at most as fine as seven digits of the greatest coordinate, or as
    /// the given digits if those are finer.
    double rightLastDigit = 1.0;
    int digitsGiven = 0;                       ///< maximum of Candidate::digits: the significant ones
    int digitsWritten = 0;                     ///< all given digits, including insignificant ones
    std::optional<geometry::DevicePoint> next; ///< the pixel whose answers distinguish the first candidates best
    double nextApart = 0.0;                    ///< distance of the first two answers there, units of the space
    std::size_t tried = 0;                     ///< number of mistakes and pairs, with all their variants
    /// True if more digits were given than single precision holds, and the verdict holds only
    /// within that precision.
    bool isSinglePrecision = false;
    /// The verdict and all else are those of the other points, at least two.
    std::optional<Except> except;
    /// The indices of two points of one click with different coordinates, if the verdict is "unknown".
    std::optional<std::array<std::size_t, 2>> contradiction;
    std::vector<Lack> lacking; ///< of several points, if the verdict is "unknown"
    double chance = 0.0;       ///< chance that an unrelated point is explained as well as by the first candidate

    /// The index of the point that `projected`, `right` and the like belong to.
    std::size_t firstPoint() const { return except && except->point == 0 ? 1 : 0; }
    /// True if the verdict is one mistake or two.
    bool namesMistake() const { return verdict != "right" && verdict != "unknown" && verdict != "known-point"; }
    /// True if `wrong` describes the error. A point of the scene is not computed from the click.
    /// And if the digits are too few, a mistake's answer looks like the right one.
    bool tellsWrong() const { return verdict != "known-point" && !(namesMistake() && wrong == ErrorKind::Right); }
    /// The candidates that cannot be distinguished from the first one, at most three; none if the
    /// verdict is no mistake.
    std::vector<Candidate> alike() const;
    /// The candidates that explain the points as well as the first one, at most three: alike(); or
    /// the others that explain them, if the verdict is "unknown".
    std::vector<Candidate> asWell() const;
    /// The best candidate that can be distinguished and is not among asWell(); null if there is none.
    const Candidate *runnerUp() const;
    /// True if `next` only distinguishes the runner-up from the first candidate, because the alike
    /// ones are alike everywhere.
    bool isNextFromRunnerUp() const;

private:
    /// True if a candidate after the first one explains the points as well.
    bool isAsGood(const Candidate &candidate) const;
};

/// Diagnoses wrong points. Digits beyond the double precision of a click's answer do not count. If
/// no verdict is found, digits beyond single precision do not count either. If there is still none,
/// one of at least three points may be left out, see Diagnosis::except. No digit counts if its
/// unit exceeds the distance from the eye, as the 1 of 1e9 would.
/// @param given  at least one point, all of one program; repetitions count once
/// @return the errors of check(setup), check(otherSize) and clipFromWorld; DepthOutsideRange;
///         NotFinite (pixel, point); SingularMatrix
geometry::Result<Diagnosis> diagnose(const Case &scene, std::span<const WrongPoint> given);

} // namespace unprojector::doctor
