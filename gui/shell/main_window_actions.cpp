// The window's menus and tool bar.

#include "gui/shell/main_window.h"

#include "gui/document/camera_looks.h"
#include "gui/document/point_files.h"
#include "gui/document/point_surface.h"
#include "gui/document/point_views.h"
#include "gui/document/recent_files.h"
#include "gui/document/scene_document.h"
#include "gui/landmarks/landmark_tool.h"
#include "gui/landmarks/points_panel.h"
#include "gui/landmarks/save_name.h"
#include "gui/landmarks/scan_series.h"
#include "gui/landmarks/series_panel.h"
#include "gui/lessons/formulas_window.h"
#include "gui/lessons/lesson_player.h"
#include "gui/lessons/lesson_text.h"
#include "gui/map/map_overlay.h"
#include "gui/pipeline/paste_matrices_dialog.h"
#include "gui/shell/about_dialog.h"
#include "gui/shell/appearance.h"
#include "gui/shell/first_steps.h"
#include "gui/shell/key_sheet.h"
#include "gui/shell/place_ids.h"
#include "gui/shell/plain_tool_tip.h"
#include "gui/shell/scene_code_window.h"
#include "gui/shell/work_places.h"
#include "gui/text/error_text.h"
#include "gui/view/scene_view.h"
#include "gui/widgets/help_link.h"
#include "gui/widgets/icons.h"

#include <QActionGroup>
#include <QDockWidget>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>

#include <algorithm>

namespace unprojector::gui {

QAction *MainWindow::addAction(QMenu *menu, const QString &text, const QKeySequence &key, const QString &tip,
                               std::function<void()> slot)
{
    QAction *action = menu->addAction(text);
    // On a button of the tool bar, "打开(&O)…" is "打开…".
    static const QRegularExpression keyInParentheses(QStringLiteral("\\(&.\\)"));
    action->setIconText(QString(text).remove(keyInParentheses).remove(u'&'));
    action->setShortcut(key);
    action->setToolTip(key.isEmpty() ? tip
                                     : QStringLiteral("%1 (%2)").arg(tip, key.toString(QKeySequence::NativeText)));
    action->setStatusTip(tip);
    if (slot)
        connect(action, &QAction::triggered, this, std::move(slot));
    return action;
}

namespace {

/// On the tool bar: a drawing, its name in the tool tip.
void onBar(QToolBar &bar, QAction *action, Drawing drawing)
{
    action->setIcon(drawnIcon(drawing));
    action->setIconVisibleInMenu(false);
    bar.addAction(action);
}

} // namespace

void MainWindow::createActions()
{
    QToolBar *bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tools"));
    fitToolBar();
    // Where one is stands first: a narrow window cuts the others off.
    for (const WorkPlaces::Place &place : m_places->places())
        bar->addAction(place.action);
    bar->addSeparator();
    createFileMenu(*bar);
    createEditMenu(*bar);
    createViewMenu(*bar);
    createHelpMenu();
}

void MainWindow::fitToolBar()
{
    // In a narrow window with a large font they are smaller, so that all have room.
    constexpr int kShareOfWidth = 40;
    const int icon =
        std::min(fontMetrics().height() * 3 / 2, std::max(width() / kShareOfWidth, fontMetrics().ascent()));
    findChild<QToolBar *>(QStringLiteral("tools"))->setIconSize({icon, icon});
}

std::vector<std::filesystem::path> MainWindow::askForModels(const QString &title, const QString &filter)
{
    std::vector<std::filesystem::path> files;
    for (const QString &name : QFileDialog::getOpenFileNames(this, title, {}, filter))
        files.emplace_back(name.toStdU16String());
    return files;
}

void MainWindow::createFileMenu(QToolBar &bar)
{
    const QString models = modelFileFilter(), all = QStringLiteral(";;") + tr("All files (*)");
    QMenu *menu = menuBar()->addMenu(tr("&File"));
    onBar(bar,
          addAction(menu, tr("&Open…"), QKeySequence::Open, tr("Open model files or a scene"),
                    [this, models, all] {
                        std::vector<std::filesystem::path> files = askForModels(
                            tr("Open Models or a Scene"), openableFileFilter() + QStringLiteral(";;") + models
                                                              + QStringLiteral(";;") + tr("Scenes (*.json)") + all);
                        if (!files.empty())
                            m_session->openFiles(std::move(files));
                    }),
          Drawing::Open);
    addAction(menu, tr("A&dd to Scene…"), Qt::CTRL | Qt::SHIFT | Qt::Key_O,
              tr("Put more models beside the objects of this scene"), [this, models, all] {
                  std::vector<std::filesystem::path> files = askForModels(tr("Add Models"), models + all);
                  if (!files.empty())
                      m_session->addFiles(std::move(files));
              });
    m_recentMenu = menu->addMenu(tr("Open &Recent"));
    onBar(bar,
          addAction(menu, tr("&Save Scene"), QKeySequence::Save, tr("Write the scene to its file"),
                    [this] { m_session->save(); }),
          Drawing::Save);
    bar.addSeparator();
    addAction(menu, tr("Save Scene &As…"), Qt::CTRL | Qt::SHIFT | Qt::Key_S, tr("Write the scene to another file"),
              [this] { m_session->saveAs(); });
    addAction(
        menu, tr("Sce&ne as Code…"), {},
        tr("The calls that make this picture, for GLU and MFC, GLM, Qt or three.js, with the way back from a pixel"),
        [this] { showCode(); });
    menu->addSeparator();
    createPointActions(*menu);
    menu->addSeparator();
    addAction(menu, tr("&Bundled Scene"), {}, tr("Show the scene that comes with the program"),
              [this] { m_session->openBundledScene(); });
    createLessonsMenu(*menu->addMenu(tr("&Lessons")));
    menu->addSeparator();
    addAction(menu, tr("&Quit"), QKeySequence::Quit, tr("Close the window"), [this] { close(); });
    updateRecentMenu();
}

void MainWindow::createPointActions(QMenu &menu)
{
    addAction(&menu, tr("&Import Points…"), {}, tr("Read points from a file of this or another program"),
              [this] { importPoints(); });
    addAction(&menu, tr("E&xport Points…"), {}, tr("Write the points to a file; its suffix says for which program"),
              [this] { exportPoints(); });
    QMenu *series = menu.addMenu(tr("Series of S&cans"));
    addAction(series, tr("&Open Folder…"), {}, tr("Open a folder of scans, to place the same points on each"), [this] {
        if (m_seriesPanel->chooseFolder())
            m_places->show("series");
    });
    QAction *next = addAction(series, tr("&Next Scan"), Qt::CTRL | Qt::Key_PageDown,
                              tr("Keep the points and show the next scan"), [this] { m_series->next(); });
    QAction *previous = addAction(series, tr("&Previous Scan"), Qt::CTRL | Qt::Key_PageUp,
                                  tr("Keep the points and show the scan before"), [this] { m_series->previous(); });
    QAction *repeats = addAction(series, tr("&Repeats…"), {},
                                 tr("Write the mean of each point's placings, and how far they scatter, to a table"),
                                 [this] { m_seriesPanel->exportRepeats(); });
    QAction *close = addAction(series, tr("&Close Series"), {}, tr("Keep the points and leave the series"), [this] {
        if (m_series->close())
            m_places->dock("series")->hide();
    });
    const auto enable = [this, next, previous, repeats, close] {
        next->setEnabled(m_series->hasNext());
        previous->setEnabled(m_series->hasPrevious());
        repeats->setEnabled(m_series->isOpen());
        close->setEnabled(m_series->isOpen());
    };
    connect(m_series, &ScanSeries::changed, series, enable);
    enable();
}

void MainWindow::importPoints()
{
    emit m_session->typedToCount();
    const QString name = QFileDialog::getOpenFileName(
        this, tr("Import Points"), {}, PointFiles::importFilter() + QStringLiteral(";;") + tr("All files (*)"));
    if (!name.isEmpty())
        m_pointFiles->importFrom(std::filesystem::path(name.toStdU16String()));
}

void MainWindow::exportPoints()
{
    emit m_session->typedToCount();
    const SaveName named =
        askSaveName(*this, tr("Export Points"), PointFiles::exportFilters().split(QStringLiteral(";;")),
                    pathText(m_session->proposedName().stem()));
    if (!named.file.empty() && mayExportTo(named.file))
        m_pointFiles->exportTo(named.file);
}

void MainWindow::updateRecentMenu()
{
    m_recentMenu->clear();
    const QStringList files = m_session->recentFiles();
    m_recentMenu->setEnabled(!files.isEmpty());
    for (const QString &file : files)
        connect(m_recentMenu->addAction(recentFileText(file)), &QAction::triggered, this,
                [this, file] { m_session->openFiles({std::filesystem::path(file.toStdU16String())}); });
    if (files.isEmpty())
        return;
    m_recentMenu->addSeparator();
    connect(m_recentMenu->addAction(tr("&Clear This List")), &QAction::triggered, m_session,
            &Session::clearRecentFiles);
}

void MainWindow::createEditMenu(QToolBar &bar)
{
    QMenu *menu = menuBar()->addMenu(tr("&Edit"));
    QAction *undo = m_document->undoStack().createUndoAction(menu, tr("&Undo"));
    undo->setObjectName(QStringLiteral("undo")); // by which lessons link to it, as to others below
    undo->setShortcut(QKeySequence::Undo);
    QAction *redo = m_document->undoStack().createRedoAction(menu, tr("&Redo"));
    QList<QKeySequence> redoKeys = QKeySequence::keyBindings(QKeySequence::Redo);
    if (const QKeySequence key(Qt::CTRL | Qt::Key_Y); !redoKeys.contains(key))
        redoKeys << key; // not every desktop has it
    redo->setShortcuts(redoKeys);
    for (QAction *action : {undo, redo})
        keepToolTipPlain(action);
    menu->addActions({undo, redo});
    onBar(bar, undo, Drawing::Undo);
    onBar(bar, redo, Drawing::Redo);
    bar.addSeparator();
    menu->addSeparator();
    addAction(menu, tr("Paste &Matrices…"), {},
              tr("Take the camera from projection and view, or their product, as another program prints them"), [this] {
                  emit m_session->typedToCount();
                  PasteMatricesDialog::open(*m_document, this);
              });
    menu->addSeparator();
    createSnapActions(*menu, bar);
    menu->addSeparator();
    createPlacingActions(*menu, bar);
}

void MainWindow::createPlacingActions(QMenu &menu, QToolBar &bar)
{
    menu.addSection(tr("Points"));
    m_placingAction = addAction(&menu, tr("&Place Points"), Qt::Key_P,
                                tr("A click places a point; what is dragged turns the view"), {});
    m_placingAction->setCheckable(true);
    m_placingAction->setObjectName(QStringLiteral("place_points")); // as the others that lessons link to
    connect(m_placingAction, &QAction::toggled, this, [this](bool isOn) {
        m_landmarkTool->setPlacing(isOn);
        if (isOn)
            m_view->setFocus(); // arrow keys move the point
    });
    onBar(bar, m_placingAction, Drawing::Points);
    bar.addSeparator();
    const auto isPlaced = [this](std::size_t place) { return !m_document->landmarks()[place].isMissing(); };
    const auto withCurrent = [this, isPlaced](auto deed) {
        return [this, deed, isPlaced] {
            const std::optional<std::size_t> place = m_document->points().current();
            if (place && isPlaced(*place))
                deed(*m_document, *place);
            else
                statusBar()->showMessage(
                    tr("Select a placed point first: its mark in the view, or its row under Points."),
                    kNoticeMilliseconds);
        };
    };
    addAction(&menu, tr("&Go to Point"), Qt::Key_G, tr("Turn the camera to face the surface at the selected point"),
              withCurrent([](SceneDocument &document, std::size_t place) { goToPoint(document, place); }));
    QAction *zoom = addAction(&menu, tr("&Zoom to ± 0.01"), Qt::SHIFT | Qt::Key_G,
                              tr("Get closer to the selected point until its pixel leaves no more open than 0.01"),
                              withCurrent([](SceneDocument &document, std::size_t place) {
                                  constexpr double kHalf = 0.01;
                                  zoomToPoint(document, place, kHalf);
                              }));
    zoom->setObjectName(QStringLiteral("zoom_to_point"));
    addAction(&menu, tr("Put &Back on the Surface"), Qt::Key_B,
              tr("Put the selected points onto the surface, where it is closest to them"), [this, isPlaced] {
                  const std::vector<std::size_t> &selected = m_document->points().selection();
                  if (std::any_of(selected.begin(), selected.end(), isPlaced))
                      static_cast<void>(putOnSurface(*m_document, selected));
                  else
                      statusBar()->showMessage(
                          tr("Select placed points first: their marks in the view, or their rows under Points."),
                          kNoticeMilliseconds);
              });
    const auto join = [this](landmarks::CurveKind kind) {
        return [this, kind] {
            if (m_document->points().selection().size() < 2) {
                statusBar()->showMessage(tr("Select two points or more first: their rows under Points, with Ctrl."),
                                         kNoticeMilliseconds);
                return;
            }
            m_places->show("points"); // where the curve is listed, or why there is none
            m_pointsPanel->join(kind);
        };
    };
    addAction(&menu, tr("&Join on the Surface"), Qt::Key_J,
              tr("Lead a curve through the selected points as a thread pulled tight on the surface"),
              join(landmarks::CurveKind::Geodesic));
    addAction(&menu, tr("Join Along a P&lane"), Qt::SHIFT | Qt::Key_J,
              tr("Lead a curve through the selected points where the plane along the surface's normals cuts it"),
              join(landmarks::CurveKind::PlaneSection));
}

void MainWindow::createSnapActions(QMenu &menu, QToolBar &bar)
{
    menu.addSection(tr("A Click Takes"));
    auto *group = new QActionGroup(&menu);
    const auto add = [&](const char *name, ray::Snap snap, const QString &text, const QKeySequence &key,
                         const QString &tip, Drawing drawing) {
        QAction *action = addAction(&menu, text, key, tip, [this, snap] { m_document->setSnap(snap); });
        action->setCheckable(true);
        action->setChecked(snap == m_document->snap());
        action->setActionGroup(group);
        action->setObjectName(QLatin1String(name));
        onBar(bar, action, drawing);
    };
    add("surface", ray::Snap::Surface, tr("&Surface"), Qt::Key_S, tr("A click takes the surface under it"),
        Drawing::Surface);
    add("vertex", ray::Snap::Vertex, tr("&Vertex"), Qt::Key_V,
        tr("A click takes the vertex in sight within 8 pixels, its very coordinate"), Drawing::Vertex);
    add("edge", ray::Snap::Edge, tr("&Edge"), Qt::Key_E,
        tr("A click takes the nearest point of an edge in sight within 8 pixels"), Drawing::Edge);
    add("face", ray::Snap::Face, tr("&Face"), Qt::SHIFT | Qt::Key_F,
        tr("A click takes the face under it, with its plane"), Drawing::Face);
    bar.addSeparator();
}

void MainWindow::createViewMenu(QToolBar &bar)
{
    const auto look = [this](StandardView side) {
        return [this, side] { setCamera(*m_document, seenFrom(m_document->geometry().camera(), side)); };
    };
    QMenu *menu = menuBar()->addMenu(tr("&View"));
    onBar(bar,
          addAction(menu, tr("&Fit"), Qt::Key_F, tr("Move the camera until all objects fill the view"),
                    [this] { fitAll(*m_document); }),
          Drawing::Fit);
    onBar(bar,
          addAction(menu, tr("&Home"), Qt::Key_Home, tr("Back to the camera that the scene opened with"),
                    [this] { goHome(*m_document); }),
          Drawing::Home);
    menu->addSeparator();
    bar.addSeparator();
    // These have keys, and no room on the bar of a small window.
    addAction(menu, tr("Fr&ont"), Qt::Key_1, tr("Look from the front, along −z"), look(StandardView::Front));
    addAction(menu, tr("&Right"), Qt::Key_3, tr("Look from the right, along −x"), look(StandardView::Right));
    addAction(menu, tr("&Top"), Qt::Key_7, tr("Look from the top, along −y"), look(StandardView::Top));
    addAction(menu, tr("B&ack"), Qt::CTRL | Qt::Key_1, tr("Look from the back, along z"), look(StandardView::Back));
    addAction(menu, tr("&Left"), Qt::CTRL | Qt::Key_3, tr("Look from the left, along x"), look(StandardView::Left));
    addAction(menu, tr("Botto&m"), Qt::CTRL | Qt::Key_7, tr("Look from below, along y"), look(StandardView::Bottom));
    menu->addSeparator();
    m_projectionAction = addAction(menu, tr("&Perspective"), Qt::Key_5,
                                   tr("Switch between perspective (glFrustum) and orthographic (glOrtho)"),
                                   [this] { switchProjection(*m_document); });
    m_projectionAction->setCheckable(true);
    m_projectionAction->setObjectName(QStringLiteral("perspective"));
    onBar(bar, m_projectionAction, Drawing::Perspective);

    m_observerAction =
        addAction(menu, tr("&View from Outside"), Qt::Key_0,
                  tr("Show the camera and its view volume from outside, in a corner of the view or in a panel"), {});
    m_observerAction->setCheckable(true);
    connect(m_observerAction, &QAction::toggled, this, &MainWindow::showObserver);
    onBar(bar, m_observerAction, Drawing::FromOutside);
    m_mapAction =
        addAction(menu, tr("&Map of Differences"), Qt::Key_M,
                  tr("Show over the view, for every pixel, how far the methods differ, how sure a click is, or "
                     "what another program is off"),
                  {});
    m_mapAction->setCheckable(true);
    connect(m_mapAction, &QAction::toggled, this, [this](bool isOn) { m_map->setShown(isOn); });
    QAction *smooth =
        addAction(menu, tr("&Smooth Edges"), {},
                  tr("Draw the edges of surfaces without steps. The depths that clicks read stay the same"), {});
    smooth->setCheckable(true);
    smooth->setChecked(m_smoothEdges);
    connect(smooth, &QAction::toggled, this, &MainWindow::setSmoothEdges);
    createAppearanceMenu(*menu->addMenu(tr("Co&lours")));
    if (m_options.remembers && m_options.translation)
        createLanguageMenu(*menu->addMenu(tr("Lan&guage")));
    menu->addSeparator();
    createPlaceActions(*menu);
}

void MainWindow::createAppearanceMenu(QMenu &menu)
{
    auto *group = new QActionGroup(&menu);
    const auto add = [&](Appearance appearance, const QString &text, const QString &tip) {
        QAction *action = addAction(&menu, text, {}, tip, [this, appearance] {
            setAppearance(appearance);
            if (m_options.remembers)
                QSettings().setValue(QStringLiteral("window/appearance"), appearanceName(appearance));
        });
        action->setCheckable(true);
        action->setActionGroup(group);
        action->setChecked(appearance == currentAppearance());
    };
    add(Appearance::Desktop, tr("As the &Desktop Has Them"), tr("Light or dark as the desktop is"));
    add(Appearance::Light, tr("&Light"), tr("Dark letters on a light ground"));
    add(Appearance::Dark, tr("D&ark"), tr("Light letters on a dark ground"));
}

void MainWindow::createHelpMenu()
{
    QMenu *menu = menuBar()->addMenu(tr("&Help"));
    new HelpOpener([this](const QString &anchor) { showFormulas(anchor); }, menu);
    addAction(menu, tr("&Formulas"), QKeySequence::HelpContents,
              tr("All formulas with their sources, and the errors in the originals"), [this] { showFormulas({}); });
    addAction(menu, tr("&Mouse and Keys"), Qt::Key_Question, tr("What the mouse and every key do"),
              [this] { showKeys(); });
    addAction(menu, tr("First &Steps"), {}, tr("Three things to try"), [this] {
        m_places->enter(kClickPlace);
        showFirstSteps(true);
    });
    menu->addSeparator();
    addAction(menu, tr("&About Unprojector"), {}, tr("What this program is"), [this] { showAbout(); });
}

void MainWindow::showFormulas(const QString &anchor)
{
    if (!m_formulas)
        m_formulas = new FormulasWindow(this);
    m_formulas->show();
    m_formulas->raise();
    m_formulas->activateWindow();
    if (!anchor.isEmpty())
        m_formulas->showFormula(anchor);
}

void MainWindow::showCode()
{
    emit m_session->typedToCount();
    if (!m_code)
        m_code = new SceneCodeWindow(*m_document, *m_session, this);
    m_code->show();
    m_code->raise();
    m_code->activateWindow();
}

void MainWindow::showKeys()
{
    if (!m_keys)
        m_keys = new KeySheet(*menuBar(), this);
    m_keys->show();
    m_keys->raise();
}

void MainWindow::showAbout()
{
    const QString wayBack = m_view->objectIds() == ObjectIds::Colors
                                ? tr("This graphics driver draws no integers, so the view tells by colours which "
                                     "object was clicked.")
                                : QString();
    AboutDialog(m_view->openGLName(), wayBack, this).exec();
}

void MainWindow::showFirstSteps(bool isShown)
{
    const std::vector<Lesson> &lessons = m_lessons->lessons();
    if (isShown && !m_firstSteps && !lessons.empty()) { // the note offers the first one
        m_firstSteps = new FirstSteps(lessonTitle(lessons.front().title));
        const int margin = fontMetrics().height() / 2;
        auto *line = new QHBoxLayout;
        line->setContentsMargins(margin, margin, margin, margin);
        line->addWidget(m_firstSteps);
        line->addStretch();
        m_overlays->insertLayout(m_overlays->count() - 1, line); // below the messages
        connect(m_firstSteps, &FirstSteps::closeRequested, this, [this] { showFirstSteps(false); });
        connect(m_firstSteps, &FirstSteps::lessonRequested, this, [this] {
            showFirstSteps(false);
            m_lessons->start(m_lessons->lessons().front().name);
        });
    }
    if (!m_firstSteps)
        return;
    m_areFirstStepsShown = isShown;
    placeFirstSteps();
    if (!isShown && m_options.remembers)
        QSettings().setValue(QStringLiteral("firstSteps/areDone"), true);
}

void MainWindow::placeFirstSteps()
{
    if (!m_firstSteps)
        return;
    // Not in a lesson either: it is one of them, and the view can be smaller without the note.
    m_firstSteps->setVisible(m_areFirstStepsShown && qstrcmp(m_places->current(), kClickPlace) == 0
                             && !m_lessons->lesson());
    m_firstSteps->raise();
}

} // namespace unprojector::gui
