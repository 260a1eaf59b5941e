#pragma once

#include <QString>

class QOpenGLContext;

namespace unprojector::gui {

/// Whether the views can be drawn here, asked before there is one: Qt's own views end the program where there is no
/// OpenGL. Needs a QGuiApplication.
/// @return what is missing, and what to do; empty where nothing is
QString openGLProblem();

/// As above, of a context that is current.
QString openGLProblem(QOpenGLContext &context);

#ifdef Q_OS_WIN
/// Whether an OpenGL that needs no graphics driver lies in the program's folder: Mesa's opengl32sw.dll. Qt takes it by
/// itself where Windows has nothing but its own OpenGL 1.1, and where Qt::AA_UseSoftwareOpenGL is set.
bool hasSoftwareOpenGL();
#endif

} // namespace unprojector::gui
