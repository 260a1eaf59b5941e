#pragma once

#include <QOpenGLFunctions>

namespace unprojector::gui {

/// Takes the errors that earlier calls have left, so that the next one is that of the calls in between. A lost context
/// reports its loss for ever: the number of errors taken is bounded.
/// @return whether no error is left
inline bool clearErrors(QOpenGLFunctions &gl)
{
    constexpr int kMostErrors = 64; // OpenGL keeps one flag a kind of error, and a driver has few of each
    for (int i = 0; i < kMostErrors; ++i) {
        if (gl.glGetError() == GL_NO_ERROR)
            return true;
    }
    return false;
}

} // namespace unprojector::gui
