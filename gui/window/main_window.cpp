#include "gui/window/main_window.h"

#include "gui/document/scene_document.h"
#include "gui/panels/comparison_panel.h"
#include "gui/panels/lifecycle_panel.h"
#include "gui/panels/observer_panel.h"
#include "gui/panels/parameters_panel.h"
#include "gui/panels/pipeline_panel.h"
#include "gui/panels/viewport_inspector.h"
#include "gui/text/error_text.h"
#include "gui/text/number_text.h"
#include "gui/view/lifecycle_log.h"
#include "gui/view/observer_view.h"
#include "gui/view/scene_view.h"
#include "gui/window/example_note.h"
#include "gui/window/overlay_bars.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSettings>
#include <QSplitter>
#include <QStatusBar>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
namespace {

/// Raised when docks or tool bars change, so that an old layout is not put onto a new window.
constexpr int kLayoutVersion = 2;

} // namespace

MainWindow::MainWindow(const Options &options, QWidget *parent)
    : QMainWindow(parent), m_options(options), m_document(new SceneDocument(this)), m_loader(new ModelLoader(this)),
      m_lifecycle(new LifecycleLog(this))
{
    m_sceneName = tr("the scene"); // until one is opened
    setWindowTitle(tr("Unprojector") + QStringLiteral("[*]"));
    resize(1280, 800);
    const bool chosen = !options.remembers || QSettings().value(QStringLiteral("view/smoothEdges"), true).toBool();
    m_smoothEdges = options.smoothEdges.value_or(chosen);

    createCenter();
    createDocks();
    createStatusBar();
    createActions();
    createView();

    connect(m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Pick)
            m_comparison->setPick(m_document->pick());
        if (changes & Change::Picture)
            showCamera();
    });
    connect(m_document, &SceneDocument::pickFailed, this,
            [this](const Error &error) { m_message->showMessage(errorText(error)); });
    connect(m_loader, &ModelLoader::started, m_loading, &LoadingBar::start);
    connect(m_loader, &ModelLoader::progressed, m_loading, &LoadingBar::setProgress);
    connect(m_loader, &ModelLoader::finished, this, &MainWindow::takeLoaded);
    connect(m_loader, &ModelLoader::cancelled, this, [this] {
        m_pendingScene.reset();
        m_loading->finish();
        emit loadingEnded();
    });
    connect(m_loading, &LoadingBar::cancelRequested, m_loader, &ModelLoader::cancel);

    createAutosave();
    restoreLayout();
    showCamera();
}

MainWindow::~MainWindow()
{
    // Its end empties the undo stack, which is no reason to forget the unsaved changes.
    m_document->disconnect(this);
    // The view tells the log of its end, so it goes while the log is there.
    delete m_view;
}

void MainWindow::createCenter()
{
    auto *frame = new QWidget;
    m_center = new QGridLayout(frame);
    m_center->setContentsMargins(0, 0, 0, 0);
    m_recovery = new RecoveryBar;
    m_message = new MessageBar;
    m_topBars = new QWidget;
    auto *bars = new QVBoxLayout(m_topBars);
    bars->setContentsMargins(0, 0, 0, 0);
    bars->setSpacing(0);
    bars->addWidget(m_recovery);
    bars->addWidget(m_message);
    m_loading = new LoadingBar;
    m_splitter = new QSplitter(Qt::Horizontal);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->addWidget(frame);
    setCentralWidget(m_splitter);
}

void MainWindow::createView()
{
    m_view = new SceneView(*m_document);
    m_view->setSmoothEdges(m_smoothEdges);
    m_center->addWidget(m_view, 0, 0);
    m_center->addWidget(m_topBars, 0, 0, Qt::AlignTop);
    m_center->addWidget(m_loading, 0, 0, Qt::AlignBottom | Qt::AlignHCenter);
    m_topBars->raise();
    m_loading->raise();
    connect(m_view, &SceneView::happened, m_lifecycle, &LifecycleLog::append);
    connect(m_view, &SceneView::clicked, m_document, &SceneDocument::pickAt);
    connect(m_view, &SceneView::hovered, this, &MainWindow::showHover);
    connect(m_view, &SceneView::pointerLeft, this, [this] {
        m_hover->clear();
        m_inspector->clearPointer();
    });
    connect(m_view, &SceneView::failed, this, &MainWindow::showFailure);
    connect(m_view, &SceneView::filesDropped, this, [this](const QList<QUrl> &urls) {
        std::vector<std::filesystem::path> files;
        for (const QUrl &url : urls)
            files.emplace_back((url.isLocalFile() ? url.toLocalFile() : url.toString()).toStdU16String());
        openFiles(std::move(files));
    });
}

void MainWindow::setSmoothEdges(bool smooth)
{
    m_smoothEdges = smooth;
    m_view->setSmoothEdges(smooth);
    if (m_observer)
        m_observer->view().setSmoothEdges(smooth);
    if (m_options.remembers)
        QSettings().setValue(QStringLiteral("view/smoothEdges"), smooth);
}

void MainWindow::showFailure(const QString &reason)
{
    m_message->showMessage(reason);
    emit openFailed(reason);
}

void MainWindow::createDocks()
{
    const auto dock = [this](const char *name, const QString &title, QWidget *content) {
        auto *widget = new QDockWidget(title, this);
        widget->setObjectName(QLatin1String(name));
        widget->setWidget(content);
        widget->hide(); // until it has a place
        m_docks.push_back(widget);
        return widget;
    };
    m_comparison = new ComparisonPanel;
    m_inspector = new ViewportInspector(*m_document);
    m_parametersDock = dock("parameters", tr("Parameters"), new ParametersPanel(*m_document));
    // On a small window it scrolls, instead of holding the window open.
    auto *scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setWidget(m_comparison);
    m_comparisonDock = dock("comparison", tr("Comparison"), scroll);
    m_pipelineDock = dock("pipeline", tr("Pipeline"), new PipelinePanel(*m_document));
    m_inspectorDock = dock("inspector", tr("Viewport"), m_inspector);
    m_lifecycleDock = dock("lifecycle", tr("Life of the View"), new LifecyclePanel(*m_lifecycle));
    m_exampleNote = new ExampleNote;
    m_exampleDock = new QDockWidget(tr("Example"), this);
    m_exampleDock->setObjectName(QStringLiteral("example"));
    m_exampleDock->setWidget(m_exampleNote);
    m_exampleDock->hide();
    connect(m_exampleNote, &ExampleNote::closeRequested, m_exampleDock, &QWidget::hide);
    connect(m_exampleNote, &ExampleNote::formulasRequested, this, &MainWindow::showFormulas);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    // The sides keep their full height: numbers stand in columns there.
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
}

void MainWindow::arrangeDocks()
{
    // Where the window is too small for all panels, the view keeps its half of it.
    const bool isWide = width() >= 1180;
    const bool isHigh = height() >= 700;
    for (QDockWidget *dock : m_docks) {
        dock->setFloating(false);
        removeDockWidget(dock);
    }
    if (isWide)
        addDockWidget(Qt::LeftDockWidgetArea, m_parametersDock);
    const bool showsExample = !m_exampleNote->isEmpty();
    addDockWidget(isWide ? Qt::LeftDockWidgetArea : Qt::BottomDockWidgetArea, m_exampleDock);
    if (isWide)
        tabifyDockWidget(m_parametersDock, m_exampleDock);
    m_exampleDock->setVisible(showsExample);
    addDockWidget(Qt::RightDockWidgetArea, m_comparisonDock);
    tabifyDockWidget(m_comparisonDock, m_pipelineDock);
    if (!isWide)
        tabifyDockWidget(m_pipelineDock, m_parametersDock);
    addDockWidget(Qt::BottomDockWidgetArea, m_inspectorDock);
    tabifyDockWidget(m_inspectorDock, m_lifecycleDock);
    for (QDockWidget *dock : m_docks)
        dock->setVisible(isHigh || (dock != m_inspectorDock && dock != m_lifecycleDock));
    m_hidesPanels->setChecked(false);
    m_comparisonDock->raise();
    m_inspectorDock->raise();
    if (isWide)
        resizeDocks({m_parametersDock, m_comparisonDock}, {238, 446}, Qt::Horizontal);
    else
        resizeDocks({m_comparisonDock}, {std::min(446, width() / 2)}, Qt::Horizontal);
    resizeDocks({m_inspectorDock}, {190}, Qt::Vertical);
}

void MainWindow::hidePanels(bool isHidden)
{
    if (isHidden) {
        m_layoutWithPanels = m_isArranged ? saveState(kLayoutVersion) : QByteArray();
        for (QDockWidget *dock : m_docks)
            dock->hide();
    } else if (m_layoutWithPanels.isEmpty() || !restoreState(m_layoutWithPanels, kLayoutVersion)) {
        arrangeDocks();
    }
    m_isArranged = true;
    m_hidesPanels->setChecked(isHidden);
}

void MainWindow::showObserver(bool isShown)
{
    if (!m_observer) {
        if (!isShown)
            return;
        m_observer = new ObserverPanel(*m_document);
        m_observer->view().setSmoothEdges(m_smoothEdges);
        connect(&m_observer->view(), &ObserverView::failed, this, &MainWindow::showFailure);
        m_splitter->addWidget(m_observer);
        const int half = m_splitter->width() / 2;
        m_splitter->setSizes({half, half});
    }
    m_observer->setVisible(isShown);
}

void MainWindow::createStatusBar()
{
    m_hover = new QLabel;
    m_hover->setAccessibleName(tr("World coordinate under the pointer"));
    m_hover->setToolTip(tr("World coordinate under the pointer, with the digits that are certain"));
    m_camera = new QLabel;
    m_camera->setAccessibleName(tr("Projection"));
    m_camera->setToolTip(tr("Projection and distances of the near and far planes, world units"));
    statusBar()->addWidget(m_hover, 1);
    statusBar()->addPermanentWidget(m_camera);
}

void MainWindow::showHover(const WidgetPoint &position, const DepthSample &sample)
{
    m_inspector->setPointer(position);
    const Result<Pick> pick = m_document->unprojected(position, sample);
    if (!pick || (pick->hit && !pick->point.world[Method::Formula])) {
        m_hover->clear();
        return;
    }
    const QString pixel = tr("pixel (%1, %2)").arg(pick->devicePixel.i).arg(pick->devicePixel.j);
    if (!pick->hit) {
        m_hover->setText(tr("background, %1").arg(pixel));
        return;
    }
    const int decimals = certainDecimals(pick->certainty.radius());
    m_hover->setText(tr("world %1, %2").arg(pointText(*pick->point.world[Method::Formula], decimals), pixel));
}

void MainWindow::showCamera()
{
    const Projection &projection = m_document->geometry().projection();
    const ProjectionWindow w = projectionWindow(projection);
    m_projectionAction->setChecked(isPerspective(projection));
    m_camera->setText(tr("%1, near %2, far %3")
                          .arg(isPerspective(projection) ? tr("Perspective") : tr("Orthographic"),
                               significantText(w.nearDistance, 4), significantText(w.farDistance, 4)));
}

void MainWindow::restoreLayout()
{
    if (!m_options.remembers)
        return;
    const QSettings settings;
    m_comparison->setShowsFloat(settings.value(QStringLiteral("comparison/showsFloat"), false).toBool());
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    const QByteArray state = settings.value(QStringLiteral("window/state")).toByteArray();
    if (state.isEmpty())
        return;
    arrangeDocks(); // every dock needs a place before a kept one can be given to it
    m_isArranged = restoreState(state, kLayoutVersion);
}

void MainWindow::showEvent(QShowEvent *event)
{
    // Only now the window has the size that the arrangement goes by.
    if (!std::exchange(m_isArranged, true))
        arrangeDocks();
    QMainWindow::showEvent(event);
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (!mayLeaveScene()) {
        event->ignore();
        return;
    }
    if (m_autosave)
        m_autosave->discard();
    if (m_options.remembers) {
        QSettings settings;
        settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
        settings.setValue(QStringLiteral("window/state"), saveState(kLayoutVersion));
        settings.setValue(QStringLiteral("comparison/showsFloat"), m_comparison->showsFloat());
    }
    QMainWindow::closeEvent(event);
}

} // namespace unprojector::gui
