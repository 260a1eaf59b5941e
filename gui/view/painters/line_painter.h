#pragma once

#include <QOpenGLBuffer>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <memory>
#include <vector>

namespace unprojector::gui {

/// A straight line with one colour (red, green, blue, opacity; 0 to 1).
struct LineSegment {
    glm::dvec3 from;
    glm::dvec3 to;
    glm::vec4 color;
};

/// Lines of any width with smooth edges. OpenGL 3.3 core may not draw lines wider than one pixel,
/// so each becomes two triangles. All calls need the OpenGL context current.
class LinePainter : protected QOpenGLExtraFunctions {
public:
    void initialize();
    void release();

    /// @param clipFromSource  from the space of the segments; applied in double on the processor
    /// @param viewportPixels  width and height of the current viewport
    /// @param widthPixels     of the lines, device pixels
    void draw(const std::vector<LineSegment> &segments, const glm::dmat4 &clipFromSource,
              const glm::vec2 &viewportPixels, float widthPixels);

private:
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    QOpenGLVertexArrayObject m_vertexArray;
    QOpenGLBuffer m_buffer{QOpenGLBuffer::VertexBuffer};
};

} // namespace unprojector::gui
