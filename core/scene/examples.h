#pragma once

#include "core/scene/scene.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <vector>

namespace unprojector::scene {

/// A worked example of one of the tutorials, with its literal parameters, as a scene to click in. Where the tutorial follows
/// a point of its own, that is the scene's given point.
struct Example {
    std::string id;       ///< "zhangci-ortho"; what it is called and what to look at is the window's wording
    std::string tutorial; ///< "zhangci", "projection-derivation", "opencascade" or "parallel-projection"
    Scene scene;
    /// The view's size that the tutorial's window had, logical pixels, where its numbers depend on it.
    std::optional<glm::ivec2> viewSize;
};

/// All examples in the order of the tutorials; those of one tutorial follow each other. Each is a valid scene with
/// something to see. Their numbers hold in a window of any size: the projections are the tutorials' own and do not
/// follow the window, and where a picture must stay square it is the viewport that does.
///
/// The three of projection-derivation share their objects, camera and viewport, so that switching between them changes
/// nothing but the projection.
///
/// The meshes are built anew on every call.
std::vector<Example> examples();

} // namespace unprojector::scene
