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
class Translation;
class WindowMenus;
class WindowQuestions;

/// The window: a session's document in a view, with the panels and actions of its features around it. It knows the features by
/// one interface alone: what each of them does is in its own folder, see makeFeatures.
class MainWindow : public Window {
    Q_OBJECT
public:
    struct Options {
        std::optional<bool> smoothEdges = {}; ///< nothing: as the user chose in the menu
        bool remembers = true;                ///< layout, choices and recent files are read and kept
        /// Where unsaved changes are kept in case of a crash; empty: with the user's data if it `remembers`, else nowhere.
        QString recoveryFolder = {};
        AutosaveTiming autosave = {};
        /// What the menu of languages goes by, which is not there without it. Outlives the window.
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

    /// Makes the window as large or small as gives the view this size, logical pixels.
    /// @pre the window is shown
    void setViewSize(const QSize &size);
    /// The panels as a right click on the tool bar or on a panel's title offers them.
    QMenu *createPopupMenu() override;
    /// The message that is on show, or nothing.
    QString message() const;

signals:
    /// What could not be opened, saved or drawn, in words.
    void openFailed(const QString &reason);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void closeEvent(QCloseEvent *event) override;

private:
    void createView();
    void createFeatures();
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
