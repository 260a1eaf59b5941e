#pragma once

#include <QOpenGLBuffer>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <memory>
#include <vector>

namespace unprojector::gui {

/// A flat four-cornered face with one colour (red, green, blue, opacity; 0 to 1), its corners in
/// order around it.
struct Face {
    std::array<glm::dvec3, 4> corners;
    glm::vec4 color;
};

/// Unlit, translucent faces, blended in the order given. All calls need the OpenGL context current.
class FacePainter : protected QOpenGLExtraFunctions {
public:
    void initialize();
    void release();

    /// @param clipFromSource  from the space of the corners; applied in double on the processor
    void draw(const std::vector<Face> &faces, const glm::dmat4 &clipFromSource);

private:
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    QOpenGLVertexArrayObject m_vertexArray;
    QOpenGLBuffer m_buffer{QOpenGLBuffer::VertexBuffer};
};

} // namespace unprojector::gui
