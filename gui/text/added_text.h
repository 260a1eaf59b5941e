#pragma once

#include "core/scene/scene.h"

#include <QString>

#include <vector>

namespace unprojector::gui {

/// How each object can be seen where one of the last is much larger or smaller than the rest, or they lie far apart; else
/// empty.
/// @param added  how many of the last objects may be what does not fit
QString sizesText(const std::vector<scene::SceneObject> &objects, std::size_t added);

/// What was added to a scene: "bunny.obj added: 69,451 triangles", and what sizesText says.
/// @param added  how many of the last objects
/// @pre 0 < added <= objects.size()
QString addedText(const std::vector<scene::SceneObject> &objects, std::size_t added);

} // namespace unprojector::gui
