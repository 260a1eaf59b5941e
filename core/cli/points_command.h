#pragma once

#include "core/cli/exit_code.h"
#include "core/cli/row_stream.h"

namespace unprojector::cli {

enum class Methods { Both, Formula, Matrix };

/// `unproject points`: device positions and depths in, points out.
struct PointsOptions {
    RowOptions rows;
    Methods methods = Methods::Both;
    bool isPixel = false; ///< px and py are indices of pixels: their centres are meant
};

/// The names of the columns written.
std::vector<std::string> pointColumns(Methods methods);

ExitCode runPoints(const PointsOptions &options);

} // namespace unprojector::cli
