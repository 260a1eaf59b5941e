#pragma once

#include "core/scene_file/scene_file.h"
#include "core/unproject/pick.h"
#include "gui/document/autosave.h"
#include "gui/document/model_loader.h"

#include <QMainWindow>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QGridLayout;
class QLabel;
class QSplitter;

namespace unprojector::gui {
using namespace scene_file;
using namespace unproject;

class ComparisonPanel;
class ExampleNote;
class FormulasWindow;
class LifecycleLog;
class LoadingBar;
class MessageBar;
class ObserverPanel;
class RecoveryBar;
class SceneDocument;
class SceneView;
class ViewportInspector;

/// The window: menus, tool bar, docks and status bar around one document and its view.
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
    /// Asks what to do with unsaved changes that an unexpected end has left, if there are any. Nothing waits for the answer.
    void offerRecovery();
    /// Whether leaving the scene would lose work: any change of a scene that has a file, and more than a look around in one
    /// that has none.
    bool hasUnsavedChanges() const;
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
    /// How long the status bar tells what needs no answer.
    static constexpr int kNoticeMilliseconds = 12000;

    void createCenter();
    void createView();
    void setSmoothEdges(bool smooth);
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
    QAction *addAction(QMenu *menu, const QString &text, const QKeySequence &key, const QString &tip,
                       std::function<void()> slot);

    /// A scene whose models are being loaded.
    struct PendingScene {
        std::filesystem::path path; ///< absolute; of a recovered scene it may be empty
        SceneFile contents;
        QString name;                      ///< for the title
        RecoveryFile *recovered = nullptr; ///< one of m_offered
    };

    void askForFiles();
    bool save();
    bool saveAs();
    /// Asks about unsaved changes.
    /// @return whether to go on
    bool mayLeaveScene();
    void load(PendingScene scene);
    void takeScene(const std::vector<LoadedModel> &models);
    /// The scene that was just opened has this file, or none, and this name in the title.
    void setSceneFile(const std::filesystem::path &file, SceneFile contents, const QString &name);
    void nameScene(const QString &name);
    /// What came as a matrix and was saved by its arguments, in a sentence; empty where nothing was.
    QString droppedMatrices(const SceneFile &written) const;
    void takeLoaded(const std::vector<LoadedModel> &models, const std::vector<ImportError> &errors);
    void createAutosave();
    /// The title's mark and the autosave go by whether there are unsaved changes.
    void followChanges();
    std::optional<Autosave::Content> unsavedContent() const;
    void showOffered();
    void recover(std::size_t place);
    void discardOffered(std::size_t place);
    /// The scene that was just opened is what that file kept.
    void takeRecovered(const RecoveryFile &file);
    std::unique_ptr<RecoveryFile> takeOffered(std::size_t place);
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
    bool m_smoothEdges = true;
    bool m_isArranged = false; ///< by the user's last session, or for the size it is first shown with
    SceneDocument *m_document;
    ModelLoader *m_loader;
    LifecycleLog *m_lifecycle;
    SceneView *m_view = nullptr;
    ObserverPanel *m_observer = nullptr; ///< made when it is first asked for
    QSplitter *m_splitter = nullptr;
    QGridLayout *m_center = nullptr;
    QWidget *m_topBars = nullptr;
    RecoveryBar *m_recovery = nullptr;
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
    std::filesystem::path m_scenePath; ///< absolute: where the scene was opened from or saved to; empty: nowhere
    SceneFile m_sceneFile; ///< what that file held when it was opened, for its matrices and the keys that are not ours
    QString m_sceneName;   ///< as in the title
    std::optional<PendingScene> m_pendingScene;
    Autosave *m_autosave = nullptr;                       ///< none where nothing is to be kept
    std::vector<std::unique_ptr<RecoveryFile>> m_offered; ///< by the recovery bar, in its order
    QAction *m_projectionAction = nullptr;
    QAction *m_hidesPanels = nullptr;
    QByteArray m_layoutWithPanels;
    QLabel *m_hover = nullptr;
    QLabel *m_camera = nullptr;
};

} // namespace unprojector::gui
