#pragma once

#include "gui/document/autosave.h"
#include "gui/shell/main_window.h"

#include "tests/gui/gui_scene.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

/// Helpers that the tests of autosave and recovery share: a scene with a model in the test's own
/// folder, windows that keep unsaved changes there, and a change worth keeping.
namespace keeping {

/// A scene with a key of another program and a model by a relative name.
inline const QByteArray kScene = R"({"unprojector": 1, "window": {"width": 300, "height": 200},
    "projection": {"type": "ortho", "left": -3, "right": 3, "bottom": -2, "top": 2, "near": 1, "far": 9},
    "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]},
    "objects": [{"name": "t", "file": "models/triangle.obj", "transform": []}], "author": "somebody"})";
inline const QByteArray kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::filesystem::path pathOf(const QString &name);
void write(const QString &file, const QByteArray &text);
QByteArray read(const QString &file);

/// The folder of one test: scene.json, models/triangle.obj, and recovery/, once a recovery file is
/// written.
class Folder {
public:
    Folder();
    QString path() const { return m_folder.path(); }
    QString file(const QString &name) const { return m_folder.filePath(name); }
    QString sceneFile() const { return file(QStringLiteral("scene.json")); }
    QString triangleFile() const { return file(QStringLiteral("models/triangle.obj")); }
    QString recovery() const { return file(QStringLiteral("recovery")); }

private:
    QTemporaryDir m_folder;
};

/// A window that is not on the screen: nothing here needs the view. It asks nothing on closing.
std::unique_ptr<unprojector::gui::MainWindow> windowKeepingIn(const QString &folder);
bool openAndWait(unprojector::gui::MainWindow &window, const QString &file);
/// A clip plane at height `d`.
void edit(unprojector::gui::MainWindow &window, double d = 0.3333333333333333);
/// The recovery files in a folder.
QStringList keptIn(const QString &folder);
bool becomesKept(const QString &folder, int count = 1);

} // namespace keeping
