#pragma once

#include "core/geometry/viewport.h"

class QPoint;

namespace unprojector::gui {

class SceneDocument;
class SceneView;

/// Opens the menu of what can be done with the pixel at a position: picked, copied, looked at; its object fitted, hidden.
/// @param global  where the menu opens
void showViewMenu(SceneView &view, SceneDocument &document, const geometry::WidgetPoint &position,
                  const QPoint &global);

} // namespace unprojector::gui
