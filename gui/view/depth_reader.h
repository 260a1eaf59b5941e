#pragma once

#include "core/unproject/pick.h"

#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>

#include <memory>
#include <optional>

namespace unprojector::gui {
using namespace unproject;

/// Reads the depth of one pixel of a framebuffer. All calls need the OpenGL context current.
class DepthReader : protected QOpenGLExtraFunctions {
public:
    void initialize();
    void release();

    /// The depth at a pixel, resolved first where the framebuffer is multisampled, which glReadPixels refuses.
    /// Exact: fixed-point depths are read as integers, because a float cannot hold every step of 24 bits.
    /// @param framebuffer  the one to read; `surface` its size
    /// @param clearDepth   what the background was cleared to
    /// @return nothing when OpenGL reports an error
    std::optional<DepthSample> read(unsigned framebuffer, const Surface &surface, const DevicePixel &pixel,
                                    double clearDepth);

private:
    bool resolve(unsigned framebuffer, int column, int row);

    std::unique_ptr<QOpenGLFramebufferObject> m_resolved; ///< one pixel
};

} // namespace unprojector::gui
