#include "gui/view/opengl_check.h"

#include "gui/view/frame_view.h"

#include <QCoreApplication>
#include <QFile>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>

namespace unprojector::gui {
namespace {

struct OpenGLCheck {
    Q_DECLARE_TR_FUNCTIONS(OpenGLCheck)
};

QString remedy()
{
#ifdef Q_OS_WIN
    return hasSoftwareOpenGL()
               ? OpenGLCheck::tr("Update the graphics driver. The opengl32sw.dll in the program's folder does not "
                                 "help; replace it with a newer one from Mesa.")
               : OpenGLCheck::tr("Update the graphics driver. On a remote desktop or in a virtual machine, put Mesa's "
                                 "opengl32sw.dll into the program's folder.");
#else
    return OpenGLCheck::tr("Install or update the graphics driver. Without a graphics card, install Mesa (Debian, "
                           "Ubuntu: libgl1-mesa-dri).");
#endif
}

QString noOpenGL()
{
    return OpenGLCheck::tr("OpenGL is missing; the view needs OpenGL 3.3. %1").arg(remedy());
}

} // namespace

QString openGLProblem()
{
    QOpenGLContext context;
    context.setFormat(FrameView::preCreateWindow());
    if (!context.create())
        return noOpenGL();
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    return context.makeCurrent(&surface) ? openGLProblem(context) : noOpenGL();
}

QString openGLProblem(QOpenGLContext &context)
{
    const QSurfaceFormat actual = context.format();
    const QSurfaceFormat needed = FrameView::preCreateWindow();
    if (actual.version() >= needed.version())
        return {};
    const auto *renderer = reinterpret_cast<const char *>(context.functions()->glGetString(GL_RENDERER));
    return OpenGLCheck::tr("This computer has OpenGL %1.%2 (%3); the view needs 3.3. %4")
        .arg(actual.majorVersion())
        .arg(actual.minorVersion())
        .arg(QString::fromLatin1(renderer), remedy());
}

#ifdef Q_OS_WIN
bool hasSoftwareOpenGL()
{
    return QFile::exists(QCoreApplication::applicationDirPath() + QStringLiteral("/opengl32sw.dll"));
}
#endif

} // namespace unprojector::gui
