#pragma once

#include "gui/shell/preferences_dialog.h"
#include "gui/window/feature.h"

#include <QObject>

#include <vector>

class QMenu;
class QToolBar;

namespace unprojector::gui {

class KeySheet;
class MessageBar;
class SceneCodeWindow;
class Translation;
class Window;

/// The menus and the tool bar of the window: the window's own actions, and among them its features'
/// actions.
class WindowMenus : public QObject {
    Q_OBJECT
public:
    /// @param translation  for the menu of languages; null: no such menu. All arguments outlive the
    /// menus
    WindowMenus(Window &window, const std::vector<Feature *> &features, MessageBar &messages,
                const Translation *translation);

    /// Shrinks the drawings on the tool bar so that a narrow window has room for all of them.
    void fitToolBar();

signals:
    void smoothEdgesChosen(bool isSmooth);

private:
    QMenu *addMenu(const QString &title);
    void addFeatureActions(MenuKind kind, QMenu &menu);
    void addFileMenu();
    void addEditMenu();
    void addViewMenu();
    /// Adds Edit > Preferences…, once the menus have the choices that it shows.
    void addPreferences();
    void addLooks(QMenu &menu);
    void addSizeActions(QMenu &menu);
    void addAppearanceMenu(QMenu &menu);
    void addWorkspaceActions(QMenu &menu);
    void addHelpMenu();
    void updateRecentFiles();
    void showCode();
    void showPreferences();
    void showKeys();
    void showAbout();

    Window &m_window;
    const std::vector<Feature *> &m_features;
    MessageBar &m_messages;
    const Translation *m_translation;
    QToolBar *m_bar;
    QMenu *m_recent = nullptr;
    QMenu *m_edit = nullptr;
    PreferencesDialog::Choices m_choices;
    KeySheet *m_keys = nullptr;        ///< created on demand
    SceneCodeWindow *m_code = nullptr; ///< the same
};

} // namespace unprojector::gui
