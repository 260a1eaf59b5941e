#pragma once

#include "core/cameras/foreign_camera.h"
#include "core/cameras/pasted_matrix.h"
#include "core/cli/terminal/exit_code.h"
#include "core/geometry/api_conventions.h"
#include "core/geometry/matrix_projection.h"

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {

/// `unproject scene`: makes a scene file from a camera of another program, or from its matrices.
struct SceneOptions {
    std::vector<std::string> from;         ///< files of a camera, recognised by their contents; or the text itself
    cameras::CameraChoices camera;         ///< without its size
    std::string size;                      ///< "WxH" of a camera's image; empty: the file's
    std::vector<std::string> objects;      ///< scenes and models: their objects are the scene's
    std::vector<std::string> fromMatrices; ///< the numbers, or the name of one text file that has them, "-" for stdin
    std::optional<geometry::Api> conventions;  ///< conventions of the matrices; empty: OpenGL's
    std::optional<cameras::NumberOrder> order; ///< the order of a matrix's sixteen numbers; empty: as written
    std::optional<geometry::NdcDepth> depth;   ///< NDC depths of the projection; empty: as its numbers tell
    std::optional<bool> isYDown;               ///< NDC y points down, as in Vulkan; empty: up
    bool isReversed = false;                   ///< depths are 1 on the near plane
    bool isOrthonormal = false;                ///< makes the view's axes perpendicular and of length 1
    std::string window;                        ///< "WxH"; empty: the viewport's extent
    std::string output = "-";                  ///< a scene file, "-" for stdout

    /// Returns whether an option is only about matrices: the text is then read as such.
    bool isAboutMatrices() const { return conventions || order || depth || isYDown || isReversed || isOrthonormal; }
};

/// Throws Refused.
ExitCode runScene(const SceneOptions &options);

} // namespace unprojector::cli
