#pragma once

#include "gui_scene.h"

#include "gui/window/workspaces.h"

#include <QAction>
#include <QDockWidget>
#include <QTest>

#include <memory>

/// What the tests of the whole window do with it.
namespace guitest {

inline QDockWidget *dockOf(const unprojector::gui::MainWindow &window, const char *name)
{
    return window.findChild<QDockWidget *>(QLatin1String(name));
}

/// The action with this text (without its mnemonic) in any menu.
inline QAction *actionOf(const unprojector::gui::MainWindow &window, const QString &text)
{
    for (QAction *action : window.findChildren<QAction *>()) {
        if (action->text().remove(u'&') == text && !action->associatedObjects().isEmpty())
            return action;
    }
    return nullptr;
}

/// With the bundled scene, its view ready.
/// @param size  where it remembers nothing; else it has the size that it was left with
inline std::unique_ptr<unprojector::gui::MainWindow> windowOfSize(const QSize &size, bool remembers = false)
{
    unprojector::gui::MainWindow::Options options;
    options.smoothEdges = false;
    options.remembers = remembers;
    auto window = std::make_unique<unprojector::gui::MainWindow>(options);
    if (!remembers)
        window->resize(size);
    window->session().openBundledScene();
    bringUp(*window);
    settle();
    return window;
}

/// On the screen, not behind another tab.
inline bool isSeen(unprojector::gui::MainWindow &window, const char *name)
{
    return window.workspaces().isFront(*dockOf(window, name));
}

/// Whether a text stands in the place of a panel, which would show the answer to a lesson's question.
inline bool isCovered(const unprojector::gui::MainWindow &window, const char *name)
{
    return dockOf(window, name)->widget()->objectName() == QLatin1String("cover");
}

} // namespace guitest
