#pragma once

#include "core/scene_file/scene_file.h"

#include <string>

/// The scene as the source code of another program: the calls that make its picture, and the way back from a pixel.
namespace unprojector::scene_code {

enum class CodeDialect {
    Glu,     ///< C++, OpenGL 1.1 with GLU; a view of MFC with the paper's handlers, compiled only after <afxwin.h>
    Glm,     ///< C++, GLM in double precision
    Qt,      ///< C++, QMatrix4x4: single precision
    ThreeJs, ///< JavaScript, a module
    NumPy    ///< Python, a script: its matrices, the way there and, by formula and by inverse, back
};

/// Source code that makes the picture of a scene: window, viewport, depth range, projection, camera, each object's transform
/// and the clip planes, by the dialect's own calls where it has them and as matrices where the scene or the dialect asks for it.
/// Numbers read back to the same double (in Qt, to the nearest float).
///
/// Its screen2world(i, j, depth) gives the world coordinate of a pixel's centre: i and j count device pixels from the window's
/// top-left corner, so the window point is (i + 1/2, H - j - 1/2, (depth - dn) / (df - dn)), unprojected with the viewport's
/// origin and the camera alone. Where to read the depth (row H - 1 - j) is in the code.
///
/// What the code does not hold is said in its comments: the models, which it only names, and what the dialect has no word for.
/// They are English whatever language is set, as its names are: the code is the same for everybody.
/// @pre check(setupOf(scene))
/// @return UTF-8, lines ending in \n
std::string sceneCode(const scene_file::SceneFile &scene, CodeDialect dialect);

} // namespace unprojector::scene_code
