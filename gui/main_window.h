#pragma once

#include "core/pick.h"
#include "gui/model_loader.h"

#include <QMainWindow>

#include <filesystem>
#include <vector>

class QActionGroup;
class QGridLayout;
class QLabel;

namespace unprojector {

class ComparisonPanel;
class LoadingBar;
class MessageBar;
class SceneDocument;
class SceneView;

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

    /// Opens model files; what could be opened replaces the scene, the rest is told in a message.
    void openFiles(std::vector<std::filesystem::path> files);
    void openBundledScene();
    bool isLoading() const { return m_loader->isLoading(); }
    /// The message that is on show, or nothing.
    QString message() const;

signals:
    /// A loading has ended, in whatever way.
    void loadingEnded();
    /// Files that could not be opened, in words.
    void openFailed(const QString &reason);

protected:
    void closeEvent(QCloseEvent *event) override;

private:
    void createView(int samples);
    void createActions();
    void createStatusBar();
    void askForFiles();
    void takeLoaded(const std::vector<LoadedModel> &models, const std::vector<ImportError> &errors);
    void rememberRecent(const std::filesystem::path &file);
    void updateRecentMenu();
    void showHover(const WidgetPoint &position, const DepthSample &sample);
    void showCamera();
    void restoreLayout();
    void showAbout();
    void showControls();

    Options m_options;
    SceneDocument *m_document;
    ModelLoader *m_loader;
    SceneView *m_view = nullptr;
    QGridLayout *m_center;
    MessageBar *m_message;
    LoadingBar *m_loading;
    ComparisonPanel *m_comparison;
    QMenu *m_recentMenu = nullptr;
    QAction *m_projectionAction = nullptr;
    QLabel *m_hover;
    QLabel *m_camera;
};

} // namespace unprojector
