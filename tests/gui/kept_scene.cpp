#include "tests/gui/kept_scene.h"
#include "tests/support/patience.h"

#include "gui/document/scene_document.h"

#include "tests/gui/document_edits.h"

using namespace std::chrono_literals;
using namespace unprojector::gui;

namespace keeping {

void write(const QString &file, const QByteArray &text)
{
    QFile stream(file);
    if (!stream.open(QIODevice::WriteOnly) || stream.write(text) != text.size())
        qFatal("the test's folder cannot be written");
}

QByteArray read(const QString &file)
{
    QFile stream(file);
    return stream.open(QIODevice::ReadOnly) ? stream.readAll() : QByteArray();
}

Folder::Folder()
{
    QDir(path()).mkdir(QStringLiteral("models"));
    write(triangleFile(), kTriangle);
    write(sceneFile(), kScene);
}

std::filesystem::path pathOf(const QString &name)
{
    return std::filesystem::path(name.toStdU16String());
}

std::unique_ptr<MainWindow> windowKeepingIn(const QString &folder)
{
    MainWindow::Options options;
    options.smoothEdges = false;
    options.remembers = false;
    options.recoveryFolder = folder;
    options.autosave = {20ms, 200ms};
    return std::make_unique<MainWindow>(options);
}

bool openAndWait(MainWindow &window, const QString &file)
{
    window.session().openFiles({pathOf(file)});
    return QTest::qWaitFor([&window] { return !window.session().isLoading(); }, kPatienceMilliseconds);
}

void edit(MainWindow &window, double d)
{
    if (!editClipPlanes(window.document(), {{0.0, 1.0, 0.0, d}}, {}, {QStringLiteral("Plane")}))
        qFatal("the plane is refused");
}

QStringList keptIn(const QString &folder)
{
    return QDir(folder).entryList({QStringLiteral("*.recovery")}, QDir::Files);
}

bool becomesKept(const QString &folder, int count)
{
    return QTest::qWaitFor([&] { return keptIn(folder).size() == count; }, kPatienceMilliseconds);
}

} // namespace keeping
