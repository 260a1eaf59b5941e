#include "gui/painters/shader.h"

#include <QFile>

namespace unprojector::gui {
namespace {

QByteArray source(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("The shader %s is missing from the program's resources.", qPrintable(path));
    return "#version 330 core\n" + file.readAll();
}

} // namespace

std::unique_ptr<QOpenGLShaderProgram> loadProgram(const QString &name)
{
    auto program = std::make_unique<QOpenGLShaderProgram>();
    const QString base = QStringLiteral(":/shaders/") + name;
    program->addShaderFromSourceCode(QOpenGLShader::Vertex, source(base + QStringLiteral(".vert")));
    program->addShaderFromSourceCode(QOpenGLShader::Fragment, source(base + QStringLiteral(".frag")));
    if (!program->link())
        qFatal("The shader %s does not build: %s", qPrintable(name), qPrintable(program->log()));
    return program;
}

} // namespace unprojector::gui
