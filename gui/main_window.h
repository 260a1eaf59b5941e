#pragma once

#include "core/pick.h"
#include "core/scene_file.h"
#include "gui/model_loader.h"

#include <QMainWindow>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class QGridLayout;
class QLabel;
class QSplitter;

namespace unprojector {

class ComparisonPanel;
class ExampleNote;
class FormulasWindow;
class LifecycleLog;
class LoadingBar;
class MessageBar;
class ObserverPanel;
class SceneDocument;
class SceneView;
class ViewportInspector;

/// The window: menus, tool bar, docks and status bar around one document and its view.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    struct Options {
        int samples = -1;        ///< of the view; -1: as the user chose in the menu
        bool remembers = true;   ///< layout, choices and recent files are read and kept
    };
    explicit MainWindow(const Options &options, QWidget *parent = nullptr);
    ~MainWindow() override;

    SceneDocument &document() { return *m_document; }
    SceneView &view() { return *m_view; }
    ComparisonPanel &comparison() { return *m_comparison; }
    LifecycleLog &lifecycle() { return *m_lifecycle; }

    /// Opens a scene file: its models are loaded first; if one of them cannot be, nothing changes and a message says why.
    void openScene(const std::filesystem::path &file);
    /// Writes the scene; a message says so when that fails, and the scene stays unsaved.
    /// @return whether it is on the disk
    bool saveScene(const std::filesystem::path &file);
    /// Opens model files, or the scene where there is a scene file (.json) among them; what could be opened replaces the scene, the rest is told in a message.
    void openFiles(std::vector<std::filesystem::path> files);
    void openBundledScene();
    /// Opens one of core's examples and says what to look at.
    void openExample(const std::string &id);
    /// Gives the view the whole window, or the panels back.
    void hidePanels(bool isHidden);
    bool isLoading() const { return m_loader->isLoading(); }
    /// The message that is on show, or nothing.
    QString message() const;

signals:
    /// A loading has ended, in whatever way.
    void loadingEnded();
    /// Files that could not be opened, in words.
    void openFailed(const QString &reason);

protected:
    void showEvent(QShowEvent *event) override;
    void closeEvent(QCloseEvent *event) override;

private:
    /// How many samples "smooth edges" means.
    static constexpr int kSmoothSamples = 4;

    void createCenter();
    void createView(int samples);
    void createDocks();
    void createStatusBar();
    /// The panels where they are at first, as many as fit beside the view.
    void arrangeDocks();
    void showObserver(bool isShown);
    void showFailure(const QString &reason);

    void createActions();
    void createFileMenu(QToolBar &bar);
    void createExamplesMenu(QMenu &menu);
    void createEditMenu();
    void createViewMenu(QToolBar &bar);
    void createHelpMenu();
    QAction *addAction(QMenu *menu, const QString &text, const QKeySequence &key, const QString &tip, std::function<void()> slot);

    void askForFiles();
    void save();
    void saveAs();
    /// Asks about unsaved changes of a scene that has a file.
    /// @return whether to go on
    bool mayLeaveScene();
    void takeScene(const std::vector<LoadedModel> &models);
    void setSceneFile(const std::filesystem::path &file, SceneFile contents);
    void takeLoaded(const std::vector<LoadedModel> &models, const std::vector<ImportError> &errors);
    void rememberRecent(const std::filesystem::path &file);
    void updateRecentMenu();
    void showHover(const WidgetPoint &position, const DepthSample &sample);
    void showCamera();
    void restoreLayout();
    void showAbout();
    void leaveExample();
    void showFormulas(const QString &anchor);
    void showControls();

    Options m_options;
    int m_samples = 0;
    bool m_isArranged = false; ///< by the user's last session, or for the size it is first shown with
    SceneDocument *m_document;
    ModelLoader *m_loader;
    LifecycleLog *m_lifecycle;
    SceneView *m_view = nullptr;
    ObserverPanel *m_observer = nullptr; ///< made when it is first asked for
    QSplitter *m_splitter = nullptr;
    QGridLayout *m_center = nullptr;
    MessageBar *m_message = nullptr;
    LoadingBar *m_loading = nullptr;
    ComparisonPanel *m_comparison = nullptr;
    ViewportInspector *m_inspector = nullptr;
    ExampleNote *m_exampleNote = nullptr;
    FormulasWindow *m_formulas = nullptr; ///< made when it is first asked for
    std::vector<QDockWidget *> m_docks;   ///< all but the example's, which is there only while an example is shown
    QDockWidget *m_exampleDock = nullptr;
    QDockWidget *m_parametersDock = nullptr;
    QDockWidget *m_comparisonDock = nullptr;
    QDockWidget *m_pipelineDock = nullptr;
    QDockWidget *m_inspectorDock = nullptr;
    QDockWidget *m_lifecycleDock = nullptr;
    QMenu *m_recentMenu = nullptr;
    std::filesystem::path m_scenePath; ///< where the scene was opened from or saved to; empty: nowhere
    SceneFile m_sceneFile;             ///< what that file held, for the keys that are not ours
    std::optional<std::pair<std::filesystem::path, SceneFile>> m_pendingScene; ///< its models are being loaded
    QAction *m_projectionAction = nullptr;
    QAction *m_hidesPanels = nullptr;
    QByteArray m_layoutWithPanels;
    QLabel *m_hover = nullptr;
    QLabel *m_camera = nullptr;
};

} // namespace unprojector
