#pragma once

#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace unprojector::examples {

/// A scene of one of the tutorials, with its literal parameters, for the lessons. Where the
/// tutorial follows a point of its own, that is the scene's given point.
struct Example {
    std::string id; ///< "zhangci-ortho"
    scene::Scene scene;
};

/// All examples in the order of the tutorials. Each is a valid scene with visible objects, and can
/// be written to a file and read again. Their numbers hold in a window of any size: the projections
/// are the tutorials' own and do not follow the window. Where a view must stay square, the viewport
/// adapts.
///
/// The three of projection-derivation share their objects, camera and viewport, so that switching
/// between them changes only the projection.
///
/// The meshes are rebuilt on every call.
std::vector<Example> examples();

} // namespace unprojector::examples
