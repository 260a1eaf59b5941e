#pragma once

#include "core/lessons/link.h"
#include "gui/widgets/icons.h"

#include <QKeySequence>
#include <QList>
#include <QMap>
#include <QObject>
#include <QSize>

#include <vector>

class QAction;
class QActionGroup;
class QDockWidget;
class QMainWindow;
class QSettings;

namespace unprojector::gui {
class PanelHelp;
using lessons::Panel;
using lessons::Workspace;

/// A panel that a feature adds to the window.
struct PanelSpec {
    Panel id;
    QString title;
    QWidget *widget;
    /// The area in a window that is wide and high enough; in others all panels are on the right.
    /// Panels of one area are tabs of one dock.
    Qt::DockWidgetArea area;
    QKeySequence key;         ///< shows and hides the panel
    bool standsAlone = false; ///< never a tab: the user reads it while working in another panel
};

/// A workspace that a feature adds to the window.
struct WorkspaceSpec {
    Workspace id;
    QString title;
    QString tip;
    Drawing drawing;
    QKeySequence key;
    QList<Panel> panels; ///< shown at first, front panels first
};

/// The panels around the view, and the workspaces: the sets of panels for one kind of work each.
///
/// Each workspace remembers how it was left: its panels, their positions and sizes. The panels on
/// the right have the same width in all workspaces. A window that is shrunk and enlarged again gets
/// its old sizes back.
class Workspaces : public QObject {
    Q_OBJECT
public:
    /// @param panels      in any order, at most one of each id
    /// @param workspaces  the same, at least one
    Workspaces(QMainWindow &window, std::vector<PanelSpec> panels, std::vector<WorkspaceSpec> workspaces);

    /// The panels that may be tabs; panels that stand alone have actions of their own.
    std::vector<QDockWidget *> sharedDocks() const;
    /// Actions that switch to the workspaces, in their order.
    QList<QAction *> actions() const;
    QDockWidget &dock(Panel panel) const;
    /// Returns whether a dock is visible in the window: the front one of its tabs.
    bool isFront(const QDockWidget &dock) const;
    /// The manual's section on the panel with the focus; without such a panel, on the first panel
    /// of the workspace.
    QString manualPlace() const;
    Workspace current() const { return m_current; }
    /// Switches to a workspace and remembers the former one. Hides the panels that the workspace
    /// doesn't show.
    void enter(Workspace workspace);
    /// Shows a panel in the current workspace, in front.
    void show(Panel panel);
    /// Raises a panel's height to 60 % of the window's height if it is lower. Does this only if
    /// both panels are in front in the same dock area.
    void giveRoom(Panel panel, Panel other);

    /// Resets the current workspace to its default for the window's size; the panels on the right
    /// get their default width in every workspace.
    void reset();
    /// Resets all workspaces.
    void resetAll()
    {
        m_layouts.clear();
        m_wanted.clear();
        reset();
    }
    bool arePanelsHidden() const { return m_arePanelsHidden; }
    /// Hides or shows the panels; without them the view fills the window.
    void hidePanels(bool isHidden);

    /// Sets the least size of the view, logical pixels: panels shrink for it if they can, but the
    /// user's sizes are remembered. Invalid: no limit.
    void setLeastForView(const QSize &size);
    /// Call it when the window has been resized and laid out.
    void windowResized();

    /// The sizes of the areas around the view: widths on the left and right, heights above and
    /// below, logical pixels.
    using Sizes = QMap<Qt::DockWidgetArea, int>;
    /// The current workspace, and the layout of the window and of all workspaces.
    struct Layout {
        Workspace current;
        QMap<QByteArray, QByteArray> layouts;
        QMap<QByteArray, Sizes> wanted;
        QByteArray panels;        ///< of the window, with its panels
        std::vector<Panel> front; ///< the front tabs
        bool arePanelsHidden;
    };
    Layout layout();
    /// Restores the panels and their exact sizes, if the window has its former size.
    void restore(const Layout &layout);
    /// @return whether a saved layout fits this window
    bool restore(const QSettings &settings);
    void keep(QSettings &settings);

signals:
    /// Emitted when the panels are arranged: by default, or as the workspace was left. Receivers
    /// now show or hide the panels that stand alone, which no workspace controls.
    void laidOut();
    /// Emitted when the user closed this panel by its close button or its key.
    void closed(unprojector::lessons::Panel panel);
    void panelsHidden(bool isHidden);
    /// Emitted when a panel gets a title bar, which has a close button, or loses it to a tab, which
    /// has none.
    void titled(unprojector::lessons::Panel panel, bool hasTitleBar);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Entered {
        WorkspaceSpec spec;
        QAction *action;
    };
    struct Docked {
        PanelSpec spec;
        QDockWidget *dock;
    };

    const Entered &entered(Workspace workspace) const;
    /// The key of the current workspace in the saved layouts.
    const char *name() const { return nameOf(m_current); }
    void arrange();
    void leave();
    Sizes firstSizes(bool isWide) const;
    int rightWidth() const;
    /// Sets the size of an area in the current workspace; on the right in all workspaces, so that
    /// the view keeps its size, and its pick stays valid.
    void want(Qt::DockWidgetArea area, int size);
    /// The current sizes of areas with a visible panel.
    Sizes sizesNow() const;
    void applySizes();
    /// Updates title bars and sizes after panels were added, removed or moved.
    void settle();
    void setTitleBars();

    QMainWindow &m_window;
    std::vector<Docked> m_panels;      ///< in the order of their ids
    std::vector<Entered> m_workspaces; ///< in the order of their ids
    Workspace m_current;
    QMap<QByteArray, QByteArray> m_layouts; ///< of the workspaces that were left, by name
    QMap<QByteArray, Sizes> m_wanted;       ///< of each workspace, as the user set them in a window of any size
    QSize m_leastForView;
    Sizes m_pressed; ///< at the last mouse press, possibly on a separator
    bool m_isArranged = false;
    bool m_arePanelsHidden = false;
    QByteArray m_layoutWithPanels;
    PanelHelp *m_help;
};

} // namespace unprojector::gui
