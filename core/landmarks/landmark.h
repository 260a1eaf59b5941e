#pragma once

#include "core/base/json.h"
#include "core/geometry/spaces.h"

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

// The anchor of a landmark on an object. Triangles are numbered from 0 through all meshes of the
// model, vertices from 0 as in the file.

/// No anchor: only the coordinates give the position.
struct Free {
    friend bool operator==(const Free &, const Free &) = default;
};
struct OnTriangle {
    std::uint32_t triangle = 0;
    glm::dvec3 barycentric{0.0}; ///< weights of its three corners; their sum is 1
    friend bool operator==(const OnTriangle &, const OnTriangle &) = default;
};
struct AtVertex {
    std::uint32_t vertex = 0;
    friend bool operator==(const AtVertex &, const AtVertex &) = default;
};
struct OnEdge {
    std::array<std::uint32_t, 2> vertices{};
    double share = 0.0; ///< position between the first and the second, in [0, 1]
    friend bool operator==(const OnEdge &, const OnEdge &) = default;
};
using Anchor = std::variant<Free, OnTriangle, AtVertex, OnEdge>;

/// Why a landmark has no position.
enum class Absence {
    NotPlaced, ///< not yet placed
    Skipped,   ///< the user passed over it; it is still to be placed
    Missing,   ///< the user marked it as missing on this specimen, as on a broken bone
};

/// A named point that the user placed on an object.
struct Landmark {
    std::string name;                          ///< UTF-8; may be empty, and need not be unique
    std::optional<geometry::WorldPoint> world; ///< empty: see `absence`
    Absence absence = Absence::NotPlaced;      ///< without a position; NotPlaced with one
    std::string object;                        ///< name of the object with the landmark; empty: none
    Anchor anchor;
    std::optional<geometry::WorldVector> uncertainty; ///< the largest error of each coordinate, if known
    std::string note;                                 ///< UTF-8
    std::optional<glm::u8vec3> color;                 ///< empty: the default colour
    bool isHidden = false;
    /// Data of a file that has no member here, kept for writing: null or an object.
    base::JsonValue extra;

    bool isPlaced() const { return world.has_value(); }
    /// Returns whether it still waits for a click: it has no position and is not marked as missing.
    bool isToPlace() const { return !world && absence != Absence::Missing; }
    bool isMissing() const { return !world && absence == Absence::Missing; }
    friend bool operator==(const Landmark &, const Landmark &) = default;
};

/// The axes of a file. 3D Slicer works in RAS (right, anterior, superior) and takes model files to
/// be in LPS (left, posterior, superior): x and y have the opposite sign.
enum class Axes { Lps, Ras };

/// The kind of a curve's path from each of its points to the next.
enum class CurveKind {
    Geodesic,     ///< like a thread pulled tight on the surface
    PlaneSection, ///< section of the surface by the plane through both points and the normals there
};

inline constexpr int kMostSemilandmarks = 1000; ///< of one curve

/// A line on the surface through landmarks, with a number of semilandmarks in equal steps.
struct Curve {
    std::string name;                ///< UTF-8
    std::vector<std::string> points; ///< the landmarks' names, in order; empty: only `semilandmarks` are known
    CurveKind kind = CurveKind::Geodesic;
    std::uint32_t count = 10; ///< number of semilandmarks, including those at both ends; at least 2
    /// The semilandmarks' positions, if computed: in data for files and from files.
    std::vector<geometry::WorldPoint> semilandmarks;
    base::JsonValue extra; ///< as in a landmark

    friend bool operator==(const Curve &, const Curve &) = default;
};

/// The kind of a kept measure.
enum class MeasureKind {
    Distance, ///< of two landmarks
    Angle,    ///< at the second of three landmarks, between the first and the third
    Height,   ///< of the fourth landmark over the plane of the first three
    Length,   ///< straight from landmark to landmark, of two or more
    Surface,  ///< along the surface through two or more, by geodesics
};

/// A measure of landmarks that the user named and keeps. A list of them is a protocol.
struct KeptMeasure {
    std::string name; ///< UTF-8; unique within a protocol
    MeasureKind kind = MeasureKind::Distance;
    std::vector<std::string> landmarks; ///< their names, in order

    friend bool operator==(const KeptMeasure &, const KeptMeasure &) = default;
};

inline constexpr int kMostPlacings = 99; ///< of one specimen

/// The landmarks of one specimen, in order.
///
/// Their coordinates are always in the axes of the mesh's own file, in any axes of the landmark
/// file. Coordinates read in RAS have x and y negated, and `axes` tells the writer to negate them
/// again.
struct LandmarkSet {
    std::string name; ///< name of the specimen, UTF-8; may be empty
    std::string mesh; ///< the file of the mesh, as written; may be empty
    std::string unit; ///< "mm"; empty: unknown
    Axes axes = Axes::Lps;
    std::vector<Landmark> landmarks;
    std::vector<Curve> curves;
    std::vector<KeptMeasure> measures; ///< the protocol; a scene has one, a landmark file has none
    int placing = 1;                   ///< from 1: which of the specimen's repeated placings
    base::JsonValue extra;             ///< as in a landmark

    friend bool operator==(const LandmarkSet &, const LandmarkSet &) = default;
};

} // namespace unprojector::landmarks
