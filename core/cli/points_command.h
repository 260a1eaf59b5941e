#pragma once

#include "core/cli/exit_code.h"
#include "core/cli/row_writer.h"

#include <string>

namespace unprojector {

enum class Methods { Both, Formula, Matrix };

/// `unproject points`: device positions and depths in, points out.
struct PointsOptions {
    std::string scene;
    std::string input = "-";     ///< a CSV file, "-" for stdin
    std::string space = "world"; ///< "eye", "world" or "object:NAME"
    Methods methods = Methods::Both;
    RowFormat format = RowFormat::Csv;
    bool isPixel = false; ///< px and py are indices of pixels: their centres are meant
    unsigned threads = 2;
};

ExitCode runPoints(const PointsOptions &options);

} // namespace unprojector
