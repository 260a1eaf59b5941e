#include "gui/painters/frame_painter.h"

#include "gui/painters/shader.h"

namespace unprojector::gui {

void FramePainter::initialize()
{
    initializeOpenGLFunctions();
    // Two programs, because renderers on the processor would compute the smooth colours and throw them away.
    m_plain = loadProgram(QStringLiteral("frame"));
    m_smooth = loadProgram(QStringLiteral("frame"), QByteArrayLiteral("SMOOTH_EDGES"));
    m_vertexArray.create();
}

void FramePainter::release()
{
    m_plain.reset();
    m_smooth.reset();
    m_vertexArray.destroy();
}

void FramePainter::draw(unsigned colors, unsigned depths, int widthPixels, int heightPixels, bool smoothEdges)
{
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glViewport(0, 0, widthPixels, heightPixels);
    // Every depth is taken over; that takes a test which nothing fails, because without one no depth is written.
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glDepthMask(GL_TRUE);
    glDepthRangef(0.0f, 1.0f);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, depths);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, colors);
    QOpenGLShaderProgram &program = smoothEdges ? *m_smooth : *m_plain;
    program.bind();
    program.setUniformValue("colors", 0);
    program.setUniformValue("depths", 1);
    m_vertexArray.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    m_vertexArray.release();
    program.release();
    glBindTexture(GL_TEXTURE_2D, 0);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, 0);
    glActiveTexture(GL_TEXTURE0);
}

} // namespace unprojector::gui
