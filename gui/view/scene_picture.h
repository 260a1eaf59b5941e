#pragma once

#include "core/geometry/result.h"
#include "gui/view/picture_options.h"

#include <QImage>

namespace unprojector::gui {

class SceneView;

/// The view's scene as an image of another size, drawn as in the view. View and document stay
/// unchanged.
/// @pre the view is ready, and no side is larger than SceneView::largestPicture()
/// @return the errors of setupOf; an image without pixels if OpenGL has no memory for it
geometry::Result<QImage> scenePicture(SceneView &view, const PictureOptions &options);

} // namespace unprojector::gui
