#pragma once

#include <QOpenGLFunctions>

namespace unprojector::gui {

/// Clears the errors of earlier calls, so that the next error belongs to later calls. A lost
/// context reports its loss for ever: the number of errors taken is bounded.
/// @return whether no error is left
inline bool clearErrors(QOpenGLFunctions &gl)
{
    constexpr int kMostErrors = 64; // OpenGL keeps one flag for each kind of error, and a driver has few of each
    for (int i = 0; i < kMostErrors; ++i) {
        if (gl.glGetError() == GL_NO_ERROR)
            return true;
    }
    return false;
}

} // namespace unprojector::gui
