#pragma once

#include "core/scene/scene.h"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// The models and scenes that the program brings along. Flat models, the teapot's control points and
/// the tutorials' scenes are the files of resources/examples; rounded models are formulas.
namespace unprojector::examples {

/// The bundled models, by their names in scene files. The first call builds them, in any thread; all
/// scenes share them.
const std::map<std::string, std::shared_ptr<const mesh::Model>> &bundledModels();

/// The scene shown before a file is opened: a teapot, a cube whose faces differ in colour, a torus,
/// a ball and a cone. They stand side by side on the plane y = 0, y up, a few world units apart and
/// at clearly different depths. From about (6, 4.5, 9) towards (0, 1, 0) with a vertical field of
/// view of 45 degrees, all are in view and none hides another. A mesh with vertex colours has a
/// white base colour.
///
/// The meshes are rebuilt on every call, in milliseconds.
std::vector<scene::SceneObject> bundledScene();

/// The tutorials' scenes for the lessons, in the order of the tutorials. Each is valid, has visible
/// objects and the tutorial's literal parameters. Its numbers hold in a window of any size: the
/// projection does not follow the window. Where a view must stay square, the viewport adapts. Where
/// the tutorial follows a point of its own, that is the scene's point.
///
/// The three of projection-derivation share their objects, camera and viewport, so that switching
/// between them changes only the projection.
inline constexpr std::array<std::string_view, 12> kExamples{
    // Figures 2.3 to 2.5 in the plane z = 0. MC = [-1 0 4; 0 1 3; 0 0 1] is a mirror and a
    // translation. VC = [1 0 5; 0 -1 2; 0 0 1] is a mirror in the plane; in space it is a half turn
    // about x: the camera looks along +z with its up downwards.
    "zhangci-2d",
    "zhangci-model-view",       // figures 2.6 and 2.7; the program draws only the point (1, 1, 0)
    "zhangci-ortho",            // figure 2.10, with the side length that is assigned to the volume by mistake
    "zhangci-perspective",      // figure 2.12, with equal cubes at different distances
    "zhangci-viewport-50",      // section 2.3: the middle of the plate has the NDC (0, 0, 0.5)
    "zhangci-viewport-quarter", // the same
    // The sixteen numbers that ReSize writes into an array, in its window of 800 x 600.
    "derivation-matrix", "derivation-perspective",
    // left = -near tan(ViewAngleV / 2), bottom = -near tan(ViewAngleH / 2), ViewAngleH = 90 degrees,
    // tan(ViewAngleV / 2) = height / width. The two names are swapped: the horizontal angle is V.
    "derivation-frustum",
    // Figure 4.1: the start of a line, the world's origin, in a window of 300 x 300. The article does
    // not print its camera. With this camera a unit is a pixel.
    "opencascade-round-trip",
    "parallel-orthographic", // program 1; `const int SIZE = 4.5` is 4
    "parallel-oblique",      // program 2, as printed: the angle is 0.78, not pi / 4
};

/// The scene file of an example, as the program writes it. Its objects are bundled models.
/// @param id  one of kExamples; any other has no text
std::string_view exampleScene(std::string_view id);

} // namespace unprojector::examples
