#include "gui/window/work_places.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QSettings>
#include <QTimer>

#include <algorithm>
#include <cstring>

namespace unprojector::gui {
namespace {

/// Raised when docks or tool bars change, so that an old layout is not put onto a new window.
constexpr int kLayoutVersion = 3;

// Sizes in digits and lines of the window's font.
constexpr int kWideWindow = 150;
constexpr int kHighWindow = 40;
constexpr int kLeftDigits = 34;
constexpr int kRightDigits = 54;
constexpr int kBottomLines = 16;
/// What the panels of both sides may take of the window together, and one side at first.
constexpr double kMostOfTheWindow = 0.62;
constexpr double kMostOfOneSide = 0.36;
constexpr double kMostOfANarrowWindow = 0.48;

bool isSame(const char *a, const char *b)
{
    return std::strcmp(a, b) == 0;
}

} // namespace

WorkPlaces::WorkPlaces(QMainWindow &window, std::vector<Panel> panels, std::vector<Place> places)
    : QObject(&window), m_window(window), m_panels(std::move(panels)), m_places(std::move(places))
{
    for (Panel &panel : m_panels) {
        panel.dock = new QDockWidget(panel.title, &m_window);
        panel.dock->setObjectName(QLatin1String(panel.id));
        panel.dock->setWidget(panel.widget);
        panel.dock->hide(); // until it has a place
        panel.dock->toggleViewAction()->setShortcut(panel.key);
        connect(panel.dock, &QDockWidget::topLevelChanged, this, &WorkPlaces::setTitleBars, Qt::QueuedConnection);
        connect(panel.dock, &QDockWidget::dockLocationChanged, this, &WorkPlaces::setTitleBars, Qt::QueuedConnection);
        connect(panel.dock->toggleViewAction(), &QAction::toggled, this, &WorkPlaces::setTitleBars,
                Qt::QueuedConnection);
    }
    auto *group = new QActionGroup(this);
    for (Place &place : m_places) {
        place.action = new QAction(place.title, group);
        place.action->setCheckable(true);
        place.action->setShortcut(place.key);
        place.action->setToolTip(
            QStringLiteral("%1 (%2)").arg(place.tip, place.key.toString(QKeySequence::NativeText)));
        place.action->setStatusTip(place.tip);
        connect(place.action, &QAction::triggered, this, [this, id = place.id] { enter(id); });
    }
    m_places[m_current].action->setChecked(true);
    m_window.setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowNestedDocks | QMainWindow::AllowTabbedDocks);
    m_window.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    // The sides keep their full height: numbers stand in columns there.
    m_window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    m_window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    m_window.installEventFilter(this);
}

QDockWidget *WorkPlaces::dock(const char *panel) const
{
    const auto found =
        std::find_if(m_panels.begin(), m_panels.end(), [panel](const Panel &p) { return isSame(p.id, panel); });
    return found == m_panels.end() ? nullptr : found->dock;
}

void WorkPlaces::leave()
{
    if (m_isArranged)
        m_layouts[current()] = m_arePanelsHidden ? m_layoutWithPanels : m_window.saveState(kLayoutVersion);
}

void WorkPlaces::enter(const char *place)
{
    const auto found =
        std::find_if(m_places.begin(), m_places.end(), [place](const Place &p) { return isSame(p.id, place); });
    if (found == m_places.end())
        return;
    const auto next = static_cast<std::size_t>(found - m_places.begin());
    if (next != m_current || m_arePanelsHidden) {
        leave();
        m_current = next;
        m_arePanelsHidden = false;
        const QByteArray kept = m_layouts.value(current());
        if (kept.isEmpty() || !m_window.restoreState(kept, kLayoutVersion))
            arrange();
        else
            rememberSizes();
        setTitleBars();
        windowResized();
        emit panelsHidden(false);
    }
    found->action->setChecked(true);
    emit entered(found->id);
}

void WorkPlaces::show(const char *panel)
{
    QDockWidget *shown = dock(panel);
    shown->show();
    shown->raise();
    setTitleBars();
}

void WorkPlaces::reset()
{
    m_layouts.remove(current());
    m_arePanelsHidden = false;
    arrange();
    emit panelsHidden(false);
}

void WorkPlaces::arrange()
{
    const QFontMetrics metrics(m_window.font());
    const int digit = metrics.horizontalAdvance(u'0');
    const bool isWide = m_window.width() >= kWideWindow * digit;
    const bool isHigh = m_window.height() >= kHighWindow * metrics.lineSpacing();
    const QList<const char *> &shown = m_places[m_current].panels;
    const auto rank = [&shown](const Panel &panel) {
        return std::find_if(shown.begin(), shown.end(), [&](const char *id) { return isSame(id, panel.id); })
               - shown.begin();
    };
    std::vector<const Panel *> inOrder;
    for (const Panel &panel : m_panels) {
        panel.dock->setFloating(false);
        m_window.removeDockWidget(panel.dock);
        inOrder.push_back(&panel);
    }
    std::stable_sort(inOrder.begin(), inOrder.end(),
                     [&](const Panel *a, const Panel *b) { return rank(*a) < rank(*b); });
    QMap<Qt::DockWidgetArea, QDockWidget *> fronts, lasts;
    for (const Panel *panel : inOrder) {
        const bool isRoom = panel->area == Qt::BottomDockWidgetArea ? isHigh && isWide : isWide;
        const Qt::DockWidgetArea area = isRoom ? panel->area : Qt::RightDockWidgetArea;
        m_window.addDockWidget(area, panel->dock);
        if (lasts.contains(area) && !(panel->standsAlone && isRoom))
            m_window.tabifyDockWidget(lasts[area], panel->dock);
        if (!panel->standsAlone || !isRoom) {
            if (!fronts.contains(area))
                fronts[area] = panel->dock;
            lasts[area] = panel->dock;
        }
        // A small window starts with the fewer panels.
        const bool isLeftOut = panel->area == Qt::BottomDockWidgetArea && !isRoom;
        panel->dock->setVisible(rank(*panel) < shown.size() && !isLeftOut);
    }
    for (QDockWidget *front : std::as_const(fronts))
        front->raise();
    m_wanted.clear();
    const auto wants = [&](Qt::DockWidgetArea area, const QSize &size) {
        if (fronts.contains(area) && !fronts[area]->isHidden())
            m_wanted[fronts[area]] = size;
    };
    const int oneSide = static_cast<int>((isWide ? kMostOfOneSide : kMostOfANarrowWindow) * m_window.width());
    wants(Qt::LeftDockWidgetArea, {std::min(kLeftDigits * digit, oneSide), 0});
    wants(Qt::RightDockWidgetArea, {std::min(kRightDigits * digit, oneSide), 0});
    wants(Qt::BottomDockWidgetArea, {0, kBottomLines * metrics.lineSpacing()});
    m_isArranged = true;
    setTitleBars();
    windowResized();
}

void WorkPlaces::hidePanels(bool isHidden)
{
    if (isHidden == m_arePanelsHidden)
        return;
    if (isHidden) {
        m_layoutWithPanels = m_isArranged ? m_window.saveState(kLayoutVersion) : QByteArray();
        for (const Panel &panel : m_panels)
            panel.dock->hide();
        m_isArranged = true;
    } else if (m_layoutWithPanels.isEmpty() || !m_window.restoreState(m_layoutWithPanels, kLayoutVersion)) {
        arrange();
    }
    m_arePanelsHidden = isHidden;
    windowResized();
    emit panelsHidden(isHidden);
}

/// Of each dock or group of tabs that stands in the window the one in front.
QList<QDockWidget *> WorkPlaces::dockedFronts() const
{
    QList<QDockWidget *> fronts;
    for (const Panel &panel : m_panels) {
        if (!panel.dock->isHidden() && !panel.dock->isFloating() && !panel.dock->visibleRegion().isEmpty())
            fronts << panel.dock;
    }
    return fronts;
}

void WorkPlaces::rememberSizes()
{
    m_wanted.clear();
    for (QDockWidget *dock : dockedFronts())
        m_wanted[dock] = dock->size();
}

void WorkPlaces::windowResized()
{
    if (!m_isArranged) {
        // Only now the window has the size that the arrangement goes by.
        if (m_window.isVisible())
            arrange();
        return;
    }
    if (m_wanted.isEmpty() && m_window.isVisible())
        rememberSizes(); // of a layout that was kept
    QList<QDockWidget *> sides, bottoms;
    QList<int> widths, heights;
    int left = 0, right = 0, bottom = 0;
    for (auto wanted = m_wanted.cbegin(); wanted != m_wanted.cend(); ++wanted) {
        QDockWidget *dock = wanted.key();
        if (dock->isHidden() || dock->isFloating())
            continue;
        const Qt::DockWidgetArea area = m_window.dockWidgetArea(dock);
        if (area == Qt::LeftDockWidgetArea || area == Qt::RightDockWidgetArea) {
            sides << dock;
            widths << wanted->width();
            int &side = area == Qt::LeftDockWidgetArea ? left : right;
            side = std::max(side, wanted->width());
        } else {
            bottoms << dock;
            heights << wanted->height();
            bottom += wanted->height();
        }
    }
    const auto shrink = [](QList<int> &sizes, int sum, double room) {
        if (sum > room) {
            for (int &size : sizes)
                size = static_cast<int>(size * room / sum);
        }
    };
    shrink(widths, left + right, kMostOfTheWindow * m_window.width());
    shrink(heights, bottom, kMostOfTheWindow * m_window.height());
    if (!sides.isEmpty())
        m_window.resizeDocks(sides, widths, Qt::Horizontal);
    if (!bottoms.isEmpty())
        m_window.resizeDocks(bottoms, heights, Qt::Vertical);
}

bool WorkPlaces::eventFilter(QObject *watched, QEvent *event)
{
    // The separators between docks belong to the window itself: after one was let go, sizes are as the user wants them.
    if (watched == &m_window && event->type() == QEvent::MouseButtonRelease && !m_arePanelsHidden)
        QTimer::singleShot(0, this, &WorkPlaces::rememberSizes);
    return QObject::eventFilter(watched, event);
}

/// A tab has the panel's name already.
void WorkPlaces::setTitleBars()
{
    for (const Panel &panel : m_panels) {
        const QList<QDockWidget *> others = m_window.tabifiedDockWidgets(panel.dock);
        const bool isTab = !panel.dock->isFloating()
                           && std::any_of(others.begin(), others.end(), [](QDockWidget *d) { return !d->isHidden(); });
        QWidget *bar = panel.dock->titleBarWidget();
        if (isTab == (bar != nullptr))
            continue;
        panel.dock->setTitleBarWidget(isTab ? new QWidget(panel.dock) : nullptr);
        delete bar;
    }
}

bool WorkPlaces::restore(const QSettings &settings)
{
    for (const Place &place : m_places) {
        const QByteArray layout =
            settings.value(QStringLiteral("window/places/%1").arg(QLatin1String(place.id))).toByteArray();
        if (!layout.isEmpty())
            m_layouts[place.id] = layout;
    }
    const QByteArray kept = settings.value(QStringLiteral("window/place")).toByteArray();
    const auto found = std::find_if(m_places.begin(), m_places.end(), [&](const Place &p) { return kept == p.id; });
    if (found != m_places.end()) {
        m_current = static_cast<std::size_t>(found - m_places.begin());
        found->action->setChecked(true);
    }
    const QByteArray layout = m_layouts.value(current());
    if (layout.isEmpty())
        return false;
    arrange(); // every dock needs a place before a kept one can be given to it
    m_isArranged = m_window.restoreState(layout, kLayoutVersion);
    if (m_isArranged) {
        rememberSizes();
        setTitleBars();
    }
    return m_isArranged;
}

void WorkPlaces::keep(QSettings &settings)
{
    leave();
    settings.setValue(QStringLiteral("window/place"), QByteArray(current()));
    for (auto layout = m_layouts.cbegin(); layout != m_layouts.cend(); ++layout)
        settings.setValue(QStringLiteral("window/places/%1").arg(QLatin1String(layout.key())), *layout);
}

} // namespace unprojector::gui
