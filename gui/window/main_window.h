#pragma once

#include "gui/document/session.h"

#include "core/unproject/pick.h"

#include <QKeySequence>
#include <QMainWindow>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QGridLayout;
class QLabel;
class QSplitter;

namespace unprojector::gui {
using namespace unproject;

class ComparisonPanel;
class ExampleNote;
class FormulasWindow;
class LifecycleLog;
class LoadingBar;
class MessageBar;
class ObserverPanel;
class ParametersPanel;
class RecoveryBar;
class SceneDocument;
class SceneView;
class ViewportInspector;
class WindowQuestions;

/// The window: a session's document in a view, with panels in docks, menus, tool bar and status bar around it.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    struct Options {
        std::optional<bool> smoothEdges = {}; ///< nothing: as the user chose in the menu
        bool remembers = true;                ///< layout, choices and recent files are read and kept
        /// Where unsaved changes are kept in case of a crash; empty: with the user's data if it `remembers`, else nowhere.
        QString recoveryFolder = {};
        AutosaveTiming autosave = {};
    };
    explicit MainWindow(const Options &options, QWidget *parent = nullptr);
    ~MainWindow() override;

    Session &session() { return *m_session; }
    SceneDocument &document() { return *m_document; }
    SceneView &view() { return *m_view; }
    ComparisonPanel &comparison() { return *m_comparison; }
    LifecycleLog &lifecycle() { return *m_lifecycle; }

    /// Gives the view the whole window, or the panels back.
    void hidePanels(bool isHidden);
    /// The message that is on show, or nothing.
    QString message() const;

signals:
    /// What could not be opened, saved or drawn, in words.
    void openFailed(const QString &reason);

protected:
    void showEvent(QShowEvent *event) override;
    void closeEvent(QCloseEvent *event) override;

private:
    /// How long the status bar tells what needs no answer.
    static constexpr int kNoticeMilliseconds = 12000;

    /// A panel of the window, one row of a table.
    struct Panel {
        enum class Shown { Always, InHighWindows, WithExample };
        const char *id; ///< by which layouts are kept
        QString title;
        std::function<QWidget *()> make;
        Qt::DockWidgetArea area;       ///< in a window that is wide enough; those of one area are tabs of one dock
        Qt::DockWidgetArea narrowArea; ///< where the window is too small for panels on both sides
        QKeySequence key;              ///< shows and hides it
        Shown shown;                   ///< at first
        QDockWidget *dock = nullptr;
    };

    std::vector<Panel> panelTable();
    void createCenter();
    void createView();
    void setSmoothEdges(bool smooth);
    void createDocks();
    void createStatusBar();
    void connectSession();
    /// The panels where they are at first, as many as fit beside the view.
    void arrangeDocks();
    void restoreLayout();
    void keepLayout() const;
    void showObserver(bool isShown);

    void createActions();
    void createFileMenu(QToolBar &bar);
    void createExamplesMenu(QMenu &menu);
    void createEditMenu();
    void createViewMenu(QToolBar &bar);
    void createPanelActions(QMenu &menu);
    void createHelpMenu();
    QAction *addAction(QMenu *menu, const QString &text, const QKeySequence &key, const QString &tip,
                       std::function<void()> slot);
    void updateRecentMenu();
    std::vector<std::filesystem::path> askForModels(const QString &title, const QString &filter);

    void showName();
    void showOpened(const QString &example);
    void showFailure(const QString &reason);
    void showHover(const WidgetPoint &position, const DepthSample &sample);
    void showCamera();
    void showFormulas(const QString &anchor);
    void showControls();
    void showAbout();

    Options m_options;
    bool m_smoothEdges = true;
    bool m_isArranged = false; ///< by the user's last session, or for the size it is first shown with
    SceneDocument *m_document;
    std::unique_ptr<WindowQuestions> m_questions;
    Session *m_session;
    LifecycleLog *m_lifecycle;
    SceneView *m_view = nullptr;
    ObserverPanel *m_observer = nullptr; ///< made when it is first asked for
    QSplitter *m_splitter = nullptr;
    QGridLayout *m_center = nullptr;
    QWidget *m_topBars = nullptr;
    RecoveryBar *m_recovery = nullptr;
    MessageBar *m_message = nullptr;
    LoadingBar *m_loading = nullptr;
    std::vector<Panel> m_panels;
    ComparisonPanel *m_comparison = nullptr;
    ParametersPanel *m_parameters = nullptr;
    ViewportInspector *m_inspector = nullptr;
    ExampleNote *m_exampleNote = nullptr;
    QDockWidget *m_exampleDock = nullptr;
    FormulasWindow *m_formulas = nullptr; ///< made when it is first asked for
    QMenu *m_recentMenu = nullptr;
    QAction *m_projectionAction = nullptr;
    QAction *m_hidesPanels = nullptr;
    QByteArray m_layoutWithPanels;
    QLabel *m_hover = nullptr;
    QLabel *m_camera = nullptr;
};

} // namespace unprojector::gui
