#include "gui/shell/work_places.h"

#include "gui/shell/kept_bytes.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QEvent>
#include <QLayout>
#include <QMainWindow>
#include <QSettings>
#include <QTimer>
#include <QVariant>

#include <algorithm>
#include <array>
#include <cstring>

namespace unprojector::gui {
namespace {

/// Raised when docks or tool bars change, so that an old layout is not put onto
/// a new window.
constexpr int kLayoutVersion = 4;

// Sizes in digits and lines of the window's font.
constexpr int kWideWindow = 150;
constexpr int kHighWindow = 40;
constexpr int kLeftDigits = 34;
constexpr int kNoteDigits = 41; // on the left, where only a text is read there
constexpr int kRightDigits = 54;
/// Of a panel, pixels: more comes of a damaged file.
constexpr int kMostKeptSize = 1 << 14;
constexpr int kBottomLines = 16;
/// What the panels of both sides, or those above and below, may take of the
/// window together, and one side at first.
constexpr double kMostOfTheWindow = 0.62;
constexpr double kMostOfOneSide = 0.40;
constexpr double kMostOfANarrowWindow = 0.48;

bool isSame(const char *a, const char *b)
{
    return std::strcmp(a, b) == 0;
}

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

WorkPlaces::WorkPlaces(QMainWindow &window, std::vector<Panel> panels, std::vector<Place> places)
    : QObject(&window), m_window(window), m_panels(std::move(panels)), m_places(std::move(places))
{
    for (Panel &panel : m_panels) {
        panel.dock = new QDockWidget(panel.title, &m_window);
        panel.dock->setObjectName(QLatin1String(panel.id));
        panel.dock->setWidget(panel.widget);
        panel.dock->hide(); // until it has a place
        panel.dock->toggleViewAction()->setShortcut(panel.key);
        panel.dock->installEventFilter(this);
        connect(panel.dock, &QDockWidget::topLevelChanged, this, &WorkPlaces::settle, Qt::QueuedConnection);
        connect(panel.dock, &QDockWidget::dockLocationChanged, this, &WorkPlaces::settle, Qt::QueuedConnection);
        connect(panel.dock->toggleViewAction(), &QAction::toggled, this, &WorkPlaces::settle, Qt::QueuedConnection);
        connect(panel.dock->toggleViewAction(), &QAction::triggered, panel.dock, [dock = panel.dock](bool isShown) {
            if (isShown)
                dock->raise(); // whoever asks for a panel does not want a tab behind another
        });
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
    // Not animated: the sizes of panels are read, and given, as soon as one was
    // dropped.
    m_window.setDockOptions(QMainWindow::AllowNestedDocks | QMainWindow::AllowTabbedDocks);
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
            emit laidOut();
        settle();
        emit panelsHidden(false);
    }
    found->action->setChecked(true);
}

void WorkPlaces::show(const char *panel)
{
    QDockWidget *shown = dock(panel);
    shown->show();
    shown->raise();
    settle();
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
        panel->dock->setVisible(rank(*panel) < shown.size());
    }
    for (QDockWidget *front : std::as_const(fronts))
        front->raise();
    m_wanted[current()] = firstSizes(isWide);
    m_isArranged = true;
    emit laidOut();
    settle();
}

WorkPlaces::Sizes WorkPlaces::firstSizes(bool isWide) const
{
    const QFontMetrics metrics(m_window.font());
    const int digit = metrics.horizontalAdvance(u'0'), line = metrics.lineSpacing();
    const int oneSide = static_cast<int>((isWide ? kMostOfOneSide : kMostOfANarrowWindow) * m_window.width());
    const QList<const char *> &shown = m_places[m_current].panels;
    bool hasLeft = false;
    int right = kRightDigits * digit;
    for (const Panel &panel : m_panels) {
        if (std::none_of(shown.begin(), shown.end(), [&panel](const char *id) { return isSame(id, panel.id); }))
            continue;
        hasLeft = hasLeft || panel.area == Qt::LeftDockWidgetArea;
        // What is on the right shows numbers, and says what room they need.
        if (panel.area == Qt::RightDockWidgetArea)
            right = std::max(right, panel.widget->sizeHint().width());
    }
    return {{Qt::LeftDockWidgetArea, std::min((hasLeft ? kLeftDigits : kNoteDigits) * digit, oneSide)},
            {Qt::RightDockWidgetArea, std::min(right, oneSide)},
            {Qt::TopDockWidgetArea, kBottomLines * line},
            {Qt::BottomDockWidgetArea, kBottomLines * line}};
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
    if (!isHidden)
        emit laidOut();
    settle();
    emit panelsHidden(isHidden);
}

bool WorkPlaces::isFront(const QDockWidget &dock) const
{
    if (!dock.isVisible() || dock.isFloating() || dock.window() != &m_window)
        return false;
    // Not by its visible region: what the opaque widgets inside cover of the dock
    // is left out of that.
    const QWidget *there = m_window.childAt(dock.mapTo(&m_window, dock.rect().center()));
    return there && (there == &dock || dock.isAncestorOf(there));
}

WorkPlaces::Sizes WorkPlaces::sizesNow() const
{
    QMap<Qt::DockWidgetArea, QRect> places;
    for (const Panel &panel : m_panels) {
        if (isFront(*panel.dock))
            places[m_window.dockWidgetArea(panel.dock)] |= panel.dock->geometry();
    }
    Sizes sizes;
    for (auto place = places.cbegin(); place != places.cend(); ++place)
        sizes[place.key()] = isSide(place.key()) ? place->width() : place->height();
    return sizes;
}

void WorkPlaces::setLeastForView(const QSize &size)
{
    if (size == m_leastForView)
        return;
    m_leastForView = size;
    applySizes();
}

void WorkPlaces::applySizes()
{
    if (!m_isArranged || !m_window.isVisible())
        return;
    m_window.layout()->activate(); // what was shown a moment ago has its place only then
    Sizes &wanted = m_wanted[current()];
    const Sizes now = sizesNow();
    for (const bool isAcross : {true, false}) {
        int sum = 0, sumNow = 0;
        for (auto size = now.cbegin(); size != now.cend(); ++size) {
            if (!wanted.contains(size.key()))
                wanted[size.key()] = *size;
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
        for (const Panel &panel : m_panels) {
            const Qt::DockWidgetArea area = m_window.dockWidgetArea(panel.dock);
            if (isSide(area) != isAcross || !isFront(*panel.dock))
                continue;
            // Those that stand side by side in an area share its width as they did.
            const int own = isAcross ? panel.dock->width() : panel.dock->height();
            docks << panel.dock;
            sizes << static_cast<int>(wanted[area] * share * own / std::max(now[area], 1));
        }
        if (!docks.isEmpty())
            m_window.resizeDocks(docks, sizes, isAcross ? Qt::Horizontal : Qt::Vertical);
    }
}

void WorkPlaces::windowResized()
{
    if (m_isArranged)
        applySizes();
    else if (m_window.isVisible())
        arrange(); // only now the window has the size that the arrangement goes by
}

bool WorkPlaces::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == &m_window) {
        // The separators between docks belong to the window itself: an area that
        // has another size after one was let go has it as the user wants it.
        if (event->type() == QEvent::MouseButtonPress)
            m_pressed = sizesNow();
        else if (event->type() == QEvent::MouseButtonRelease)
            QTimer::singleShot(0, this, [this] {
                const Sizes now = sizesNow();
                for (auto size = now.cbegin(); size != now.cend(); ++size) {
                    if (m_pressed.contains(size.key()) && m_pressed[size.key()] != *size)
                        m_wanted[current()][size.key()] = *size;
                }
            });
    } else if (event->type() == QEvent::Close) {
        for (const Panel &panel : m_panels) {
            if (panel.dock == watched)
                emit closed(panel.id);
        }
    }
    return QObject::eventFilter(watched, event);
}

void WorkPlaces::settle()
{
    setTitleBars();
    applySizes();
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
        emit titled(panel.id, !isTab);
    }
}

bool WorkPlaces::restore(const QSettings &settings)
{
    for (const Place &place : m_places) {
        const QString key = settingOf("places", place.id);
        const QByteArray layout = unsealed(settings.value(key), key.toLatin1());
        if (!layout.isEmpty())
            m_layouts[place.id] = layout;
        const QVariantMap sizes = settings.value(settingOf("sizes", place.id)).toMap();
        for (const AreaName &area : kAreaNames) {
            if (const int size = sizes.value(QLatin1String(area.name)).toInt(); size > 0 && size < kMostKeptSize)
                m_wanted[place.id][area.area] = size;
        }
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
    const Sizes sizes = m_wanted.value(current());
    arrange(); // every dock needs a place before a kept one can be given to it
    m_isArranged = m_window.restoreState(layout, kLayoutVersion);
    if (m_isArranged) {
        m_wanted[current()] = sizes;
        emit laidOut();
        settle();
    }
    return m_isArranged;
}

void WorkPlaces::keep(QSettings &settings)
{
    leave();
    settings.setValue(QStringLiteral("window/place"), QByteArray(current()));
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
