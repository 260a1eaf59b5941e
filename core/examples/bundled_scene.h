#pragma once

#include "core/scene/scene.h"

#include <vector>

namespace unprojector::examples {

/// The scene shown before a file is opened: a teapot, a cube whose faces differ in colour, a torus,
/// a ball and a cone. They stand side by side on the plane y = 0, y up, a few world units apart and
/// at clearly different depths. From about (6, 4.5, 9) towards (0, 1, 0) with a vertical field of
/// view of 45 degrees, all are in view and none hides another. Colours are sRGB bytes or fractions;
/// a mesh with vertex colours has a white base colour.
///
/// The meshes are rebuilt on every call, in milliseconds.
std::vector<scene::SceneObject> bundledScene();

} // namespace unprojector::examples
