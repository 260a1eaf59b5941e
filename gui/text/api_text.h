#pragma once

#include "core/geometry/api_conventions.h"

#include <QString>

namespace unprojector::gui {

/// What an API does otherwise than OpenGL; of OpenGL, what its conventions are.
QString apiText(geometry::Api api);

/// OpenCV's camera matrix as a line: "K = [724.26 0 499.5; 0 724.26 359.5; 0 0 1]".
QString intrinsicsText(const glm::dmat3 &intrinsics);

} // namespace unprojector::gui
