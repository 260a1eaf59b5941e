#pragma once

#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>

#include <memory>
#include <optional>

namespace unprojector::gui {

/// What a frame was drawn as: textures of one size, and the framebuffer that they belong to.
struct FrameTextures {
    unsigned framebuffer = 0;
    unsigned colors = 0, depths = 0;
    int widthPixels = 0, heightPixels = 0;
};

/// Puts a frame that was drawn before onto the framebuffer that is bound and has its size, pixel by pixel: its colours,
/// with smooth edges if wanted, and its depths, so that what is drawn next is hidden by the frame's surfaces. Smoothing
/// goes by the colours alone (FXAA), once for each frame; the depths are copied as they are. All calls need the OpenGL
/// context current.
class FramePainter : protected QOpenGLExtraFunctions {
public:
    void initialize();
    void release();

    /// The frame has been drawn anew: what was smoothed was another one.
    void setStale() { m_isSmoothed = false; }
    void draw(const FrameTextures &frame, bool smoothEdges);

    /// Whether smoothing takes so long that a picture in motion had better do without: it does on renderers that use the
    /// processor (some tens of milliseconds), and does not on graphics cards. Known after the first pictures; until then
    /// it counts as slow.
    bool isSmoothingSlow() const;

private:
    /// @return the texture with smooth edges, or the frame's own where OpenGL gives none
    unsigned smoothed(const FrameTextures &frame);
    bool copied(const FrameTextures &frame, bool isSmooth);
    void drawTriangle(QOpenGLShaderProgram &program);

    std::unique_ptr<QOpenGLShaderProgram> m_copying, m_smoothing;
    std::unique_ptr<QOpenGLFramebufferObject> m_smooth;
    bool m_isSmoothed = false;
    std::optional<bool> m_canCopy; ///< known after the first picture
    int m_measuredCount = 0;
    std::optional<double> m_smoothingMilliseconds; ///< of the fastest so far
    QOpenGLVertexArrayObject m_vertexArray; ///< empty: the shader makes its three corners; core profile wants one
};

} // namespace unprojector::gui
