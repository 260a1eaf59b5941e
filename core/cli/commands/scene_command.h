#pragma once

#include "core/cli/terminal/exit_code.h"
#include "core/geometry/api_conventions.h"
#include "core/geometry/matrix_projection.h"
#include "core/matrices/pasted_matrix.h"

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {

/// `unproject scene`: makes a scene file from matrices printed by another program.
struct SceneOptions {
    std::vector<std::string> fromMatrices; ///< the numbers, or the name of one text file that has them, "-" for stdin
    std::optional<geometry::Api> conventions;   ///< conventions of the matrices; empty: OpenGL's
    std::optional<matrices::NumberOrder> order; ///< the order of a matrix's sixteen numbers; empty: as written
    std::optional<geometry::NdcDepth> depth;    ///< NDC depths of the projection; empty: as its numbers tell
    std::optional<bool> isYDown;                ///< NDC y points down, as in Vulkan; empty: up
    bool isReversed = false;                    ///< depths are 1 on the near plane
    bool isOrthonormal = false;                 ///< makes the view's axes perpendicular and of length 1
    std::string window;                         ///< "WxH"; empty: the viewport's extent
    std::string output = "-";                   ///< a scene file, "-" for stdout
};

ExitCode runScene(const SceneOptions &options);

} // namespace unprojector::cli
