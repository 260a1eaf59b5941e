#pragma once

#include "core/cli/terminal/exit_code.h"
#include "core/geometry/api_conventions.h"
#include "core/geometry/matrix_projection.h"
#include "core/matrices/pasted_matrix.h"

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {

/// `unproject scene`: makes a scene file from what another program prints of its matrices.
struct SceneOptions {
    std::vector<std::string> fromMatrices; ///< the numbers, or the name of one text file that has them, "-" for stdin
    std::optional<geometry::Api> conventions; ///< whose matrices they are; none: OpenGL's
    std::optional<matrices::NumberOrder>
        order; ///< how the sixteen numbers of a matrix follow each other; none: as written
    std::optional<geometry::NdcDepth> depth; ///< of the projection; none: as its numbers tell
    std::optional<bool> isYDown;             ///< NDC y, as Vulkan has it; none: up
    bool isReversed = false;                 ///< depths are 1 on the near plane
    bool isOrthonormal = false;              ///< the view's axes are made perpendicular and of length 1
    std::string window;                      ///< "WxH"; empty: as far as the viewport reaches
    std::string output = "-";                ///< a scene file, "-" for stdout
};

ExitCode runScene(const SceneOptions &options);

} // namespace unprojector::cli
