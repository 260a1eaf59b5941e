#include "gui/view/painters/frame_painter.h"

#include "gui/view/painters/gl_errors.h"
#include "gui/view/painters/shader.h"

#include <QElapsedTimer>

#include <algorithm>

namespace unprojector::gui {
namespace {

/// Copies into the bound framebuffer.
/// @param from  a framebuffer of the frame's size
void copyPixels(QOpenGLExtraFunctions &gl, unsigned from, const FrameTextures &frame, GLbitfield what)
{
    GLint boundBefore = 0;
    gl.glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &boundBefore);
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    gl.glReadBuffer(GL_COLOR_ATTACHMENT0);
    gl.glBlitFramebuffer(0, 0, frame.widthPixels, frame.heightPixels, 0, 0, frame.widthPixels, frame.heightPixels, what,
                         GL_NEAREST);
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(boundBefore));
}

} // namespace

void FramePainter::initialize()
{
    initializeOpenGLFunctions();
    m_canCopy.reset();
    m_vertexArray.create();
    m_measuredCount = 0;
    m_smoothingMilliseconds.reset();
}

void FramePainter::release()
{
    m_copying.reset();
    m_smoothing.reset();
    m_smooth.reset();
    m_isSmoothed = false;
    m_vertexArray.destroy();
}

bool FramePainter::isSmoothingSlow() const
{
    constexpr double kUnnoticedMilliseconds = 4.0;
    return !m_smoothingMilliseconds || *m_smoothingMilliseconds > kUnnoticedMilliseconds;
}

void FramePainter::drawTriangle(QOpenGLShaderProgram &program)
{
    m_vertexArray.bind();
    program.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    program.release();
    m_vertexArray.release();
}

unsigned FramePainter::smoothed(const FrameTextures &frame)
{
    const QSize size(frame.widthPixels, frame.heightPixels);
    if (m_isSmoothed && m_smooth && m_smooth->size() == size)
        return m_smooth->texture();
    GLint boundBefore = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &boundBefore);
    if (!m_smooth || m_smooth->size() != size) {
        m_smooth.reset(); // frees its memory first
        m_smooth = std::make_unique<QOpenGLFramebufferObject>(size);
    }
    m_isSmoothed = m_smooth->isValid() && m_smooth->bind();
    if (m_isSmoothed) {
        // Built on demand: that takes longer than all the other programs together.
        if (!m_smoothing)
            m_smoothing = loadPictureProgram(QStringLiteral("smooth_edges"));
        // Waits for the first frames to measure smoothing; a driver may still compile the program
        // during the very first.
        constexpr int kMeasured = 3;
        const bool isMeasured = m_measuredCount < kMeasured;
        QElapsedTimer timer;
        if (isMeasured)
            glFinish();
        timer.start();
        copyPixels(*this, frame.framebuffer, frame, GL_COLOR_BUFFER_BIT);
        glDisable(GL_DEPTH_TEST);
        glBindTexture(GL_TEXTURE_2D, frame.colors);
        drawTriangle(*m_smoothing);
        if (isMeasured) {
            glFinish();
            ++m_measuredCount;
            const double milliseconds = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
            m_smoothingMilliseconds = std::min(milliseconds, m_smoothingMilliseconds.value_or(milliseconds));
        }
    }
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(boundBefore));
    return m_isSmoothed ? m_smooth->texture() : frame.colors;
}

/// @return whether OpenGL copies between these framebuffers: it does not for different depth
/// formats
bool FramePainter::copied(const FrameTextures &frame, bool isSmooth)
{
    if (m_canCopy == false)
        return false;
    if (!m_canCopy)
        clearErrors(*this);
    // Includes the unused stencil: only complete copies are fast.
    constexpr GLbitfield kDepths = GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
    copyPixels(*this, frame.framebuffer, frame, isSmooth ? kDepths : kDepths | GL_COLOR_BUFFER_BIT);
    if (isSmooth)
        copyPixels(*this, m_smooth->handle(), frame, GL_COLOR_BUFFER_BIT);
    if (!m_canCopy)
        m_canCopy = glGetError() == GL_NO_ERROR;
    return *m_canCopy;
}

void FramePainter::draw(const FrameTextures &frame, bool smoothEdges)
{
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glViewport(0, 0, frame.widthPixels, frame.heightPixels);
    glActiveTexture(GL_TEXTURE0);
    const unsigned colors = smoothEdges ? smoothed(frame) : frame.colors;
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthRangef(0.0f, 1.0f);
    // This takes a tenth of the time of a per-pixel program on software renderers.
    if (copied(frame, colors != frame.colors))
        return;
    if (!m_copying)
        m_copying = loadPictureProgram(QStringLiteral("frame"));
    // The depth test always passes: without a test no depth is written.
    glDepthFunc(GL_ALWAYS);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, frame.depths);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, colors);
    m_copying->bind();
    m_copying->setUniformValue("colors", 0);
    m_copying->setUniformValue("depths", 1);
    drawTriangle(*m_copying);
    glBindTexture(GL_TEXTURE_2D, 0);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, 0);
    glActiveTexture(GL_TEXTURE0);
}

} // namespace unprojector::gui
