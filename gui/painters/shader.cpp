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

std::unique_ptr<QOpenGLShaderProgram> linked(const QString &vertexName, const QString &fragmentName,
                                             const QByteArray &definition)
{
    const QString path = QStringLiteral(":/shaders/%1.%2");
    auto program = std::make_unique<QOpenGLShaderProgram>();
    program->addShaderFromSourceCode(QOpenGLShader::Vertex,
                                     source(path.arg(vertexName, QStringLiteral("vert")), definition));
    program->addShaderFromSourceCode(QOpenGLShader::Fragment,
                                     source(path.arg(fragmentName, QStringLiteral("frag")), definition));
    if (!program->link())
        qFatal("The shader %s does not build: %s", qPrintable(fragmentName), qPrintable(program->log()));
    return program;
}

} // namespace

std::unique_ptr<QOpenGLShaderProgram> loadProgram(const QString &name, const QByteArray &definition)
{
    return linked(name, name, definition);
}

std::unique_ptr<QOpenGLShaderProgram> loadPictureProgram(const QString &name)
{
    return linked(QStringLiteral("whole_picture"), name, {});
}

} // namespace unprojector::gui
