#pragma once

#include "core/geometry/result.h"

#include <cstddef>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// Puts points that stand off the surface back onto it, where it is closest: of the object that each names, else of all that are
/// not hidden. One step of undo; missing points stay missing. Of a large model it takes a second.
/// @param indices  in SceneDocument::landmarks()
geometry::Check putOnSurface(SceneDocument &document, const std::vector<std::size_t> &indices);

} // namespace unprojector::gui
