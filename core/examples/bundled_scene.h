#pragma once

#include "core/scene/scene.h"

#include <vector>

namespace unprojector::examples {

/// What the program shows before a file is opened: a teapot, a cube whose faces differ in colour, a torus, a ball and a
/// cone, side by side on the plane y = 0, y up, a few world units apart and at clearly different depths. Seen from
/// about (6, 4.5, 9) towards (0, 1, 0) with a vertical field of view of 45 degrees, all are in view and none hides
/// another. Colours are sRGB bytes or fractions; where a mesh has vertex colours its base colour is white.
///
/// The meshes are built anew on every call, in milliseconds.
std::vector<scene::SceneObject> bundledScene();

} // namespace unprojector::examples
