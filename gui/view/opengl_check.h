#pragma once

#include <QString>

class QOpenGLContext;

namespace unprojector::gui {

/// Checks, before a view exists, that views can be drawn: Qt's own views end the program without
/// OpenGL. Needs a QGuiApplication.
/// @return what is missing, and what to do; empty if nothing is
QString openGLProblem();

/// The same for a current context.
QString openGLProblem(QOpenGLContext &context);

#ifdef Q_OS_WIN
/// Returns whether a software OpenGL lies in the program's folder: Mesa's opengl32sw.dll. Qt uses
/// it automatically if Windows has only its own OpenGL 1.1, or if Qt::AA_UseSoftwareOpenGL is set.
bool hasSoftwareOpenGL();
#endif

} // namespace unprojector::gui
