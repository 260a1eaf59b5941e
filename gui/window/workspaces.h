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

/// A panel that a feature brings to the window.
struct PanelSpec {
    Panel id;
    QString title;
    QWidget *widget;
    /// In a window that is wide and high enough; else all stand on the right. Those of one area are tabs of one dock.
    Qt::DockWidgetArea area;
    QKeySequence key;         ///< shows and hides it
    bool standsAlone = false; ///< never a tab of another: it is read while something is done there
};

/// A workspace that a feature brings to the window.
struct WorkspaceSpec {
    Workspace id;
    QString title;
    QString tip;
    Drawing drawing;
    QKeySequence key;
    QList<Panel> panels; ///< shown at first, those in front first
};

/// The panels around the view, and the workspaces: which of the panels are shown while the user does one kind of work.
///
/// Each workspace remembers how it was left: which panels it shows, where they stand and how large they are. The panels on the
/// right are as wide in all of them. A window that gets smaller and then larger again has its old sizes back.
class Workspaces : public QObject {
    Q_OBJECT
public:
    /// @param panels      in any order, one of each id at most
    /// @param workspaces  the same, at least one
    Workspaces(QMainWindow &window, std::vector<PanelSpec> panels, std::vector<WorkspaceSpec> workspaces);

    /// The panels that stand with others; those that stand alone have actions of their own.
    std::vector<QDockWidget *> sharedDocks() const;
    /// Actions that go to the workspaces, in their order.
    QList<QAction *> actions() const;
    QDockWidget &dock(Panel panel) const;
    /// Whether a dock stands in the window, in front where others share its place: it is seen.
    bool isFront(const QDockWidget &dock) const;
    /// The place of the manual on the panel that has the focus; on the first one of the workspace where the focus is elsewhere.
    QString manualPlace() const;
    Workspace current() const { return m_current; }
    /// Goes to a workspace and leaves the one before as it is. A panel that the workspace does not show is hidden.
    void enter(Workspace workspace);
    /// Shows a panel in the current workspace, in front.
    void show(Panel panel);
    /// Gives a panel the larger part of the side that it shares with another one, if it is smaller.
    void giveRoom(Panel panel, Panel other);

    /// The current workspace as it is at first, in the size that the window has now; the panels on the right get their first
    /// width in every workspace.
    void reset();
    /// The same of all workspaces.
    void resetAll()
    {
        m_layouts.clear();
        m_wanted.clear();
        reset();
    }
    bool arePanelsHidden() const { return m_arePanelsHidden; }
    /// Gives the view the whole window, or the panels back.
    void hidePanels(bool isHidden);

    /// How much of the window the panels leave to the view where they can become so small, logical pixels; what the user gave
    /// them is not forgotten. Nothing: as they are.
    void setLeastForView(const QSize &size);
    /// To be called when the window has got another size, its layout included.
    void windowResized();

    /// Of the areas around the view: widths on the left and right, heights above and below, logical pixels.
    using Sizes = QMap<Qt::DockWidgetArea, int>;
    /// Which workspace is entered, and how the window and all workspaces are laid out.
    struct Layout {
        Workspace current;
        QMap<QByteArray, QByteArray> layouts;
        QMap<QByteArray, Sizes> wanted;
        QByteArray panels;        ///< of the window, with its panels
        std::vector<Panel> front; ///< those in front of others
        bool arePanelsHidden;
    };
    Layout layout();
    /// The panels and their sizes are exactly as they were, if the window has the size that it had.
    void restore(const Layout &layout);
    /// @return whether there was something kept that fits this window
    bool restore(const QSettings &settings);
    void keep(QSettings &settings);

signals:
    /// The panels are where they are at first in a workspace, or where they were when it was left. Whether those that stand
    /// alone are shown is not the workspace's to say: now is the time to show or hide them.
    void laidOut();
    /// The user closed this panel by the button of its frame or by its key.
    void closed(unprojector::lessons::Panel panel);
    void panelsHidden(bool isHidden);
    /// A panel has got a title bar, which closes it, or has lost it to a tab, which does not.
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
    /// The name of the current workspace, by which its layout is kept.
    const char *name() const { return nameOf(m_current); }
    void arrange();
    void leave();
    Sizes firstSizes(bool isWide) const;
    int rightWidth() const;
    /// Sets the size of an area in the current workspace; on the right in all of them, so that the view keeps its size from one
    /// to the other, and its click with it.
    void want(Qt::DockWidgetArea area, int size);
    /// Of the areas where a panel is seen, as they are now.
    Sizes sizesNow() const;
    void applySizes();
    /// Title bars and sizes after panels came, went or were put elsewhere.
    void settle();
    void setTitleBars();

    QMainWindow &m_window;
    std::vector<Docked> m_panels;      ///< in the order of their ids
    std::vector<Entered> m_workspaces; ///< the same
    Workspace m_current;
    QMap<QByteArray, QByteArray> m_layouts; ///< of the workspaces that were left, by their names
    QMap<QByteArray, Sizes> m_wanted;       ///< of each workspace, as the user made them in whatever window
    QSize m_leastForView;
    Sizes m_pressed; ///< when the mouse was pressed, perhaps onto a separator
    bool m_isArranged = false;
    bool m_arePanelsHidden = false;
    QByteArray m_layoutWithPanels;
    PanelHelp *m_help;
};

} // namespace unprojector::gui
