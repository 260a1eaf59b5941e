#pragma once

#include "core/cli/terminal/exit_code.h"
#include "core/geometry/api_conventions.h"
#include "core/matrices/matrix_format.h"

#include <optional>
#include <string>

namespace unprojector::cli {

enum class MatricesFormat { Text, Json, C, NumPy, Latex };

/// `unproject matrices`: prints all matrices of a scene.
struct MatricesOptions {
    std::string scene;
    std::optional<geometry::Api> conventions;     ///< empty: the scene's
    std::optional<matrices::MatrixLayout> layout; ///< empty: the conventions' own
    MatricesFormat format = MatricesFormat::Text;
};

ExitCode runMatrices(const MatricesOptions &options);

} // namespace unprojector::cli
