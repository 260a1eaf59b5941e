#include "gui/painters/shader.h"

#include <QFile>

namespace unprojector::gui {
namespace {

QByteArray source(const QString &path, const QByteArray &definition)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("The shader %s is missing from the program's resources.", qPrintable(path));
    const QByteArray defined = definition.isEmpty() ? QByteArray() : "#define " + definition + "\n";
    return "#version 330 core\n" + defined + file.readAll();
}

} // namespace

std::unique_ptr<QOpenGLShaderProgram> loadProgram(const QString &name, const QByteArray &definition)
{
    auto program = std::make_unique<QOpenGLShaderProgram>();
    const QString base = QStringLiteral(":/shaders/") + name;
    program->addShaderFromSourceCode(QOpenGLShader::Vertex, source(base + QStringLiteral(".vert"), definition));
    program->addShaderFromSourceCode(QOpenGLShader::Fragment, source(base + QStringLiteral(".frag"), definition));
    if (!program->link())
        qFatal("The shader %s does not build: %s", qPrintable(name), qPrintable(program->log()));
    return program;
}

} // namespace unprojector::gui
