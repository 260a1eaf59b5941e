#include "gui/main_window.h"

#include "core/bundled_scene.h"
#include "gui/error_text.h"
#include "gui/number_text.h"
#include "gui/overlay_bars.h"
#include "gui/panels/comparison_panel.h"
#include "gui/recent_files.h"
#include "gui/scene_document.h"
#include "gui/scene_view.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QFileDialog>
#include <QGridLayout>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>
#include <QUrl>

#include <cmath>

namespace unprojector {
namespace {

constexpr int kSmoothSamples = 4;
/// Raised when docks or tool bars change, so that an old layout is not put onto a new window.
constexpr int kLayoutVersion = 1;

std::filesystem::path pathFromQString(const QString &text)
{
    return std::filesystem::path(text.toStdU16String());
}

} // namespace

MainWindow::MainWindow(const Options &options, QWidget *parent)
    : QMainWindow(parent), m_options(options), m_document(new SceneDocument(this)), m_loader(new ModelLoader(this))
{
    setWindowTitle(tr("Unprojector"));
    resize(1280, 800);

    auto *central = new QWidget;
    m_center = new QGridLayout(central);
    m_center->setContentsMargins(0, 0, 0, 0);
    m_message = new MessageBar;
    m_loading = new LoadingBar;
    setCentralWidget(central);

    auto *dock = new QDockWidget(tr("Comparison"), this);
    dock->setObjectName(QStringLiteral("comparison"));
    m_comparison = new ComparisonPanel;
    dock->setWidget(m_comparison);
    addDockWidget(Qt::RightDockWidgetArea, dock);
    resizeDocks({dock}, {440}, Qt::Horizontal);

    const QSettings settings;
    const bool smooth = options.remembers && settings.value(QStringLiteral("view/smoothEdges"), false).toBool();
    createView(options.samples >= 0 ? options.samples : smooth ? kSmoothSamples : 0);
    createActions();
    createStatusBar();

    connect(m_document, &SceneDocument::pickChanged, this, [this] { m_comparison->setPick(m_document->pick()); });
    connect(m_document, &SceneDocument::pickFailed, this, [this](const Error &error) { m_message->showMessage(errorText(error)); });
    connect(m_document, &SceneDocument::geometryChanged, this, &MainWindow::showCamera);
    connect(m_loader, &ModelLoader::started, m_loading, &LoadingBar::start);
    connect(m_loader, &ModelLoader::progressed, m_loading, &LoadingBar::setProgress);
    connect(m_loader, &ModelLoader::finished, this, &MainWindow::takeLoaded);
    connect(m_loader, &ModelLoader::cancelled, this, [this] {
        m_loading->finish();
        emit loadingEnded();
    });
    connect(m_loading, &LoadingBar::cancelRequested, m_loader, &ModelLoader::cancel);

    restoreLayout();
    showCamera();
}

MainWindow::~MainWindow() = default;

void MainWindow::createView(int samples)
{
    delete m_view;
    m_view = new SceneView(*m_document, samples);
    m_center->addWidget(m_view, 0, 0);
    m_center->addWidget(m_message, 0, 0, Qt::AlignTop);
    m_center->addWidget(m_loading, 0, 0, Qt::AlignBottom | Qt::AlignHCenter);
    m_message->raise();
    m_loading->raise();
    connect(m_view, &SceneView::clicked, m_document, &SceneDocument::pickAt);
    connect(m_view, &SceneView::hovered, this, &MainWindow::showHover);
    connect(m_view, &SceneView::pointerLeft, this, [this] { m_hover->clear(); });
    connect(m_view, &SceneView::failed, this, [this](const QString &reason) {
        m_message->showMessage(reason);
        emit openFailed(reason);
    });
    connect(m_view, &SceneView::filesDropped, this, [this](const QList<QUrl> &urls) {
        std::vector<std::filesystem::path> files;
        for (const QUrl &url : urls)
            files.push_back(pathFromQString(url.isLocalFile() ? url.toLocalFile() : url.toString()));
        openFiles(std::move(files));
    });
}

void MainWindow::createActions()
{
    const auto action = [this](QMenu *menu, const QString &text, const QList<QKeySequence> &keys, const QString &tip, auto slot) {
        QAction *a = menu->addAction(text);
        a->setShortcuts(keys);
        a->setToolTip(keys.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, keys.first().toString(QKeySequence::NativeText)));
        a->setStatusTip(tip);
        connect(a, &QAction::triggered, this, slot);
        return a;
    };
    const auto look = [this](StandardView side) {
        return [this, side] { m_document->setCamera(seenFrom(m_document->geometry().camera, side)); };
    };

    QMenu *file = menuBar()->addMenu(tr("&File"));
    QAction *open = action(file, tr("&Open…"), {QKeySequence::Open}, tr("Open model files"), [this] { askForFiles(); });
    m_recentMenu = file->addMenu(tr("Open &Recent"));
    action(file, tr("&Bundled Scene"), {}, tr("Show the scene that comes with the program"), [this] { openBundledScene(); });
    file->addSeparator();
    action(file, tr("&Quit"), {QKeySequence::Quit}, tr("Close the window"), [this] { close(); });
    updateRecentMenu();

    QMenu *view = menuBar()->addMenu(tr("&View"));
    QAction *fit = action(view, tr("&Fit"), {Qt::Key_F}, tr("Move the camera until all objects fill the view"), [this] { m_document->fit(); });
    QAction *home = action(view, tr("&Home"), {Qt::Key_Home}, tr("Back to the camera that the scene opened with"), [this] { m_document->goHome(); });
    view->addSeparator();
    QAction *front = action(view, tr("Fr&ont"), {Qt::Key_1}, tr("Look from the front, along −z"), look(StandardView::Front));
    QAction *right = action(view, tr("&Right"), {Qt::Key_3}, tr("Look from the right, along −x"), look(StandardView::Right));
    QAction *top = action(view, tr("&Top"), {Qt::Key_7}, tr("Look from the top, along −y"), look(StandardView::Top));
    action(view, tr("B&ack"), {Qt::CTRL | Qt::Key_1}, tr("Look from the back, along z"), look(StandardView::Back));
    action(view, tr("&Left"), {Qt::CTRL | Qt::Key_3}, tr("Look from the left, along x"), look(StandardView::Left));
    action(view, tr("Botto&m"), {Qt::CTRL | Qt::Key_7}, tr("Look from below, along y"), look(StandardView::Bottom));
    view->addSeparator();
    m_projectionAction = action(view, tr("&Perspective"), {Qt::Key_5}, tr("Switch between perspective (glFrustum) and orthographic (glOrtho)"),
                                [this] { m_document->switchProjection(); });
    m_projectionAction->setCheckable(true);
    view->addSeparator();
    QAction *smooth = action(view, tr("&Smooth Edges"), {}, tr("Multisampling: smoother edges, but a depth is then read at a sample beside the pixel's centre"), [] {});
    smooth->setCheckable(true);
    smooth->setChecked(m_view->format().samples() > 0);
    connect(smooth, &QAction::toggled, this, [this](bool on) {
        createView(on ? kSmoothSamples : 0);
        if (m_options.remembers)
            QSettings().setValue(QStringLiteral("view/smoothEdges"), on);
    });
    view->addSeparator();
    for (QDockWidget *dock : findChildren<QDockWidget *>())
        view->addAction(dock->toggleViewAction());

    QMenu *help = menuBar()->addMenu(tr("&Help"));
    action(help, tr("&Mouse and Keys"), {QKeySequence::HelpContents}, tr("How to move the camera and pick points"), [this] { showControls(); });
    action(help, tr("&About Unprojector"), {}, tr("What this program is"), [this] { showAbout(); });

    QToolBar *bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tools"));
    bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    bar->addAction(open);
    bar->addSeparator();
    bar->addActions({fit, home});
    bar->addSeparator();
    bar->addActions({front, right, top});
    bar->addSeparator();
    bar->addAction(m_projectionAction);
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

void MainWindow::openBundledScene()
{
    setWindowTitle(tr("Bundled scene – Unprojector"));
    m_document->setObjects(bundledScene(), {WorldPoint(6.5, 5.0, 10.5), WorldPoint(0.5, 0.9, 0.0), {0.0, 1.0, 0.0}});
}

void MainWindow::askForFiles()
{
    const QStringList names = QFileDialog::getOpenFileNames(this, tr("Open Models"), {}, modelFileFilter() + QStringLiteral(";;") + tr("All files (*)"));
    std::vector<std::filesystem::path> files;
    for (const QString &name : names)
        files.push_back(pathFromQString(name));
    if (!files.empty())
        openFiles(std::move(files));
}

void MainWindow::openFiles(std::vector<std::filesystem::path> files)
{
    m_message->hide();
    m_loader->load(std::move(files));
}

void MainWindow::takeLoaded(const std::vector<LoadedModel> &models, const std::vector<ImportError> &errors)
{
    m_loading->finish();
    if (!models.empty()) {
        std::vector<SceneObject> objects;
        for (const LoadedModel &loaded : models) {
            objects.push_back({pathText(loaded.file.filename()).toStdString(), loaded.file, loaded.model, {}});
            rememberRecent(loaded.file);
        }
        const QString first = QString::fromStdString(objects.front().name);
        const int others = static_cast<int>(models.size()) - 1;
        setWindowTitle(others == 0 ? tr("%1 – Unprojector").arg(first) : tr("%1 and %n more – Unprojector", nullptr, others).arg(first));
        m_document->setObjects(std::move(objects));
    }
    if (!errors.empty()) {
        QStringList reasons;
        for (const ImportError &error : errors)
            reasons << errorText(error);
        m_message->showMessage(reasons.join(u'\n'));
        emit openFailed(reasons.join(u'\n'));
    }
    emit loadingEnded();
}

QString MainWindow::message() const
{
    return m_message->isHidden() ? QString() : m_message->text();
}

void MainWindow::rememberRecent(const std::filesystem::path &file)
{
    if (!m_options.remembers)
        return;
    std::error_code error;
    const std::filesystem::path absolute = std::filesystem::absolute(file, error);
    addRecentFile(QString::fromStdU16String((error ? file : absolute).u16string()));
    updateRecentMenu();
}

void MainWindow::updateRecentMenu()
{
    m_recentMenu->clear();
    const QStringList files = m_options.remembers ? recentFiles() : QStringList();
    m_recentMenu->setEnabled(!files.isEmpty());
    for (const QString &file : files)
        connect(m_recentMenu->addAction(recentFileText(file)), &QAction::triggered, this, [this, file] { openFiles({pathFromQString(file)}); });
    if (files.isEmpty())
        return;
    m_recentMenu->addSeparator();
    connect(m_recentMenu->addAction(tr("&Clear This List")), &QAction::triggered, this, [this] {
        clearRecentFiles();
        updateRecentMenu();
    });
}

void MainWindow::showHover(const WidgetPoint &position, const DepthSample &sample)
{
    const Result<Pick> pick = m_document->unprojected(position, sample);
    if (!pick || (pick->hit && !pick->point.world.formula)) {
        m_hover->clear();
        return;
    }
    const QString pixel = tr("pixel (%1, %2)").arg(pick->devicePixel.i).arg(pick->devicePixel.j);
    if (!pick->hit) {
        m_hover->setText(tr("background, %1").arg(pixel));
        return;
    }
    const int decimals = certainDecimals(pick->certainty.radius());
    m_hover->setText(tr("world %1, %2").arg(pointText(*pick->point.world.formula, decimals), pixel));
}

void MainWindow::showCamera()
{
    const Projection &projection = m_document->geometry().projection;
    const ProjectionWindow w = projectionWindow(projection);
    m_projectionAction->setChecked(isPerspective(projection));
    m_camera->setText(tr("%1, near %2, far %3")
                          .arg(isPerspective(projection) ? tr("Perspective") : tr("Orthographic"), significantText(w.nearDistance, 4),
                               significantText(w.farDistance, 4)));
}

void MainWindow::restoreLayout()
{
    if (!m_options.remembers)
        return;
    const QSettings settings;
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("window/state")).toByteArray(), kLayoutVersion);
    m_comparison->setShowsFloat(settings.value(QStringLiteral("comparison/showsFloat"), false).toBool());
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (m_options.remembers) {
        QSettings settings;
        settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
        settings.setValue(QStringLiteral("window/state"), saveState(kLayoutVersion));
        settings.setValue(QStringLiteral("comparison/showsFloat"), m_comparison->showsFloat());
    }
    QMainWindow::closeEvent(event);
}

void MainWindow::showControls()
{
    QMessageBox box(QMessageBox::NoIcon, tr("Mouse and Keys"),
                    tr("<table cellspacing='6'>"
                       "<tr><td>Left button</td><td>read the world coordinate of the pixel</td></tr>"
                       "<tr><td>… and drag</td><td>turn the camera about that point</td></tr>"
                       "<tr><td>Middle button, or Shift + left</td><td>move the camera sideways</td></tr>"
                       "<tr><td>Wheel</td><td>zoom towards the pointer</td></tr>"
                       "<tr><td>Double-click</td><td>bring the point to the middle</td></tr>"
                       "<tr><td>1, 3, 7 (with Ctrl: the opposite)</td><td>look from the front, right, top</td></tr>"
                       "<tr><td>5</td><td>switch perspective and orthographic</td></tr>"
                       "<tr><td>F, Home</td><td>fit all objects; back to the first camera</td></tr>"
                       "</table>"),
                    QMessageBox::Close, this);
    box.exec();
}

void MainWindow::showAbout()
{
    QMessageBox::about(this, tr("About Unprojector"),
                       tr("<p><b>Unprojector %1</b></p><p>Click a pixel of a 3-D view and get its world coordinate, computed twice: by the "
                          "closed-form inverse formulas of Weng, Huang and Cai (2008) and by the inverted matrix, with the difference, its "
                          "cause and how certain the coordinate is.</p><p>MIT licence.</p>")
                           .arg(QStringLiteral(UNPROJECTOR_VERSION)));
}

} // namespace unprojector
