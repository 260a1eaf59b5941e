#pragma once

#include <QOpenGLShaderProgram>

#include <memory>

namespace unprojector::gui {

/// Compiles and links :/shaders/NAME.vert and :/shaders/NAME.frag, with the version line in front. A shader of ours that does not build is our own mistake: it ends the program with the log.
std::unique_ptr<QOpenGLShaderProgram> loadProgram(const QString &name);

} // namespace unprojector::gui
