#pragma once

#include "core/scene/scene.h"

#include <QString>

#include <vector>

namespace unprojector::gui {
using namespace scene;

/// What was added to a scene: "bunny.obj added: 69,451 triangles", and where one of it is much larger or smaller than the
/// rest, how each can be seen.
/// @param added  how many of the last objects
/// @pre 0 < added <= objects.size()
QString addedText(const std::vector<SceneObject> &objects, std::size_t added);

} // namespace unprojector::gui
