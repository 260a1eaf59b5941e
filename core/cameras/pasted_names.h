#pragma once

#include "core/cameras/pasted_matrix.h"

#include <optional>
#include <string_view>

namespace unprojector::cameras {

/// What a name tells about the numbers behind it.
struct NamedPart {
    std::optional<PastedPart> part{};
    bool isInverse = false; ///< the name is of the part's inverse: "projectionMatrixInverse", "cameraToWorld"
    bool isAside = false;   ///< the numbers, which people paste beside matrices, belong to none: "near"
    bool isWidth = false, isHeight = false; ///< of an image; both: "size"
};

/// The part that names tell: "gl_ModelViewMatrix", "model view", "P*V". The last name of a path
/// counts, if it tells one: "cam.viewProjection" is a product.
NamedPart namedBy(std::string_view names);

} // namespace unprojector::cameras
