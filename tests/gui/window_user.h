#pragma once

#include "tests/gui/gui_scene.h"

#include "gui/window/workspaces.h"

#include <QAction>
#include <QDockWidget>
#include <QTest>

#include <memory>

/// Actions on the whole window that its tests share.
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

/// A window with the bundled scene and its view ready. @param size  its size if it restores no
/// settings; otherwise it has its last size
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

/// Returns whether the panel is on the screen and not behind another tab.
inline bool isSeen(unprojector::gui::MainWindow &window, const char *name)
{
    return window.workspaces().isFront(*dockOf(window, name));
}

/// Returns whether a text covers the panel, which would otherwise show the answer to a lesson's
/// question.
inline bool isCovered(const unprojector::gui::MainWindow &window, const char *name)
{
    return dockOf(window, name)->widget()->objectName() == QLatin1String("cover");
}

} // namespace guitest
