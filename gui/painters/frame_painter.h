#pragma once

#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>

#include <memory>

namespace unprojector::gui {

/// Puts a frame that was drawn before onto the framebuffer that is bound, pixel by pixel: its colours, with smooth edges
/// if wanted, and its depths, so that what is drawn next is hidden by the frame's surfaces. Smoothing goes by the colours
/// alone (FXAA); the depths are copied as they are. All calls need the OpenGL context current.
class FramePainter : protected QOpenGLExtraFunctions {
public:
    void initialize();
    void release();

    /// @param colors, depths  textures of one size, which is that of the framebuffer bound
    void draw(unsigned colors, unsigned depths, int widthPixels, int heightPixels, bool smoothEdges);

private:
    std::unique_ptr<QOpenGLShaderProgram> m_plain, m_smooth;
    QOpenGLVertexArrayObject m_vertexArray; ///< empty: the shader makes its three corners; core profile wants one
};

} // namespace unprojector::gui
