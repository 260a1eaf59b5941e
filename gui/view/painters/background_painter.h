#pragma once

#include <QColor>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>

#include <array>
#include <memory>

namespace unprojector::gui {

/// A vertical gradient over the viewport. It doesn't change the depth buffer.
class BackgroundPainter : protected QOpenGLExtraFunctions {
public:
    void initialize();
    void release();
    /// @param colors  at the bottom and at the top
    void draw(const std::array<QColor, 2> &colors);

private:
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    /// empty: the shader makes its three corners; the core profile requires one
    QOpenGLVertexArrayObject m_vertexArray;
};

} // namespace unprojector::gui
