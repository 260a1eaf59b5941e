#pragma once

#include "core/cli/exit_code.h"
#include "core/matrices/matrix_format.h"

#include <string>
#include <vector>

namespace unprojector::cli {
using namespace matrices;

/// `unproject scene`: makes a scene file from what another program prints of its matrices.
struct SceneOptions {
    std::vector<std::string> fromMatrices; ///< the numbers, or the name of one text file that has them, "-" for stdin
    bool isRowByRow = false;               ///< how the sixteen numbers of a matrix follow each other
    std::string window;                    ///< "WxH"; empty: as far as the viewport reaches
    std::string output = "-";              ///< a scene file, "-" for stdout
};

ExitCode runScene(const SceneOptions &options);

} // namespace unprojector::cli
