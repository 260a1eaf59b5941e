#pragma once

#include "core/cli/terminal/exit_code.h"

#include <string>

namespace unprojector::cli {

/// `unproject compare`: measures the error of both methods over a grid of pixels and depths.
struct CompareOptions {
    std::string scene;
    bool isJson = false;
    int pixels = 32; ///< across and down
    int depths = 17; ///< from one end of the depth range to the other
};

ExitCode runCompare(const CompareOptions &options);

} // namespace unprojector::cli
