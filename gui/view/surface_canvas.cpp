#include "gui/view/surface_canvas.h"

namespace unprojector::gui {
using namespace geometry;

bool SurfaceCanvas::begin()
{
    const QSize size(fixedSurface->widthPixels, fixedSurface->heightPixels);
    if (!m_pixels || m_pixels->size() != size) {
        m_pixels.reset(); // frees its memory first
        // The format of QOpenGLWidget's own framebuffer, so that depths can be copied there as they
        // are.
        m_pixels = std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::CombinedDepthStencil);
    }
    return m_pixels->isValid() && m_pixels->bind();
}

void SurfaceCanvas::show(unsigned widgetFramebuffer, const Surface &widget, const SurfacePlace &place,
                         const QColor &around)
{
    const QRect &shown = place.rectangle();
    const int bottom = widget.heightPixels - shown.bottom() - 1; // rows count from the bottom
    glBindFramebuffer(GL_FRAMEBUFFER, widgetFramebuffer);
    glViewport(0, 0, widget.widthPixels, widget.heightPixels);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(around.redF(), around.greenF(), around.blueF(), 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    // A line around it shows where the surface ends, even if its viewport leaves bars of the same
    // colour.
    glEnable(GL_SCISSOR_TEST);
    glScissor(shown.left() - 1, bottom - 1, shown.width() + 2, shown.height() + 2);
    glClearColor(0.5f, 0.5f, 0.5f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_pixels->handle());
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glBlitFramebuffer(0, 0, m_pixels->width(), m_pixels->height(), shown.left(), bottom, shown.left() + shown.width(),
                      bottom + shown.height(), GL_COLOR_BUFFER_BIT,
                      m_pixels->size() == shown.size() ? GL_NEAREST : GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, widgetFramebuffer);
}

} // namespace unprojector::gui
