#include "gui/shell/main_window.h"

#include "gui/click/comparison_panel.h"
#include "gui/doctor/doctor_panel.h"
#include "gui/document/point_files.h"
#include "gui/document/scene_curves.h"
#include "gui/document/scene_document.h"
#include "gui/landmarks/curve_waiting.h"
#include "gui/landmarks/landmark_tool.h"
#include "gui/landmarks/point_templates.h"
#include "gui/landmarks/points_panel.h"
#include "gui/landmarks/save_name.h"
#include "gui/landmarks/scan_series.h"
#include "gui/lessons/lesson_player.h"
#include "gui/map/map_overlay.h"
#include "gui/map/map_panel.h"
#include "gui/outside/observer_panel.h"
#include "gui/outside/observer_view.h"
#include "gui/parameters/parameters_panel.h"
#include "gui/pipeline/viewport_inspector.h"
#include "gui/shell/overlay_bars.h"
#include "gui/shell/picture_note.h"
#include "gui/shell/place_ids.h"
#include "gui/shell/scene_files.h"
#include "gui/shell/window_questions.h"
#include "gui/shell/work_places.h"
#include "gui/text/error_text.h"
#include "gui/text/number_text.h"
#include "gui/view/lifecycle_log.h"
#include "gui/view/scene_view.h"
#include "gui/widgets/digits_font.h"
#include "gui/widgets/icons.h"

#include <QCloseEvent>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
namespace {

/// As large as is comfortable, but within the screen with a frame and a title around it.
QSize startSize()
{
    constexpr QSize kComfortable(1280, 800), kFrame(16, 48);
    return kComfortable.boundedTo(QGuiApplication::primaryScreen()->availableSize() - kFrame);
}

} // namespace

MainWindow::MainWindow(const Options &options, QWidget *parent)
    : QMainWindow(parent), m_options(options), m_document(new SceneDocument(this)),
      m_questions(std::make_unique<WindowQuestions>(*this)), m_templates(std::make_unique<PointTemplates>()),
      m_pointFiles(new PointFiles(*m_document, options.remembers ? m_questions.get() : nullptr, this)),
      m_session(
          new Session(*m_document, *m_questions, {options.remembers, options.recoveryFolder, options.autosave}, this)),
      m_series(new ScanSeries(*m_document, *m_session, this)), m_lifecycle(new LifecycleLog(this)),
      m_lessons(new LessonPlayer(*m_document, *m_session, this))
{
    setWindowTitle(tr("Unprojector") + QStringLiteral("[*]"));
    setWindowIcon(programIcon());
    resize(startSize());
    const bool chosen = !options.remembers || QSettings().value(QStringLiteral("view/smoothEdges"), true).toBool();
    m_smoothEdges = options.smoothEdges.value_or(chosen);

    m_viewFrame = new QWidget;
    m_center = new QGridLayout(m_viewFrame);
    m_center->setContentsMargins(0, 0, 0, 0);
    setCentralWidget(m_viewFrame);
    m_recovery = new RecoveryBar;
    m_message = new MessageBar;
    m_loading = new LoadingBar;
    createPanels();
    createStatusBar();
    createActions();
    createView();
    createOverlays();
    connectPanels();
    showCamera();

    connect(m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Pick && m_document->pick())
            showFirstSteps(false);
        if (changes & Change::Picture)
            showCamera();
    });
    connect(m_document, &SceneDocument::pickFailed, this,
            [this](const Error &error) { m_message->showMessage(errorText(error)); });
    if (options.remembers) // somebody is there to wait
        m_document->curves().setWaiting([this] { return waitForCurves(*this, *m_document); });
    connectSession();
    restoreLayout();
    if (options.remembers && !QSettings().value(QStringLiteral("firstSteps/areDone"), false).toBool())
        showFirstSteps(true);
}

MainWindow::~MainWindow()
{
    // The undo stack is emptied when it ends; unsaved changes must not be forgotten then.
    m_document->disconnect(this);
    delete m_session;
    delete m_map; // its colours lie on the view
    // The view tells the log of its end, so it goes while the log is there.
    delete m_view;
}

void MainWindow::connectSession()
{
    connect(m_session, &Session::changed, this, &MainWindow::showName);
    connect(m_session, &Session::opened, this, &MainWindow::showName);
    connect(m_session, &Session::failed, this, &MainWindow::showFailure);
    connect(m_session, &Session::noticed, this,
            [this](const QString &text) { statusBar()->showMessage(text, kNoticeMilliseconds); });
    connect(m_session, &Session::pointFilesOpened, this, [this](const std::vector<std::filesystem::path> &files) {
        for (const std::filesystem::path &file : files) {
            if (!PointFiles::isTemplate(file))
                m_pointFiles->importFrom(file);
        }
    });
    connect(m_series, &ScanSeries::failed, this, &MainWindow::showFailure);
    connect(m_series, &ScanSeries::warned, m_session, &Session::warned);
    connect(m_series, &ScanSeries::noticed, m_session, &Session::noticed);
    connect(m_pointFiles, &PointFiles::failed, this, &MainWindow::showFailure);
    connect(m_pointFiles, &PointFiles::noticed, m_session, &Session::noticed);
    connect(m_session, &Session::recentFilesChanged, this, &MainWindow::updateRecentMenu);
    connect(m_lessons, &LessonPlayer::changed, this, &MainWindow::showLesson);
    connect(m_lessons, &LessonPlayer::revealed, this, [this] {
        showPanelsOfStep();
        m_places->show(kLessonPanel); // which says why it is so, where they are tabs of one column
    });
    connect(m_lessons, &LessonPlayer::clickWanted, this, [this](const std::string &point) {
        followLessonLink(QStringLiteral("click"), QString::fromStdString(point));
    });
    connect(m_lessons, &LessonPlayer::failed, this, &MainWindow::showFailure);
    m_viewTimer.setSingleShot(true);
    m_viewTimer.setInterval(kSettlingMilliseconds);
    connect(&m_viewTimer, &QTimer::timeout, this, &MainWindow::fitViewOfLesson);
    connect(&m_document->rayCasters(), &RayCasters::progressed, this, &MainWindow::showPreparing);
    connect(&m_document->rayCasters(), &RayCasters::finished, this, [this] {
        m_sincePreparing.invalidate();
        m_preparing->hide();
    });
}

void MainWindow::connectPanels()
{
    connect(m_comparison, &ComparisonPanel::pickRequested, m_view, &SceneView::onLButtonDown);
    connect(m_doctor, &DoctorPanel::pickRequested, m_view, &SceneView::pickPixel);
    connect(m_landmarkTool, &LandmarkTool::placingChanged, m_placingAction, &QAction::setChecked);
    connect(m_landmarkTool, &LandmarkTool::placingChanged, m_pointsPanel, &PointsPanel::setPlacing);
    connect(m_pointsPanel, &PointsPanel::placingRequested, m_placingAction,
            [this] { m_placingAction->setChecked(true); });
    // Queued: it may be told while the view is painted.
    connect(m_view, &SceneView::drawingProgressed, m_loading, &LoadingBar::setDrawn, Qt::QueuedConnection);
    connect(m_session, &Session::typedToCount, m_parameters, &ParametersPanel::applyTyped);
    connect(m_session, &Session::warned, m_message, &MessageBar::showMessage);
    connect(m_session, &Session::progressed, m_message, &QWidget::hide);
    connect(m_pointFiles, &PointFiles::warned, m_message, &MessageBar::showMessage);

    connect(m_session, &Session::loadingStarted, m_loading, &LoadingBar::start);
    connect(m_session, &Session::loadingProgressed, m_loading, &LoadingBar::setProgress);
    connect(m_session, &Session::loadingEnded, m_loading, [this] { m_loading->finish(!m_view->awaitPicture()); });
    connect(m_loading, &LoadingBar::cancelRequested, m_session, &Session::cancelLoading);

    connect(m_session, &Session::offeredChanged, m_recovery, [this] { m_recovery->offer(m_session->offered()); });
    // What is being recovered stays offered until it is shown, and is asked for once.
    connect(m_session, &Session::loadingStarted, m_recovery, [this] { m_recovery->setEnabled(false); });
    connect(m_session, &Session::loadingEnded, m_recovery, [this] { m_recovery->setEnabled(true); });
    connect(m_recovery, &RecoveryBar::recoverRequested, m_session,
            [this](int place) { m_session->recover(static_cast<std::size_t>(place)); });
    connect(m_recovery, &RecoveryBar::discardRequested, m_session,
            [this](int place) { m_session->discardOffered(static_cast<std::size_t>(place)); });
    connect(m_recovery, &RecoveryBar::laterRequested, m_session, &Session::postponeOffered);
}

void MainWindow::createView()
{
    m_view = new SceneView(*m_document);
    m_landmarkTool = new LandmarkTool(*m_document, *m_view);
    m_view->setTool(*m_landmarkTool);
    m_view->setSmoothEdges(m_smoothEdges);
    m_view->setModelStore(m_session->models());
    m_center->addWidget(m_view, 0, 0);
    connect(m_view, &SceneView::happened, m_lifecycle, &LifecycleLog::append);
    connect(m_view, &SceneView::hovered, this, &MainWindow::showHover);
    connect(m_view, &SceneView::pointerLeft, this, [this] {
        m_hover->clear();
        m_inspector->clearPointer();
        m_map->setPointer(std::nullopt);
    });
    connect(m_view, &SceneView::failed, this, &MainWindow::showFailure);
    connect(m_view, &SceneView::filesDropped, this, [this](const QList<QUrl> &urls) {
        std::vector<std::filesystem::path> files;
        for (const QUrl &url : urls)
            files.emplace_back((url.isLocalFile() ? url.toLocalFile() : url.toString()).toStdU16String());
        m_session->openFiles(std::move(files));
    });
}

void MainWindow::createOverlays()
{
    // A layout, not a widget: beside what stands in it the view is clicked.
    m_overlays = new QVBoxLayout;
    m_overlays->setSpacing(0);
    m_overlays->addWidget(m_recovery);
    m_overlays->addWidget(m_message);
    m_overlays->addStretch();
    m_center->addLayout(m_overlays, 0, 0);
    m_center->addWidget(m_loading, 0, 0, Qt::AlignBottom | Qt::AlignHCenter);
    auto *note = new PictureNote(*m_document, m_viewFrame);
    m_center->addWidget(note, 0, 0, Qt::AlignCenter);
    note->raise();
    m_map = new MapOverlay(*m_document, *m_view);
    m_center->addWidget(&m_map->panel(), 0, 0, Qt::AlignTop | Qt::AlignRight);
    m_map->panel().raise();
    m_view->setCornerWidget(&m_map->panel());
    connect(m_map, &MapOverlay::closeRequested, this, [this] { m_mapAction->setChecked(false); });
    connect(&m_map->panel(), &MapPanel::exportRequested, this, &MainWindow::exportMap);
    for (QWidget *bar :
         {static_cast<QWidget *>(m_recovery), static_cast<QWidget *>(m_message), static_cast<QWidget *>(m_loading)})
        bar->raise();
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

void MainWindow::setViewSize(const QSize &wanted)
{
    // The panels keep their sizes, so that what the window gains is the view's. At the edge of what they can, they do not.
    constexpr int kTrials = 4;
    for (int trial = 0; trial < kTrials && m_view->size() != wanted; ++trial) {
        resize(size() + wanted - m_view->size());
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    }
}

void MainWindow::showFailure(const QString &reason)
{
    m_message->showMessage(reason);
    emit openFailed(reason);
}

QString MainWindow::message() const
{
    return m_message->isHidden() ? QString() : m_message->text();
}

void MainWindow::showName()
{
    setWindowTitle(tr("%1[*] – Unprojector").arg(m_session->name()));
    setWindowModified(m_session->hasUnsavedChanges());
}

bool MainWindow::mayExportTo(const std::filesystem::path &file)
{
    const QString refusal = overwritingText(*m_document, *m_session, file);
    if (!refusal.isEmpty())
        showFailure(refusal);
    return refusal.isEmpty();
}

void MainWindow::exportMap()
{
    const SaveName named =
        askSaveName(*this, tr("Export Map"), {tr("Picture with its scale (*.png)"), tr("Float map (*.pfm)")},
                    pathText(m_session->proposedName().stem()) + QStringLiteral("-map"));
    if (named.file.empty() || !mayExportTo(named.file))
        return;
    if (const QString problem = m_map->exportTo(named.file); !problem.isEmpty())
        showFailure(problem);
    else
        statusBar()->showMessage(tr("Map written to %1").arg(pathText(named.file.filename())), kNoticeMilliseconds);
}

void MainWindow::createStatusBar()
{
    m_hover = new QLabel;
    m_hover->setAccessibleName(tr("World coordinate under the pointer"));
    m_hover->setToolTip(tr("World coordinate under the pointer, with the digits that its pixel leaves certain"));
    // An empty label asks for another height than one with text, and the view would change its size with it.
    m_hover->setMinimumHeight(
        std::max(m_hover->sizeHint().height(), lineHeight(m_hover->font(), tr("background, %1"))));
    m_camera = new QLabel;
    m_camera->setAccessibleName(tr("Projection"));
    m_camera->setToolTip(tr("Projection and distances of the near and far planes, world units"));
    statusBar()->addWidget(m_hover, 1);
    m_preparing = new QLabel;
    m_preparing->setAccessibleName(tr("Preparing the ray on the mesh"));
    m_preparing->setToolTip(
        tr("Clicks have the depth buffer's answer already; the ray's comes when the model is prepared "
           "for it"));
    m_preparing->hide();
    statusBar()->addPermanentWidget(m_preparing);
    statusBar()->addPermanentWidget(m_camera);
}

void MainWindow::showPreparing(double share)
{
    constexpr qint64 kUnnoticedMilliseconds = 500;
    if (!m_sincePreparing.isValid())
        m_sincePreparing.start();
    m_preparing->setText(tr("Preparing the ray on the mesh: %1 %").arg(static_cast<int>(100.0 * share)));
    m_preparing->setVisible(m_sincePreparing.hasExpired(kUnnoticedMilliseconds));
}

void MainWindow::showHover(const PixelClick &click)
{
    m_inspector->setPointer(click.position);
    m_map->setPointer(click.position);
    const Result<Pick> pick = m_document->unprojected(click);
    if (!pick || (pick->hit() && !pick->point.world[Method::Formula])) {
        m_hover->clear();
        return;
    }
    const QString pixel = tr("pixel (%1, %2)").arg(click.pixel.i).arg(click.pixel.j);
    if (!pick->hit()) {
        m_hover->setText(tr("background, %1").arg(pixel));
        return;
    }
    // All to the same place, as far as the least certain of them is.
    const WorldVector &open = pick->withinPixel.world;
    const double most = std::max({open.x, open.y, open.z});
    m_hover->setText(
        tr("world %1, %2").arg(pointText(*pick->point.world[Method::Formula], WorldVector(most, most, most)), pixel));
}

void MainWindow::showCamera()
{
    const Projection &projection = m_document->geometry().projection();
    const ProjectionWindow w = projectionWindow(projection);
    m_projectionAction->setChecked(isPerspective(projection));
    const QString kind = isPerspective(projection)                       ? tr("Perspective")
                         : kindOf(projection) == ProjectionKind::Oblique ? tr("Oblique")
                                                                         : tr("Orthographic");
    m_camera->setText(
        tr("%1, near %2, far %3").arg(kind, writtenText(w.nearDistance, 4), writtenText(w.farDistance, 4)));
}

void MainWindow::resizeEvent(QResizeEvent *event)
{
    QMainWindow::resizeEvent(event);
    fitToolBar();
    m_places->windowResized();
}

void MainWindow::showEvent(QShowEvent *event)
{
    QMainWindow::showEvent(event);
    m_places->windowResized();
    tellOfFont(); // not sooner: what is opened takes away what was said before
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (!m_session->mayLeave()) {
        event->ignore();
        return;
    }
    m_session->end();
    m_lessons->end(); // its window and panels are not what the user wants the next time
    keepLayout();
    QMainWindow::closeEvent(event);
}

} // namespace unprojector::gui
