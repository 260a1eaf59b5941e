#include "gui/view/painters/shader.h"

#include <QFile>

namespace unprojector::gui {
namespace {

QByteArray source(const QString &path, const QByteArrayList &definitions)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("The shader %s is missing from the program's resources.", qPrintable(path));
    QByteArray text("#version 330 core\n");
    for (const QByteArray &definition : definitions)
        text += "#define " + definition + "\n";
    return text + file.readAll();
}

std::unique_ptr<QOpenGLShaderProgram> linked(const QString &vertexName, const QString &fragmentName,
                                             const QByteArrayList &definitions)
{
    const QString path = QStringLiteral(":/shaders/%1.%2");
    auto program = std::make_unique<QOpenGLShaderProgram>();
    program->addShaderFromSourceCode(QOpenGLShader::Vertex,
                                     source(path.arg(vertexName, QStringLiteral("vert")), definitions));
    program->addShaderFromSourceCode(QOpenGLShader::Fragment,
                                     source(path.arg(fragmentName, QStringLiteral("frag")), definitions));
    if (!program->link())
        qFatal("The shader %s does not build: %s", qPrintable(fragmentName), qPrintable(program->log()));
    return program;
}

} // namespace

std::unique_ptr<QOpenGLShaderProgram> loadProgram(const QString &name, const QByteArrayList &definitions)
{
    return linked(name, name, definitions);
}

std::unique_ptr<QOpenGLShaderProgram> loadPictureProgram(const QString &name)
{
    return linked(QStringLiteral("whole_picture"), name, {});
}

} // namespace unprojector::gui
