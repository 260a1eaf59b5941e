#include "gui/window/workspaces.h"

#include "gui/text/help_anchors.h"
#include "gui/window/kept_bytes.h"
#include "gui/window/panel_help.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QEvent>
#include <QLayout>
#include <QMainWindow>
#include <QSettings>
#include <QTimer>
#include <QVariant>

#include <algorithm>
#include <array>

namespace unprojector::gui {
namespace {

/// Incremented when docks or tool bars change, so that an old layout is not applied to a new
/// window.
constexpr int kLayoutVersion = 4;

// Sizes in digits and lines of the window's font.
constexpr int kWideWindow = 150;
constexpr int kHighWindow = 40;
constexpr int kLeftDigits = 34;
constexpr int kNoteDigits = 41; // on the left, if it has only text
constexpr int kRightDigits = 54;
/// The limit for a panel, pixels: a damaged file may have more.
constexpr int kMostKeptSize = 1 << 14;
constexpr int kBottomLines = 16;
/// The largest share of the window for the panels of both sides, or for those above and below, and
/// of one side at first.
constexpr double kMostOfTheWindow = 0.62;
constexpr double kMostOfOneSide = 0.38;
constexpr double kMostOfANarrowWindow = 0.48;

struct AreaName {
    Qt::DockWidgetArea area;
    const char *name; ///< in the settings
};
constexpr std::array kAreaNames{AreaName{Qt::LeftDockWidgetArea, "left"}, AreaName{Qt::RightDockWidgetArea, "right"},
                                AreaName{Qt::TopDockWidgetArea, "top"}, AreaName{Qt::BottomDockWidgetArea, "bottom"}};

bool isSide(Qt::DockWidgetArea area)
{
    return area == Qt::LeftDockWidgetArea || area == Qt::RightDockWidgetArea;
}

QString settingOf(const char *what, const QByteArray &place)
{
    return QStringLiteral("window/%1/%2").arg(QLatin1String(what), QLatin1String(place));
}

} // namespace

Workspaces::Workspaces(QMainWindow &window, std::vector<PanelSpec> panels, std::vector<WorkspaceSpec> workspaces)
    : QObject(&window), m_window(window), m_help(new PanelHelp(window))
{
    const auto byId = [](const auto &a, const auto &b) { return a.id < b.id; };
    std::sort(panels.begin(), panels.end(), byId);
    std::sort(workspaces.begin(), workspaces.end(), byId);
    for (PanelSpec &panel : panels) {
        auto *dock = new QDockWidget(panel.title, &m_window);
        dock->setObjectName(QLatin1String(nameOf(panel.id)));
        dock->setWidget(panel.widget);
        dock->hide(); // until it is placed
        QAction *toggle = dock->toggleViewAction();
        toggle->setShortcut(panel.key);
        dock->installEventFilter(this);
        m_help->add(*dock, manualPlaceOf(panel.id));
        connect(dock, &QDockWidget::topLevelChanged, this, &Workspaces::settle, Qt::QueuedConnection);
        connect(dock, &QDockWidget::dockLocationChanged, this, &Workspaces::settle, Qt::QueuedConnection);
        connect(toggle, &QAction::toggled, this, &Workspaces::settle, Qt::QueuedConnection);
        connect(toggle, &QAction::triggered, dock, [dock](bool isShown) {
            if (isShown)
                dock->raise(); // a requested panel must not be a hidden tab
        });
        m_panels.push_back({std::move(panel), dock});
    }
    auto *group = new QActionGroup(this);
    for (WorkspaceSpec &workspace : workspaces) {
        auto *action = new QAction(workspace.title, group);
        action->setCheckable(true);
        action->setIcon(drawnIcon(workspace.drawing));
        action->setIconVisibleInMenu(false);
        action->setShortcut(workspace.key);
        action->setToolTip(
            QStringLiteral("%1 (%2)").arg(workspace.tip, workspace.key.toString(QKeySequence::NativeText)));
        action->setStatusTip(workspace.tip);
        connect(action, &QAction::triggered, this, [this, id = workspace.id] { enter(id); });
        m_workspaces.push_back({std::move(workspace), action});
    }
    m_current = m_workspaces.front().spec.id;
    m_workspaces.front().action->setChecked(true);
    // Not animated: panel sizes are read, and set, right after a drop.
    m_window.setDockOptions(QMainWindow::AllowNestedDocks | QMainWindow::AllowTabbedDocks);
    m_window.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    // The side areas keep the full height: they contain columns of numbers.
    m_window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    m_window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    m_window.installEventFilter(this);
}

std::vector<QDockWidget *> Workspaces::sharedDocks() const
{
    std::vector<QDockWidget *> docks;
    for (const Docked &panel : m_panels) {
        if (!panel.spec.standsAlone)
            docks.push_back(panel.dock);
    }
    return docks;
}

QList<QAction *> Workspaces::actions() const
{
    QList<QAction *> actions;
    for (const Entered &workspace : m_workspaces)
        actions << workspace.action;
    return actions;
}

QDockWidget &Workspaces::dock(Panel panel) const
{
    return *std::find_if(m_panels.begin(), m_panels.end(), [&](const Docked &one) {
                return one.spec.id == panel;
            })->dock;
}

QString Workspaces::manualPlace() const
{
    const QWidget *focus = QApplication::focusWidget(); // in a floating panel, which is a window of its own
    if (!focus)
        focus = m_window.focusWidget();
    for (const Docked &panel : m_panels) {
        if (focus && panel.dock->isAncestorOf(focus))
            return manualPlaceOf(panel.spec.id);
    }
    return manualPlaceOf(entered(m_current).spec.panels.front());
}

const Workspaces::Entered &Workspaces::entered(Workspace workspace) const
{
    return *std::find_if(m_workspaces.begin(), m_workspaces.end(),
                         [&](const Entered &one) { return one.spec.id == workspace; });
}

void Workspaces::leave()
{
    if (m_isArranged)
        m_layouts[name()] = m_arePanelsHidden ? m_layoutWithPanels : m_window.saveState(kLayoutVersion);
}

void Workspaces::enter(Workspace workspace)
{
    if (workspace != m_current || m_arePanelsHidden) {
        leave();
        m_current = workspace;
        m_arePanelsHidden = false;
        const QByteArray kept = m_layouts.value(name());
        if (kept.isEmpty() || !m_window.restoreState(kept, kLayoutVersion))
            arrange();
        else
            emit laidOut();
        settle();
        emit panelsHidden(false);
    }
    entered(workspace).action->setChecked(true);
}

void Workspaces::show(Panel panel)
{
    QDockWidget &shown = dock(panel);
    shown.show();
    shown.raise();
    settle();
}

void Workspaces::giveRoom(Panel panel, Panel other)
{
    // After the layout.
    QTimer::singleShot(0, this, [this, &own = dock(panel), &beside = dock(other)] {
        constexpr double kShare = 0.6;
        const int wanted = static_cast<int>(kShare * m_window.height());
        if (isFront(own) && isFront(beside) && m_window.dockWidgetArea(&own) == m_window.dockWidgetArea(&beside)
            && own.height() < wanted)
            m_window.resizeDocks({&own}, {wanted}, Qt::Vertical);
    });
}

Workspaces::Layout Workspaces::layout()
{
    std::vector<Panel> front;
    for (const Docked &panel : m_panels) {
        if (isFront(*panel.dock))
            front.push_back(panel.spec.id);
    }
    const QByteArray panels = m_arePanelsHidden ? m_layoutWithPanels
                              : m_isArranged    ? m_window.saveState(kLayoutVersion)
                                                : QByteArray();
    return {m_current, m_layouts, m_wanted, panels, front, m_arePanelsHidden};
}

void Workspaces::restore(const Layout &layout)
{
    m_current = layout.current;
    m_layouts = layout.layouts;
    m_wanted = layout.wanted;
    m_arePanelsHidden = false;
    entered(m_current).action->setChecked(true);
    if (layout.panels.isEmpty() || !m_window.restoreState(layout.panels, kLayoutVersion))
        arrange();
    else
        emit laidOut();
    for (const Panel panel : layout.front)
        dock(panel).raise(); // Qt does so a little later
    settle();
    emit panelsHidden(false);
    hidePanels(layout.arePanelsHidden);
}

void Workspaces::reset()
{
    m_layouts.remove(name());
    m_arePanelsHidden = false;
    for (Sizes &sizes : m_wanted)
        sizes.remove(Qt::RightDockWidgetArea);
    arrange();
    emit panelsHidden(false);
}

void Workspaces::arrange()
{
    const QFontMetrics metrics(m_window.font());
    const int digit = metrics.horizontalAdvance(u'0');
    const bool isWide = m_window.width() >= kWideWindow * digit;
    const bool isHigh = m_window.height() >= kHighWindow * metrics.lineSpacing();
    const QList<Panel> &shown = entered(m_current).spec.panels;
    const auto rank = [&shown](const Docked &panel) {
        const auto place = shown.indexOf(panel.spec.id);
        return place < 0 ? shown.size() : place;
    };
    std::vector<const Docked *> inOrder;
    for (const Docked &panel : m_panels) {
        panel.dock->setFloating(false);
        m_window.removeDockWidget(panel.dock);
        inOrder.push_back(&panel);
    }
    std::stable_sort(inOrder.begin(), inOrder.end(),
                     [&](const Docked *a, const Docked *b) { return rank(*a) < rank(*b); });
    QMap<Qt::DockWidgetArea, QDockWidget *> fronts, lasts;
    for (const Docked *panel : inOrder) {
        const bool isRoom = panel->spec.area == Qt::BottomDockWidgetArea ? isHigh && isWide : isWide;
        const Qt::DockWidgetArea area = isRoom ? panel->spec.area : Qt::RightDockWidgetArea;
        m_window.addDockWidget(area, panel->dock);
        if (lasts.contains(area) && !(panel->spec.standsAlone && isRoom))
            m_window.tabifyDockWidget(lasts[area], panel->dock);
        if (!panel->spec.standsAlone || !isRoom) {
            if (!fronts.contains(area))
                fronts[area] = panel->dock;
            lasts[area] = panel->dock;
        }
        panel->dock->setVisible(rank(*panel) < shown.size());
    }
    for (QDockWidget *front : std::as_const(fronts))
        front->raise();
    const int right = rightWidth();
    m_wanted[name()] = firstSizes(isWide);
    if (right > 0)
        want(Qt::RightDockWidgetArea, right);
    m_isArranged = true;
    emit laidOut();
    settle();
}

/// The right width of the other workspaces, which is common; 0 if none was entered yet.
int Workspaces::rightWidth() const
{
    for (auto sizes = m_wanted.cbegin(); sizes != m_wanted.cend(); ++sizes) {
        if (sizes.key() != name() && sizes->contains(Qt::RightDockWidgetArea))
            return sizes->value(Qt::RightDockWidgetArea);
    }
    return 0;
}

void Workspaces::want(Qt::DockWidgetArea area, int size)
{
    m_wanted[name()][area] = size;
    if (area != Qt::RightDockWidgetArea)
        return;
    for (Sizes &sizes : m_wanted) {
        if (sizes.contains(area))
            sizes[area] = size;
    }
}

Workspaces::Sizes Workspaces::firstSizes(bool isWide) const
{
    const QFontMetrics metrics(m_window.font());
    const int digit = metrics.horizontalAdvance(u'0'), line = metrics.lineSpacing();
    const int oneSide = static_cast<int>((isWide ? kMostOfOneSide : kMostOfANarrowWindow) * m_window.width());
    const QList<Panel> &shown = entered(m_current).spec.panels;
    bool hasLeft = false;
    int right = kRightDigits * digit;
    for (const Docked &docked : m_panels) {
        const PanelSpec &panel = docked.spec;
        hasLeft = hasLeft || (panel.area == Qt::LeftDockWidgetArea && shown.contains(panel.id));
        // Panels on the right show numbers and know their width. Every workspace leaves the same
        // width to the view.
        const bool isInAny = std::any_of(m_workspaces.begin(), m_workspaces.end(),
                                         [&panel](const Entered &one) { return one.spec.panels.contains(panel.id); });
        if (panel.area == Qt::RightDockWidgetArea && isInAny)
            right = std::max(right, panel.widget->sizeHint().width());
    }
    return {{Qt::LeftDockWidgetArea, std::min((hasLeft ? kLeftDigits : kNoteDigits) * digit, oneSide)},
            {Qt::RightDockWidgetArea, std::min(right, oneSide)},
            {Qt::TopDockWidgetArea, kBottomLines * line},
            {Qt::BottomDockWidgetArea, kBottomLines * line}};
}

void Workspaces::hidePanels(bool isHidden)
{
    if (isHidden == m_arePanelsHidden)
        return;
    if (isHidden) {
        m_layoutWithPanels = m_isArranged ? m_window.saveState(kLayoutVersion) : QByteArray();
        for (const Docked &panel : m_panels)
            panel.dock->hide();
        m_isArranged = true;
    } else if (m_layoutWithPanels.isEmpty() || !m_window.restoreState(m_layoutWithPanels, kLayoutVersion)) {
        arrange();
    }
    m_arePanelsHidden = isHidden;
    if (!isHidden)
        emit laidOut();
    settle();
    emit panelsHidden(isHidden);
}

bool Workspaces::isFront(const QDockWidget &dock) const
{
    if (!dock.isVisible() || dock.isFloating() || dock.window() != &m_window)
        return false;
    // The visible region cannot be used: it excludes what opaque child widgets cover.
    const QWidget *there = m_window.childAt(dock.mapTo(&m_window, dock.rect().center()));
    return there && (there == &dock || dock.isAncestorOf(there));
}

Workspaces::Sizes Workspaces::sizesNow() const
{
    QMap<Qt::DockWidgetArea, QRect> places;
    for (const Docked &panel : m_panels) {
        if (isFront(*panel.dock))
            places[m_window.dockWidgetArea(panel.dock)] |= panel.dock->geometry();
    }
    Sizes sizes;
    for (auto place = places.cbegin(); place != places.cend(); ++place)
        sizes[place.key()] = isSide(place.key()) ? place->width() : place->height();
    return sizes;
}

void Workspaces::setLeastForView(const QSize &size)
{
    if (size == m_leastForView)
        return;
    m_leastForView = size;
    applySizes();
}

void Workspaces::applySizes()
{
    if (!m_isArranged || !m_window.isVisible())
        return;
    m_window.layout()->activate(); // a panel shown just now gets its position only here
    Sizes &wanted = m_wanted[name()];
    const Sizes now = sizesNow();
    for (const bool isAcross : {true, false}) {
        int sum = 0, sumNow = 0;
        for (auto size = now.cbegin(); size != now.cend(); ++size) {
            if (!wanted.contains(size.key())) {
                const int right = size.key() == Qt::RightDockWidgetArea ? rightWidth() : 0;
                wanted[size.key()] = right > 0 ? right : *size;
            }
            sum += isSide(size.key()) == isAcross ? wanted[size.key()] : 0;
            sumNow += isSide(size.key()) == isAcross ? *size : 0;
        }
        double room = kMostOfTheWindow * (isAcross ? m_window.width() : m_window.height());
        if (m_leastForView.isValid()) {
            const QSize more = m_window.centralWidget()->size() - m_leastForView;
            room = std::clamp<double>(sumNow + (isAcross ? more.width() : more.height()), 1.0, room);
        }
        const double share = sum > room ? room / sum : 1.0;
        QList<QDockWidget *> docks;
        QList<int> sizes;
        for (const Docked &panel : m_panels) {
            const Qt::DockWidgetArea area = m_window.dockWidgetArea(panel.dock);
            if (isSide(area) != isAcross || !isFront(*panel.dock))
                continue;
            // Panels side by side in an area keep their shares of its width.
            const int own = isAcross ? panel.dock->width() : panel.dock->height();
            docks << panel.dock;
            sizes << static_cast<int>(wanted[area] * share * own / std::max(now[area], 1));
        }
        if (!docks.isEmpty())
            m_window.resizeDocks(docks, sizes, isAcross ? Qt::Horizontal : Qt::Vertical);
    }
}

void Workspaces::windowResized()
{
    if (m_isArranged)
        applySizes();
    else if (m_window.isVisible())
        arrange(); // only now the window has its final size
}

bool Workspaces::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == &m_window) {
        // The separators between docks belong to the window itself: an area with another size after
        // a separator was released has the size that the user wants.
        if (event->type() == QEvent::MouseButtonPress)
            m_pressed = sizesNow();
        else if (event->type() == QEvent::MouseButtonRelease)
            QTimer::singleShot(0, this, [this] {
                const Sizes now = sizesNow();
                for (auto size = now.cbegin(); size != now.cend(); ++size) {
                    if (m_pressed.contains(size.key()) && m_pressed[size.key()] != *size)
                        want(size.key(), *size);
                }
            });
    } else if (event->type() == QEvent::Close) {
        for (const Docked &panel : m_panels) {
            if (panel.dock == watched)
                emit closed(panel.spec.id);
        }
    }
    return QObject::eventFilter(watched, event);
}

void Workspaces::settle()
{
    setTitleBars();
    applySizes();
    m_help->settle();
}

/// A tab already has the panel's name.
void Workspaces::setTitleBars()
{
    for (const Docked &panel : m_panels) {
        const QList<QDockWidget *> others = m_window.tabifiedDockWidgets(panel.dock);
        const bool isTab = !panel.dock->isFloating()
                           && std::any_of(others.begin(), others.end(), [](QDockWidget *d) { return !d->isHidden(); });
        QWidget *bar = panel.dock->titleBarWidget();
        if (isTab == (bar != nullptr))
            continue;
        panel.dock->setTitleBarWidget(isTab ? new QWidget(panel.dock) : nullptr);
        delete bar;
        emit titled(panel.spec.id, !isTab);
    }
}

bool Workspaces::restore(const QSettings &settings)
{
    for (const Entered &workspace : m_workspaces) {
        const char *name = nameOf(workspace.spec.id);
        const QString key = settingOf("places", name);
        const QByteArray layout = unsealed(settings.value(key), key.toLatin1());
        if (!layout.isEmpty())
            m_layouts[name] = layout;
        const QVariantMap sizes = settings.value(settingOf("sizes", name)).toMap();
        for (const AreaName &area : kAreaNames) {
            if (const int size = sizes.value(QLatin1String(area.name)).toInt(); size > 0 && size < kMostKeptSize)
                m_wanted[name][area.area] = size;
        }
    }
    const QByteArray kept = settings.value(QStringLiteral("window/place")).toByteArray();
    if (const auto workspace = lessons::workspaceOf(kept.toStdString())) {
        m_current = *workspace;
        entered(m_current).action->setChecked(true);
    }
    const QByteArray layout = m_layouts.value(name());
    if (layout.isEmpty())
        return false;
    const Sizes sizes = m_wanted.value(name());
    arrange(); // every dock needs a position before a saved layout can be restored
    m_isArranged = m_window.restoreState(layout, kLayoutVersion);
    if (m_isArranged) {
        m_wanted[name()] = sizes;
        if (sizes.contains(Qt::RightDockWidgetArea))
            want(Qt::RightDockWidgetArea, sizes[Qt::RightDockWidgetArea]);
        emit laidOut();
        settle();
    }
    return m_isArranged;
}

void Workspaces::keep(QSettings &settings)
{
    leave();
    settings.setValue(QStringLiteral("window/place"), QByteArray(name()));
    for (auto layout = m_layouts.cbegin(); layout != m_layouts.cend(); ++layout)
        settings.setValue(settingOf("places", layout.key()),
                          sealed(*layout, settingOf("places", layout.key()).toLatin1()));
    for (auto sizes = m_wanted.cbegin(); sizes != m_wanted.cend(); ++sizes) {
        QVariantMap named;
        for (const AreaName &area : kAreaNames) {
            if (sizes->contains(area.area))
                named[QLatin1String(area.name)] = sizes->value(area.area);
        }
        settings.setValue(settingOf("sizes", sizes.key()), named);
    }
}

} // namespace unprojector::gui
