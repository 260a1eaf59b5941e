#pragma once

#include "core/geometry/result.h"

#include <cstddef>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// Moves landmarks onto the closest point of the surface: of the object that each names, else of
/// all visible objects. One step of undo; those without a position stay so. A large model takes a
/// second.
/// @param indices  in SceneDocument::landmarks()
geometry::Check putOnSurface(SceneDocument &document, const std::vector<std::size_t> &indices);

} // namespace unprojector::gui
