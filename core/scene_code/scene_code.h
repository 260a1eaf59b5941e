#pragma once

#include "core/scene_file/scene_file.h"

#include <string>

/// Exports a scene as the source code of another program: the calls that make its setup, and the
/// way back from a pixel.
namespace unprojector::scene_code {

enum class CodeDialect {
    Glu,     ///< C++, OpenGL 1.1 with GLU; a view of MFC with the paper's handlers, compiled only after <afxwin.h>
    Glm,     ///< C++, GLM in double precision
    Qt,      ///< C++, QMatrix4x4: single precision
    ThreeJs, ///< JavaScript, a module
    NumPy    ///< Python, a script: its matrices, the way there and, by formula and by inverse, back
};

/// Generates source code with the setup of a scene: window, viewport, depth range, projection,
/// camera, the transforms of the objects, and the clip planes. It uses the dialect's own calls if
/// they exist, else matrices; so too for matrices of the scene. Numbers read back to the same
/// double (in Qt, to the nearest float).
///
/// Its screen2world(i, j, depth) gives the world coordinate of a pixel's centre, where i and j
/// count device pixels from the window's top-left corner. The window point is (i + 1/2, H - j -
/// 1/2, (depth - dn) / (df - dn)), unprojected with the viewport's origin and the camera alone. The
/// code states where to read the depth (row H - 1 - j).
///
/// Comments in the code list what it leaves out: the models, which it only names, and features that
/// the dialect lacks. Comments and names are English in every language setting, so the code does
/// not depend on it.
/// @pre check(setupOf(scene))
/// @return UTF-8, lines ending in \n
std::string sceneCode(const scene_file::SceneFile &scene, CodeDialect dialect);

} // namespace unprojector::scene_code
