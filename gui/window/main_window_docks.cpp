// The window's panels: which there are, and where they stand.

#include "gui/window/main_window.h"

#include "gui/panels/comparison_panel.h"
#include "gui/panels/lifecycle_panel.h"
#include "gui/panels/parameters_panel.h"
#include "gui/panels/pipeline_panel.h"
#include "gui/panels/viewport_inspector.h"
#include "gui/window/example_note.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QScrollArea>
#include <QSettings>

#include <algorithm>
#include <map>

namespace unprojector::gui {
namespace {

/// Raised when docks or tool bars change, so that an old layout is not put onto a new window.
constexpr int kLayoutVersion = 2;

// In smaller windows the view keeps its half. Logical pixels.
constexpr int kWideWindow = 1180;
constexpr int kHighWindow = 700;
constexpr int kLeftWidth = 238;
constexpr int kRightWidth = 446;
constexpr int kBottomHeight = 190;

/// On a small window the panel scrolls, instead of holding the window open.
QWidget *scrolled(QWidget *panel)
{
    auto *scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setWidget(panel);
    return scroll;
}

} // namespace

std::vector<MainWindow::Panel> MainWindow::panelTable()
{
    using Shown = Panel::Shown;
    constexpr auto kLeft = Qt::LeftDockWidgetArea, kRight = Qt::RightDockWidgetArea, kBottom = Qt::BottomDockWidgetArea;
    // Tabs stand in this order; the first of an area is in front.
    return {
        {"comparison", tr("Comparison"), [this] { return scrolled(m_comparison = new ComparisonPanel(*m_document)); },
         kRight, kRight, Qt::ALT | Qt::Key_1, Shown::Always},
        {"pipeline", tr("Pipeline"), [this] { return new PipelinePanel(*m_document); }, kRight, kRight,
         Qt::ALT | Qt::Key_2, Shown::Always},
        {"parameters", tr("Parameters"), [this] { return m_parameters = new ParametersPanel(*m_document); }, kLeft,
         kRight, Qt::ALT | Qt::Key_3, Shown::Always},
        {"inspector", tr("Viewport"), [this] { return m_inspector = new ViewportInspector(*m_document); }, kBottom,
         kBottom, Qt::ALT | Qt::Key_4, Shown::InHighWindows},
        {"lifecycle", tr("Life of the View"), [this] { return new LifecyclePanel(*m_lifecycle); }, kBottom, kBottom,
         Qt::ALT | Qt::Key_5, Shown::InHighWindows},
        {"example",
         tr("Example"),
         [this] { return m_exampleNote = new ExampleNote; },
         kLeft,
         kBottom,
         {},
         Shown::WithExample},
    };
}

void MainWindow::createDocks()
{
    m_panels = panelTable();
    for (Panel &panel : m_panels) {
        panel.dock = new QDockWidget(panel.title, this);
        panel.dock->setObjectName(QLatin1String(panel.id));
        panel.dock->setWidget(panel.make());
        panel.dock->hide(); // until it has a place
        panel.dock->toggleViewAction()->setShortcut(panel.key);
        if (panel.shown == Panel::Shown::WithExample)
            m_exampleDock = panel.dock;
    }
    connect(m_exampleNote, &ExampleNote::closeRequested, m_exampleDock, &QWidget::hide);
    connect(m_exampleNote, &ExampleNote::formulasRequested, this, &MainWindow::showFormulas);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    // The sides keep their full height: numbers stand in columns there.
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
}

void MainWindow::createPanelActions(QMenu &menu)
{
    for (const Panel &panel : m_panels) {
        if (panel.shown != Panel::Shown::WithExample) // there is nothing to show without one
            menu.addAction(panel.dock->toggleViewAction());
    }
    m_hidesPanels = addAction(&menu, tr("H&ide All Panels"), Qt::Key_F9, tr("Give the view the whole window"),
                              [this] { hidePanels(m_hidesPanels->isChecked()); });
    m_hidesPanels->setCheckable(true);
    addAction(&menu, tr("R&eset Layout"), {}, tr("Put all panels back to where they were at first"),
              [this] { arrangeDocks(); });
}

void MainWindow::arrangeDocks()
{
    const bool isWide = width() >= kWideWindow;
    const bool isHigh = height() >= kHighWindow;
    for (const Panel &panel : m_panels) {
        panel.dock->setFloating(false);
        removeDockWidget(panel.dock);
    }
    std::map<Qt::DockWidgetArea, std::vector<QDockWidget *>> areas;
    for (const Panel &panel : m_panels) {
        const Qt::DockWidgetArea area = isWide ? panel.area : panel.narrowArea;
        addDockWidget(area, panel.dock);
        std::vector<QDockWidget *> &tabs = areas[area];
        if (!tabs.empty())
            tabifyDockWidget(tabs.back(), panel.dock);
        tabs.push_back(panel.dock);
        panel.dock->setVisible(panel.shown == Panel::Shown::Always
                               || (panel.shown == Panel::Shown::InHighWindows && isHigh)
                               || (panel.shown == Panel::Shown::WithExample && !m_exampleNote->isEmpty()));
    }
    m_hidesPanels->setChecked(false);
    for (const auto &[area, tabs] : areas)
        tabs.front()->raise();
    QDockWidget *right = areas[Qt::RightDockWidgetArea].front();
    if (isWide)
        resizeDocks({areas[Qt::LeftDockWidgetArea].front(), right}, {kLeftWidth, kRightWidth}, Qt::Horizontal);
    else
        resizeDocks({right}, {std::min(kRightWidth, width() / 2)}, Qt::Horizontal);
    resizeDocks({areas[Qt::BottomDockWidgetArea].front()}, {kBottomHeight}, Qt::Vertical);
}

void MainWindow::hidePanels(bool isHidden)
{
    if (isHidden) {
        m_layoutWithPanels = m_isArranged ? saveState(kLayoutVersion) : QByteArray();
        for (const Panel &panel : m_panels)
            panel.dock->hide();
    } else if (m_layoutWithPanels.isEmpty() || !restoreState(m_layoutWithPanels, kLayoutVersion)) {
        arrangeDocks();
    }
    m_isArranged = true;
    m_hidesPanels->setChecked(isHidden);
}

void MainWindow::restoreLayout()
{
    if (!m_options.remembers)
        return;
    const QSettings settings;
    m_comparison->setShowsFloat(settings.value(QStringLiteral("comparison/showsFloat"), false).toBool());
    m_parameters->restoreState(settings.value(QStringLiteral("parameters/state")).toByteArray());
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    const QByteArray state = settings.value(QStringLiteral("window/state")).toByteArray();
    if (state.isEmpty())
        return;
    arrangeDocks(); // every dock needs a place before a kept one can be given to it
    m_isArranged = restoreState(state, kLayoutVersion);
}

void MainWindow::keepLayout() const
{
    if (!m_options.remembers)
        return;
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window/state"), saveState(kLayoutVersion));
    settings.setValue(QStringLiteral("parameters/state"), m_parameters->saveState());
    settings.setValue(QStringLiteral("comparison/showsFloat"), m_comparison->showsFloat());
}

} // namespace unprojector::gui
