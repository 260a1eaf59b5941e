#include "gui/view/painters/background_painter.h"

#include "gui/view/painters/shader.h"

namespace unprojector::gui {

void BackgroundPainter::initialize()
{
    initializeOpenGLFunctions();
    m_program = loadProgram(QStringLiteral("background"));
    m_vertexArray.create();
}

void BackgroundPainter::release()
{
    m_program.reset();
    m_vertexArray.destroy();
}

void BackgroundPainter::draw(const std::array<QColor, 2> &colors)
{
    glDisable(GL_DEPTH_TEST);
    m_program->bind();
    m_program->setUniformValue("bottom", colors[0]);
    m_program->setUniformValue("top", colors[1]);
    m_vertexArray.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    m_vertexArray.release();
    m_program->release();
}

} // namespace unprojector::gui
