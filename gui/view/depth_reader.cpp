#include "gui/view/depth_reader.h"

#include <cmath>
#include <cstdint>

namespace unprojector::gui {

void DepthReader::initialize()
{
    initializeOpenGLFunctions();
}

void DepthReader::release()
{
    m_resolved.reset();
}

bool DepthReader::resolve(unsigned framebuffer, int column, int row)
{
    if (!m_resolved) {
        m_resolved =
            std::make_unique<QOpenGLFramebufferObject>(QSize(1, 1), QOpenGLFramebufferObject::CombinedDepthStencil);
        if (!m_resolved->isValid())
            return false;
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, m_resolved->handle());
    glBlitFramebuffer(column, row, column + 1, row + 1, 0, 0, 1, 1, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    return glGetError() == GL_NO_ERROR;
}

std::optional<DepthSample> DepthReader::read(unsigned framebuffer, const Surface &surface, const DevicePixel &pixel,
                                             double clearDepth)
{
    while (glGetError() != GL_NO_ERROR) {
    } // errors of others are not this read's

    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    GLint samples = 0, depthBits = 0, componentType = GL_UNSIGNED_NORMALIZED;
    glGetIntegerv(GL_SAMPLES, &samples);
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE,
                                          &depthBits);
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE,
                                          &componentType);

    int column = pixel.i;
    int row = framebufferRow(surface, pixel);
    if (samples > 0) {
        if (!resolve(framebuffer, column, row)) {
            glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
            return std::nullopt;
        }
        glBindFramebuffer(GL_FRAMEBUFFER, m_resolved->handle());
        column = row = 0;
    }

    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    DepthSample sample;
    sample.depthBits = depthBits > 0 ? depthBits : 24;
    if (componentType == GL_FLOAT) {
        GLfloat depth = 0.0f;
        glReadPixels(column, row, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
        sample.depth = depth;
        sample.depthBits = 24; // the digits of a float's fraction: its steps near 1, where depths crowd
    } else {
        GLuint depth = 0;
        glReadPixels(column, row, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &depth);
        const double steps = std::ldexp(1.0, sample.depthBits) - 1.0;
        sample.depth = std::round(depth / 4294967295.0 * steps) / steps;
    }
    const bool ok = glGetError() == GL_NO_ERROR;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    if (!ok)
        return std::nullopt;
    // The clear depth went through the same rounding; half a step tells it apart from a surface.
    sample.hit = std::abs(sample.depth - clearDepth) > 0.5 / (std::ldexp(1.0, sample.depthBits) - 1.0);
    return sample;
}

} // namespace unprojector::gui
