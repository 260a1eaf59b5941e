#pragma once

#include "core/geometry/viewport.h"

class QPoint;

namespace unprojector::gui {

class SceneDocument;
class SceneView;

/// Opens the context menu of the pixel at a position: pick it, copy it, look at it; fit or hide its
/// object.
/// @param global  the menu's position
void showViewMenu(SceneView &view, SceneDocument &document, const geometry::WidgetPoint &position,
                  const QPoint &global);

} // namespace unprojector::gui
