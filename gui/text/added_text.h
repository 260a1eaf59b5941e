#pragma once

#include "core/scene/scene.h"

#include <QString>

#include <vector>

namespace unprojector::gui {

/// Explains how to see each object when one of the last is much larger or smaller than the rest, or
/// objects lie far apart; else empty.
/// @param added  number of the last objects that may not fit
QString sizesText(const std::vector<scene::SceneObject> &objects, std::size_t added);

/// A summary of what was added to a scene: "bunny.obj added: 69,451 triangles", and sizesText.
/// @param added  number of the last objects
/// @pre 0 < added <= objects.size()
QString addedText(const std::vector<scene::SceneObject> &objects, std::size_t added);

} // namespace unprojector::gui
