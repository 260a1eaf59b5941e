#pragma once

#include "core/cli/rows/row_stream.h"
#include "core/cli/terminal/exit_code.h"
#include "core/unproject/answers.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {

/// `unproject points`: reads device positions and depths, writes points.
struct PointsOptions {
    RowOptions rows;
    std::vector<unproject::Method> methods{unproject::Method::Formula, unproject::Method::Matrix};
    bool isPixel = false;   ///< px and py are pixel indices and mean the pixels' centres
    std::string distortion; ///< coefficients or a file: px and py are of a distorted image; empty: of a pinhole's
};

/// The input columns of a click.
inline const ColumnNames kClickColumns{"px", "py", "depth"};
/// The names of the computed columns: three for each method, and "difference" if both the formulas
/// and the matrix are chosen.
std::vector<std::string> pointColumns(const std::vector<unproject::Method> &methods);

/// Writes the cells of a point by each method, and of the difference; empty where there is no
/// number.
/// @param points  in the order of `methods`; empty where a method has none
/// @return whether all existing points and their difference are finite
bool writePoints(RowWriter &writer, const std::vector<unproject::Method> &methods,
                 const std::vector<std::optional<glm::dvec3>> &points);

ExitCode runPoints(const PointsOptions &options);

} // namespace unprojector::cli
