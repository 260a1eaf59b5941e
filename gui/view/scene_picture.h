#pragma once

#include "core/geometry/result.h"
#include "gui/view/picture_options.h"

#include <QImage>

namespace unprojector::gui {

class SceneView;

/// The picture of a view's scene at another size, drawn as the view draws it. The view and the document stay as they are.
/// @pre the view is ready, and no side is larger than SceneView::largestPicture()
/// @return the errors of setupOf; an image without pixels where OpenGL has no memory for it
geometry::Result<QImage> scenePicture(SceneView &view, const PictureOptions &options);

} // namespace unprojector::gui
