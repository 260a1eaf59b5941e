#pragma once

#include "core/cli/exit_code.h"
#include "core/matrix_format.h"

#include <string>

namespace unprojector {

enum class MatricesFormat { Text, Json, C, NumPy, Latex };

/// `unproject matrices`: all matrices of a scene.
struct MatricesOptions {
    std::string scene;
    MatrixLayout layout = MatrixLayout::Column;
    MatricesFormat format = MatricesFormat::Text;
};

ExitCode runMatrices(const MatricesOptions &options);

} // namespace unprojector
