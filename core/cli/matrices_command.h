#pragma once

#include "core/cli/exit_code.h"
#include "core/matrices/matrix_format.h"

#include <string>

namespace unprojector::cli {
using namespace matrices;

enum class MatricesFormat { Text, Json, C, NumPy, Latex };

/// `unproject matrices`: all matrices of a scene.
struct MatricesOptions {
    std::string scene;
    MatrixLayout layout = MatrixLayout::Column;
    MatricesFormat format = MatricesFormat::Text;
};

ExitCode runMatrices(const MatricesOptions &options);

} // namespace unprojector::cli
