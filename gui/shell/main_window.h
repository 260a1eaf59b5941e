#pragma once

#include "gui/document/session.h"
#include "gui/window/window.h"

#include <memory>
#include <optional>
#include <vector>

namespace unprojector::gui {

class Feature;
class LoadingBar;
class MessageBar;
class RecoveryBar;
class ScanList;
class Translation;
class WindowMenus;
class WindowQuestions;

/// The window: a session's document in a view, with the panels and actions of its features around
/// it. It knows the features only by their common interface: each is implemented in its own folder,
/// see makeFeatures.
class MainWindow : public Window {
    Q_OBJECT
public:
    struct Options {
        std::optional<bool> smoothEdges = {}; ///< nothing: the user's choice in the menu
        bool remembers = true;                ///< layout, choices and recent files are read and saved
        /// Folder of recovery files; empty: the user's data folder if it `remembers`, else none.
        QString recoveryFolder = {};
        AutosaveTiming autosave = {};
        /// Needed for the menu of languages; null: no such menu. Outlives the window.
        const Translation *translation = nullptr;
    };
    explicit MainWindow(const Options &options, QWidget *parent = nullptr);
    ~MainWindow() override;

    SceneDocument &document() override { return *m_document; }
    Session &session() override { return *m_session; }
    SceneView &view() override { return *m_view; }
    ViewFrame &frame() override { return *m_frame; }
    Workspaces &workspaces() override { return *m_workspaces; }
    bool remembers() const override { return m_options.remembers; }
    void showMessage(const QString &text) override;
    void showFailure(const QString &reason) override;
    void notice(const QString &text) override;
    bool mayExportTo(const std::filesystem::path &file) override;
    void follow(const lessons::Link &link) override;
    void showStep(const lessons::Step *step) override;
    bool hasSmoothEdges() const override { return m_hasSmoothEdges; }
    State state() override;
    void restore(const State &state) override;

    /// Resizes the window so that the view has this size, logical pixels.
    /// @pre the window is shown
    void setViewSize(const QSize &size);
    /// The menu of panels, for a right click on the tool bar or on a panel's title.
    QMenu *createPopupMenu() override;
    /// The series of scans of the feature that has one.
    ScanList &scans();
    /// The shown message, or empty.
    QString message() const;

signals:
    /// Emitted when something could not be opened, saved or drawn, with the reason.
    void openFailed(const QString &reason);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void closeEvent(QCloseEvent *event) override;

private:
    void createView();
    void createFeatures();
    /// Lets the controls of placing give the focus back to the view.
    void returnFocus();
    void connectSession();
    void connectBars(LoadingBar &loading, RecoveryBar &recovery);
    void setSmoothEdges(bool isSmooth);
    void restoreLayout();
    void keepLayout() const;
    void showName();

    Options m_options;
    bool m_hasSmoothEdges = true;
    SceneDocument *m_document;
    std::unique_ptr<WindowQuestions> m_questions;
    Session *m_session;
    SceneView *m_view;
    ViewFrame *m_frame;
    MessageBar *m_message;
    std::vector<Feature *> m_features;
    Workspaces *m_workspaces = nullptr;
    WindowMenus *m_menus = nullptr;
};

} // namespace unprojector::gui
