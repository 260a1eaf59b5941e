#pragma once

#include <QByteArrayList>
#include <QOpenGLShaderProgram>

#include <memory>

namespace unprojector::gui {

/// Compiles and links :/shaders/NAME.vert and :/shaders/NAME.frag, with the version line in front.
/// A shader that does not build is a bug: it ends the program with the log.
/// @param definitions  names for `#ifdef`
std::unique_ptr<QOpenGLShaderProgram> loadProgram(const QString &name, const QByteArrayList &definitions = {});

/// Builds a program with NAME.frag that runs for every pixel: drawn as one triangle, three vertices
/// without attributes. Otherwise as loadProgram().
std::unique_ptr<QOpenGLShaderProgram> loadPictureProgram(const QString &name);

} // namespace unprojector::gui
