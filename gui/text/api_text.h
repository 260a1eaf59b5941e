#pragma once

#include "core/geometry/api_conventions.h"

#include <QString>

namespace unprojector::gui {

/// The differences of an API from OpenGL; for OpenGL, its conventions.
QString apiText(geometry::Api api);

/// OpenCV's camera matrix in one line: "K = [724.26 0 499.5; 0 724.26 359.5; 0 0 1]".
QString intrinsicsText(const glm::dmat3 &intrinsics);

} // namespace unprojector::gui
