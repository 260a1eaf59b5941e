#pragma once

#include <QColor>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>

#include <array>
#include <memory>

namespace unprojector::gui {

/// A vertical gradient over the viewport. It leaves the depth buffer as it is.
class BackgroundPainter : protected QOpenGLExtraFunctions {
public:
    void initialize();
    void release();
    /// @param colors  at the bottom and at the top
    void draw(const std::array<QColor, 2> &colors);

private:
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    QOpenGLVertexArrayObject m_vertexArray; ///< empty: the shader makes its three corners; core profile wants one
};

} // namespace unprojector::gui
