#include "gui/view/painters/pick_painter.h"

#include "gui/view/painters/shader.h"

namespace unprojector::gui {
using namespace geometry;

void PickPainter::initialize()
{
    initializeOpenGLFunctions();
    m_program = loadProgram(QStringLiteral("pick"));
    m_vertexArray.create();
}

void PickPainter::release()
{
    m_program.reset();
    m_vertexArray.destroy();
}

void PickPainter::draw(const WorldPoint &point, const glm::dmat4 &clipFromWorld, const glm::vec2 &viewportPixels,
                       float pixelRatio, Mark mark)
{
    const glm::dvec4 clip = clipFromWorld * glm::dvec4(point.coordinates(), 1.0);
    if (!(clip.w > 0.0))
        return;
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_program->bind();
    m_program->setUniformValue("center", float(clip.x / clip.w), float(clip.y / clip.w));
    m_program->setUniformValue("viewportPixels", viewportPixels.x, viewportPixels.y);
    m_program->setUniformValue("pixelRatio", pixelRatio);
    m_program->setUniformValue("mark", static_cast<int>(mark));
    m_vertexArray.bind();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    m_vertexArray.release();
    m_program->release();
    glDisable(GL_BLEND);
}

} // namespace unprojector::gui
