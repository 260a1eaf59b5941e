#pragma once

#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>

#include <memory>
#include <optional>

namespace unprojector::gui {

/// The textures of a drawn frame, all of one size, and the framebuffer that they belong to.
struct FrameTextures {
    unsigned framebuffer = 0;
    unsigned colors = 0, depths = 0;
    int widthPixels = 0, heightPixels = 0;
};

/// Copies a drawn frame pixel by pixel to the bound framebuffer of the same size: its colours,
/// smoothed if wanted, and its depths, so that the frame's surfaces hide what is drawn next.
/// Smoothing uses colours only (FXAA), once for each frame; depths are copied unchanged. All calls
/// need the OpenGL context current.
class FramePainter : protected QOpenGLExtraFunctions {
public:
    void initialize();
    void release();

    /// Invalidates the smoothed copy: the frame was drawn again.
    void setStale() { m_isSmoothed = false; }
    void draw(const FrameTextures &frame, bool smoothEdges);

    /// Returns whether smoothing is too slow for a moving view: it is on software renderers (some
    /// tens of milliseconds), but not on graphics cards. Known after the first frames; until then
    /// it counts as slow.
    bool isSmoothingSlow() const;

private:
    /// @return the texture with smooth edges, or the frame's own if OpenGL cannot create one
    unsigned smoothed(const FrameTextures &frame);
    bool copied(const FrameTextures &frame, bool isSmooth);
    void drawTriangle(QOpenGLShaderProgram &program);

    std::unique_ptr<QOpenGLShaderProgram> m_copying, m_smoothing;
    std::unique_ptr<QOpenGLFramebufferObject> m_smooth;
    bool m_isSmoothed = false;
    std::optional<bool> m_canCopy; ///< known after the first frame
    int m_measuredCount = 0;
    std::optional<double> m_smoothingMilliseconds; ///< of the fastest so far
    /// empty: the shader makes its three corners; the core profile requires one
    QOpenGLVertexArrayObject m_vertexArray;
};

} // namespace unprojector::gui
