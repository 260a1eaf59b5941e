#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace unprojector::landmark_files::csv {

/// All known columns, in the order in which they are written.
enum Column : std::size_t {
    Specimen,
    Placing,
    Name,
    X,
    Y,
    Z,
    Object,
    Face,
    U,
    V,
    W,
    Note,
    Vertex,
    EdgeFrom,
    EdgeTo,
    EdgeShare,
    Dx,
    Dy,
    Dz,
    Color,
    Hidden,
    AbsenceWord, ///< why there are no coordinates: empty, "skipped" or "missing"
    Mesh,
    Unit,
    CurveName, ///< name of the curve whose semilandmark the row is
    CurvePoints,
    CurveWay,
    CurveCount,
    Defined, ///< this and the rest: from 3D Slicer's tables, read only
    Visible,
    Selected,
    Locked
};
inline constexpr std::size_t kColumnCount = Locked + 1, kWrittenCount = CurveCount + 1;
inline constexpr std::array<const char *, kWrittenCount> kColumnNames{
    "specimen", "placing", "name",   "x",        "y",      "z",           "object",    "face",      "u",  "v",
    "w",        "note",    "vertex", "edgeFrom", "edgeTo", "edgeShare",   "dx",        "dy",        "dz", "color",
    "hidden",   "absence", "mesh",   "unit",     "curve",  "curvePoints", "curveKind", "curveCount"};
/// The column of a name, in any case; kWrittenCount if there is none.
std::size_t columnOf(std::string_view name);
inline constexpr std::array kCurveKinds{"geodesic", "planeSection"};
inline constexpr std::array kAbsences{"", "skipped", "missing"};

} // namespace unprojector::landmark_files::csv
