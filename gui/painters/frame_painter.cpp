#include "gui/painters/frame_painter.h"

#include "gui/painters/shader.h"

namespace unprojector::gui {

void FramePainter::initialize()
{
    initializeOpenGLFunctions();
    m_program = loadProgram(QStringLiteral("frame"));
    m_vertexArray.create();
}

void FramePainter::release()
{
    m_program.reset();
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
    m_program->bind();
    m_program->setUniformValue("colors", 0);
    m_program->setUniformValue("depths", 1);
    m_program->setUniformValue("smoothEdges", smoothEdges);
    m_vertexArray.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    m_vertexArray.release();
    m_program->release();
    glBindTexture(GL_TEXTURE_2D, 0);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, 0);
    glActiveTexture(GL_TEXTURE0);
}

} // namespace unprojector::gui
