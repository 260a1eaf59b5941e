#pragma once

#include <QtGui/qopengl.h>

namespace unprojector::gui {

/// The attribute locations of the mesh shader, as in mesh.vert.
struct MeshAttribute {
    static constexpr GLuint Position = 0;
    static constexpr GLuint Normal = 1;
    static constexpr GLuint Color = 2;
    static constexpr GLuint Texcoord = 3;
    static constexpr GLuint Curvature = 4;
};

} // namespace unprojector::gui
