#include "gui/shell/main_window.h"

#include "core/lessons/lesson.h"
#include "gui/document/overwriting.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/shell/features.h"
#include "gui/shell/focus_return.h"
#include "gui/shell/language_menu.h"
#include "gui/shell/overlay_bars.h"
#include "gui/shell/picture_note.h"
#include "gui/shell/status_bar.h"
#include "gui/shell/status_readout.h"
#include "gui/shell/stretch_bar.h"
#include "gui/shell/window_menus.h"
#include "gui/shell/window_questions.h"
#include "gui/text/error_text.h"
#include "gui/view/scene_view.h"
#include "gui/widgets/icons.h"
#include "gui/window/feature.h"
#include "gui/window/kept_bytes.h"
#include "gui/window/view_frame.h"

#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QGuiApplication>
#include <QMenu>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>
#include <QUrl>

#include <algorithm>
#include <set>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;

namespace {

constexpr char kGeometryKey[] = "window/geometry";

/// A comfortable size, but within the screen including a frame and a title.
QSize startSize()
{
    constexpr QSize kComfortable(1280, 800), kFrame(16, 48);
    return kComfortable.boundedTo(QGuiApplication::primaryScreen()->availableSize() - kFrame);
}

} // namespace

MainWindow::MainWindow(const Options &options, QWidget *parent)
    : Window(parent), m_options(options), m_document(new SceneDocument(this)),
      m_questions(std::make_unique<WindowQuestions>(*this)),
      m_session(
          new Session(*m_document, *m_questions, {options.remembers, options.recoveryFolder, options.autosave}, this)),
      m_view(new SceneView(*m_document)), m_frame(new ViewFrame(*m_view)), m_message(new MessageBar)
{
    setWindowTitle(tr("Unprojector") + QStringLiteral("[*]"));
    setWindowIcon(programIcon());
    resize(startSize());
    setCentralWidget(m_frame);
    setStatusBar(new StatusBar);
    createView();
    createFeatures();
    returnFocus();
    new StatusReadout(*this);
    connectSession();
    restoreLayout();
}

MainWindow::~MainWindow()
{
    delete m_session; // its undo stack is cleared at the end; unsaved changes must not be forgotten then
    delete m_view;    // it reports its end to a feature's log
    qDeleteAll(findChildren<QDockWidget *>()); // panels show objects that features own
    qDeleteAll(std::exchange(m_features, {}));
}

void MainWindow::createView()
{
    const bool chosen = !m_options.remembers || QSettings().value(QStringLiteral("view/smoothEdges"), true).toBool();
    m_hasSmoothEdges = m_options.smoothEdges.value_or(chosen);
    m_view->setSmoothEdges(m_hasSmoothEdges);
    m_view->setModelStore(m_session->models());
    connect(m_view, &SceneView::hovered, this, [this](const PixelClick &click) { emit pointed(click); });
    connect(m_view, &SceneView::pointerLeft, this, [this] { emit pointed(std::nullopt); });
    connect(m_view, &SceneView::failed, this, &MainWindow::showFailure);
    connect(m_view, &SceneView::filesDropped, this, [this](const QList<QUrl> &urls) {
        std::vector<std::filesystem::path> files;
        for (const QUrl &url : urls)
            files.emplace_back((url.isLocalFile() ? url.toLocalFile() : url.toString()).toStdU16String());
        m_session->openFiles(std::move(files));
    });
}

void MainWindow::createFeatures()
{
    auto *recovery = new RecoveryBar;
    auto *loading = new LoadingBar;
    m_frame->addBar(*recovery);
    m_frame->addBar(*m_message);
    auto *stretch = new StretchBar(*m_document);
    m_frame->addBar(*stretch);
    connect(this, &Window::stepShown, stretch, [stretch](const lessons::Step *step) { stretch->setInLesson(step); });
    m_frame->add(*new PictureNote(*m_document, m_frame), Qt::AlignCenter);
    m_features = makeFeatures(*this);
    m_frame->add(*loading, Qt::AlignBottom | Qt::AlignHCenter);
    for (QWidget *bar : std::initializer_list<QWidget *>{stretch, recovery, m_message, loading})
        bar->raise();
    connectBars(*loading, *recovery);

    std::vector<PanelSpec> panels;
    std::vector<WorkspaceSpec> workspaces;
    for (Feature *feature : m_features) {
        for (PanelSpec &panel : feature->panels())
            panels.push_back(std::move(panel));
        if (auto workspace = feature->workspace())
            workspaces.push_back(std::move(*workspace));
        if (ViewTool *tool = feature->tool())
            m_view->setTool(*tool);
    }
    m_workspaces = new Workspaces(*this, std::move(panels), std::move(workspaces));
    m_menus = new WindowMenus(*this, m_features, *m_message, m_options.translation);
    connect(m_menus, &WindowMenus::smoothEdgesChosen, this, &MainWindow::setSmoothEdges);
}

void MainWindow::returnFocus()
{
    std::vector<QWidget *> areas{m_frame, &m_workspaces->dock(Panel::Landmarks), &m_workspaces->dock(Panel::Series)};
    for (QToolBar *bar : findChildren<QToolBar *>(QString(), Qt::FindDirectChildrenOnly))
        areas.push_back(bar);
    new FocusReturn(*m_view, std::move(areas));
}

void MainWindow::connectSession()
{
    connect(&m_document->picks(), &Picks::failed, this, [this](const Error &error) { showMessage(errorText(error)); });
    connect(m_session, &Session::changed, this, &MainWindow::showName);
    connect(m_session, &Session::opened, this, &MainWindow::showName);
    connect(m_session, &Session::failed, this, &MainWindow::showFailure);
    connect(m_session, &Session::noticed, this, &MainWindow::notice);
    connect(m_session, &Session::warned, this, &MainWindow::showMessage);
    connect(m_session, &Session::progressed, m_message, &QWidget::hide);
}

void MainWindow::connectBars(LoadingBar &loading, RecoveryBar &recovery)
{
    // Queued: it may be emitted while the view is painted.
    connect(m_view, &SceneView::drawingProgressed, &loading, &LoadingBar::setDrawn, Qt::QueuedConnection);
    connect(m_session, &Session::loadingStarted, &loading, &LoadingBar::start);
    connect(m_session, &Session::loadingProgressed, &loading, &LoadingBar::setProgress);
    connect(m_session, &Session::loadingEnded, &loading, [this, &loading] { loading.finish(!m_view->awaitPicture()); });
    connect(&loading, &LoadingBar::cancelRequested, m_session, &Session::cancelLoading);

    connect(m_session, &Session::offeredChanged, &recovery,
            [this, &recovery] { recovery.offer(m_session->offered()); });
    // The scene being recovered stays offered until it is shown, and can be chosen only once.
    connect(m_session, &Session::loadingStarted, &recovery, [&recovery] { recovery.setEnabled(false); });
    connect(m_session, &Session::loadingEnded, &recovery, [&recovery] { recovery.setEnabled(true); });
    connect(&recovery, &RecoveryBar::recoverRequested, m_session,
            [this](int index) { m_session->recover(static_cast<std::size_t>(index)); });
    connect(&recovery, &RecoveryBar::discardRequested, m_session,
            [this](int index) { m_session->discardOffered(static_cast<std::size_t>(index)); });
    connect(&recovery, &RecoveryBar::laterRequested, m_session, &Session::postponeOffered);
}

void MainWindow::setSmoothEdges(bool isSmooth)
{
    m_hasSmoothEdges = isSmooth;
    m_view->setSmoothEdges(isSmooth);
    emit smoothEdgesChanged(isSmooth);
    if (m_options.remembers)
        QSettings().setValue(QStringLiteral("view/smoothEdges"), isSmooth);
}

void MainWindow::setViewSize(const QSize &wanted)
{
    // The panels keep their sizes, so that the view gets the window's growth. At the panels' limits
    // they don't, so several trials are needed.
    constexpr int kTrials = 4;
    for (int trial = 0; trial < kTrials && m_view->size() != wanted; ++trial) {
        resize(size() + wanted - m_view->size());
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    }
}

void MainWindow::showMessage(const QString &text)
{
    m_message->addMessage(text);
}

void MainWindow::showFailure(const QString &reason)
{
    showMessage(reason);
    emit openFailed(reason);
}

void MainWindow::notice(const QString &text)
{
    constexpr int kMilliseconds = 12000;
    statusBar()->showMessage(text, kMilliseconds);
}

ScanList &MainWindow::scans()
{
    const auto found =
        std::find_if(m_features.begin(), m_features.end(), [](Feature *feature) { return feature->scans(); });
    Q_ASSERT(found != m_features.end());
    return *(*found)->scans();
}

QString MainWindow::message() const
{
    return m_message->isHidden() ? QString() : m_message->text();
}

void MainWindow::showName()
{
    setWindowTitle(tr("%1[*] – Unprojector").arg(m_session->name()));
    // File dialogs start in its folder.
    setWindowFilePath(pathText(m_session->file().empty() ? m_session->proposedName() : m_session->file()));
    setWindowModified(m_session->hasUnsavedChanges());
}

bool MainWindow::mayExportTo(const std::filesystem::path &file)
{
    const QString refusal = overwritingText(*m_document, *m_session, file);
    if (!refusal.isEmpty())
        showFailure(refusal);
    return refusal.isEmpty();
}

void MainWindow::follow(const lessons::Link &link)
{
    static_cast<void>(
        std::any_of(m_features.begin(), m_features.end(), [&link](Feature *feature) { return feature->follow(link); }));
}

void MainWindow::showStep(const lessons::Step *step)
{
    m_view->setHighlights(step ? step->highlights : std::set<lessons::Highlight>());
    m_view->setHasDropLabels(!step); // a lesson may ask for such a coordinate
    emit stepShown(step);
}

Window::State MainWindow::state()
{
    State state{m_workspaces->layout(), {}};
    for (const Feature *feature : m_features)
        state.features.push_back(feature->state());
    return state;
}

void MainWindow::restore(const State &state)
{
    for (std::size_t i = 0; i < m_features.size(); ++i)
        m_features[i]->restore(state.features[i]);
    m_workspaces->restore(state.layout);
}

QMenu *MainWindow::createPopupMenu()
{
    auto *menu = new QMenu(this);
    for (QDockWidget *dock : m_workspaces->sharedDocks())
        menu->addAction(dock->toggleViewAction());
    menu->addSeparator();
    for (QToolBar *bar : findChildren<QToolBar *>(QString(), Qt::FindDirectChildrenOnly))
        menu->addAction(bar->toggleViewAction());
    return menu;
}

void MainWindow::restoreLayout()
{
    if (!m_options.remembers)
        return;
    const QSettings settings;
    restoreGeometry(unsealed(settings.value(QLatin1String(kGeometryKey)), kGeometryKey));
    m_workspaces->restore(settings);
    for (Feature *feature : m_features)
        feature->restore(settings);
}

void MainWindow::keepLayout() const
{
    if (!m_options.remembers)
        return;
    QSettings settings;
    settings.setValue(QLatin1String(kGeometryKey), sealed(saveGeometry(), kGeometryKey));
    m_workspaces->keep(settings);
    for (const Feature *feature : m_features)
        feature->keep(settings);
}

void MainWindow::resizeEvent(QResizeEvent *event)
{
    Window::resizeEvent(event);
    m_menus->fitToolBar();
    m_workspaces->windowResized();
}

void MainWindow::showEvent(QShowEvent *event)
{
    Window::showEvent(event);
    m_workspaces->windowResized();
    if (m_options.translation && message().isEmpty()) // not sooner: opening clears earlier messages
        tellOfFont(*this, *m_options.translation);
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (!m_session->mayLeave()) {
        event->ignore();
        return;
    }
    m_session->end();
    emit closing();
    keepLayout();
    Window::closeEvent(event);
}

} // namespace unprojector::gui
