#pragma once

#include <QByteArrayList>
#include <QOpenGLShaderProgram>

#include <memory>

namespace unprojector::gui {

/// Compiles and links :/shaders/NAME.vert and :/shaders/NAME.frag, with the version line in front. A shader of ours that
/// does not build is our own mistake: it ends the program with the log.
/// @param definitions  names for `#ifdef`
std::unique_ptr<QOpenGLShaderProgram> loadProgram(const QString &name, const QByteArrayList &definitions = {});

/// As loadProgram(), for a fragment shader alone that is run for every pixel of the picture: drawn as one triangle, three
/// vertices without attributes.
std::unique_ptr<QOpenGLShaderProgram> loadPictureProgram(const QString &name);

} // namespace unprojector::gui
