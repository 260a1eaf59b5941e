#include "gui/landmarks/landmarks_feature.h"

#include "gui/document/landmark_files.h"
#include "gui/document/landmark_surface.h"
#include "gui/document/landmark_views.h"
#include "gui/document/scene_curves.h"
#include "gui/document/scene_document.h"
#include "gui/document/session.h"
#include "gui/landmarks/curve_waiting.h"
#include "gui/landmarks/expected_landmarks.h"
#include "gui/landmarks/file_questions.h"
#include "gui/landmarks/guided_placing.h"
#include "gui/landmarks/landmark_looks.h"
#include "gui/landmarks/landmark_templates.h"
#include "gui/landmarks/landmark_tool.h"
#include "gui/landmarks/landmarks_panel.h"
#include "gui/landmarks/scan_series.h"
#include "gui/landmarks/series_panel.h"
#include "gui/text/error_text.h"
#include "gui/view/scene_view.h"
#include "gui/widgets/file_dialogs.h"
#include "gui/widgets/save_name.h"
#include "gui/window/actions.h"
#include "gui/window/feature.h"
#include "gui/window/scan_list.h"
#include "gui/window/window.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QToolBar>

#include <algorithm>
#include <optional>
#include <utility>

namespace unprojector::gui {

class LandmarksFeature : public Feature, public ScanList {
    Q_OBJECT
public:
    explicit LandmarksFeature(Window &window);
    ~LandmarksFeature() override { m_document.curves().setWaiting({}); }

    std::vector<PanelSpec> panels() override;
    std::optional<WorkspaceSpec> workspace() override
    {
        return WorkspaceSpec{Workspace::Landmarks,
                             tr("Landmarks"),
                             tr("Place landmarks on the surface, name and move them, and measure between them"),
                             Drawing::Points,
                             Qt::Key_F7,
                             {Panel::Landmarks, Panel::Objects}};
    }
    void addActions(MenuKind kind, QMenu &menu, QToolBar &bar) override;
    ViewTool *tool() override { return m_tool; }
    ScanList *scans() override { return this; }
    bool open(const std::filesystem::path &folder) override { return m_series->open(folder); }
    bool openReadOnly(const std::filesystem::path &folder, QString &problem) override;
    std::size_t count() const override { return m_series->scans().size(); }
    void show(std::size_t index) override { m_series->show(index); }
    Report report(std::size_t index) const override;
    QVariantMap state() const override { return {{kIsPlacing, m_placing->isChecked()}}; }
    void restore(const QVariantMap &state) override { m_placing->setChecked(state[kIsPlacing].toBool()); }
    void keep(QSettings &settings) const override { m_looks->keep(settings); }
    void restore(const QSettings &settings) override { m_looks->restore(settings); }

private:
    static inline const QString kIsPlacing = QStringLiteral("isPlacing");

    void openFiles(const std::vector<std::filesystem::path> &files);
    void importLandmarks();
    void exportLandmarks();
    void addFileActions(QMenu &menu);
    void addSeriesActions(QMenu &menu);
    void addPlacingActions(QMenu &menu, QToolBar &bar);
    bool isPlaced(std::size_t index) const { return m_document.landmarks()[index].isPlaced(); }
    /// Applies a function to the selected landmark, if it is placed.
    void withCurrent(void (*change)(SceneDocument &, std::size_t));
    void tellToSelect();
    void showArrows(bool areShown);
    void putSelectedOnSurface();
    /// Shows a scan of the series, and selects a landmark once the scan is in the view.
    void showLandmark(std::size_t scan, const NamedLandmark &landmark);
    void selectWanted();
    void join(landmarks::CurveKind kind);

    Window &m_window;
    SceneDocument &m_document;
    FileQuestions m_questions;
    LandmarkTemplates m_templates;
    LandmarkFiles *m_files;
    ScanSeries *m_series;
    LandmarksPanel *m_panel;
    SeriesPanel *m_seriesPanel;
    ExpectedLandmarks *m_expected;
    LandmarkTool *m_tool;
    LandmarkLooksMenu *m_looks;
    GuidedPlacing *m_guided;
    QAction *m_placing = nullptr;
    QAction *m_arrows = nullptr;
    std::optional<std::pair<std::size_t, NamedLandmark>> m_wanted; ///< scan and landmark to select
};

LandmarksFeature::LandmarksFeature(Window &window)
    : Feature(&window), m_window(window), m_document(window.document()), m_questions(window),
      m_files(new LandmarkFiles(m_document, window.remembers() ? &m_questions : nullptr, this)),
      m_series(new ScanSeries(m_document, window.session(), this)),
      m_panel(new LandmarksPanel(m_document, m_templates)), m_seriesPanel(new SeriesPanel(*m_series)),
      m_expected(new ExpectedLandmarks(m_document, *m_series, this)),
      m_tool(new LandmarkTool(m_document, window.view())), m_looks(new LandmarkLooksMenu(*m_tool)),
      m_guided(new GuidedPlacing(m_document, this))
{
    Session &session = window.session();
    m_tool->setExpected(*m_expected);
    connect(m_seriesPanel, &SeriesPanel::landmarkWanted, this, &LandmarksFeature::showLandmark);
    connect(m_series, &ScanSeries::changed, this, &LandmarksFeature::selectWanted);
    connect(&session, &Session::commitPendingEdits, m_panel, &LandmarksPanel::applyTyped);
    connect(&session, &Session::landmarkFilesOpened, this, &LandmarksFeature::openFiles);
    connect(m_panel, &LandmarksPanel::warned, &session, &Session::warned);
    connect(m_panel, &LandmarksPanel::noticed, &session, &Session::noticed);
    connect(m_panel, &LandmarksPanel::showRequested, this, [this] { m_window.workspaces().show(Panel::Landmarks); });
    connect(m_panel, &LandmarksPanel::templateChosen, m_series, &ScanSeries::keepChosenTemplate);
    connect(m_panel, &LandmarksPanel::placingRequested, this, [this] { m_placing->setChecked(true); });
    connect(m_tool, &LandmarkTool::placingChanged, m_panel, &LandmarksPanel::setPlacing);
    connect(m_tool, &LandmarkTool::placingChanged, m_guided, &GuidedPlacing::setPlacing);
    connect(m_tool, &LandmarkTool::menuRequested, m_panel, &LandmarksPanel::openMenu);
    connect(m_guided, &GuidedPlacing::placingWanted, this, [this](bool isOn) { m_placing->setChecked(isOn); });
    connect(m_guided, &GuidedPlacing::noticed, &window, &Window::notice);
    connect(m_series, &ScanSeries::scanShown, m_guided, &GuidedPlacing::continueOnScan);
    connect(m_series, &ScanSeries::leaving, &window, [&window] { window.notice({}); });
    connect(m_series, &ScanSeries::failed, &window, &Window::showFailure);
    connect(m_series, &ScanSeries::warned, &session, &Session::warned);
    connect(m_series, &ScanSeries::noticed, &session, &Session::noticed);
    connect(m_files, &LandmarkFiles::failed, &window, &Window::showFailure);
    connect(m_files, &LandmarkFiles::warned, &window, &Window::showMessage);
    connect(m_files, &LandmarkFiles::noticed, &session, &Session::noticed);
    connect(m_series, &ScanSeries::resumed, this, [this] {
        m_window.workspaces().enter(Workspace::Landmarks);
        m_window.workspaces().show(Panel::Series);
    });
    if (window.remembers())
        m_series->setTemplates(m_templates);
    if (window.remembers()) // with a user at the window, waiting is possible
        m_document.curves().setWaiting([this] { return waitForCurves(m_window, m_document); });
}

std::vector<PanelSpec> LandmarksFeature::panels()
{
    return {
        {Panel::Landmarks, tr("Landmarks"), m_panel, Qt::RightDockWidgetArea, Qt::ALT | Qt::Key_7},
        {Panel::Series, tr("Series"), m_seriesPanel, Qt::BottomDockWidgetArea, Qt::ALT | Qt::Key_8},
    };
}

void LandmarksFeature::addActions(MenuKind kind, QMenu &menu, QToolBar &bar)
{
    if (kind == MenuKind::File) {
        menu.addSeparator();
        addFileActions(menu);
    } else if (kind == MenuKind::Edit) {
        menu.addSeparator();
        addPlacingActions(menu, bar);
    } else if (kind == MenuKind::View) {
        m_looks->addTo(menu);
    }
}

bool LandmarksFeature::openReadOnly(const std::filesystem::path &folder, QString &problem)
{
    QObject context;
    connect(m_series, &ScanSeries::failed, &context, [&problem](const QString &reason) { problem = reason; });
    m_series->setReadOnly();
    return m_series->open(folder);
}

ScanList::Report LandmarksFeature::report(std::size_t index) const
{
    const Scan &scan = m_series->scans()[index];
    return {pathText(scan.file.filename()), scan.problem, m_series->progressText(scan)};
}

void LandmarksFeature::openFiles(const std::vector<std::filesystem::path> &files)
{
    for (const std::filesystem::path &file : files) {
        if (LandmarkFiles::isTemplate(file))
            m_panel->takeTemplate(file);
    }
    for (const std::filesystem::path &file : files) { // they fill the names of the templates
        if (!LandmarkFiles::isTemplate(file))
            m_files->importFrom(file);
    }
}

void LandmarksFeature::importLandmarks()
{
    m_window.session().commitTyped();
    const std::filesystem::path file =
        askFileName(m_window, FileKind::Landmarks, tr("Import Landmarks"),
                    LandmarkFiles::importFilter() + QStringLiteral(";;") + tr("All files (*)"));
    if (!file.empty())
        m_files->importFrom(file);
}

void LandmarksFeature::exportLandmarks()
{
    m_window.session().commitTyped();
    const SaveName named =
        askSaveName(m_window, tr("Export Landmarks"), LandmarkFiles::exportFilters().split(QStringLiteral(";;")),
                    pathText(m_window.session().proposedName().stem()), FileKind::Landmarks);
    if (!named.file.empty() && m_window.mayExportTo(named.file))
        m_files->exportTo(named.file, m_series->shownNames());
}

void LandmarksFeature::addFileActions(QMenu &menu)
{
    addAction(menu, tr("&Import Landmarks…"), {}, tr("Import landmarks from a file of this or another program"),
              [this] { importLandmarks(); });
    addAction(menu, tr("E&xport Landmarks…"), {}, tr("Export the landmarks to a file; its suffix selects the format"),
              [this] { exportLandmarks(); });
    addSeriesActions(*menu.addMenu(tr("Series of S&cans")));
}

void LandmarksFeature::addSeriesActions(QMenu &menu)
{
    addAction(menu, tr("&Open Folder…"), {}, tr("Open a folder of scans and place the same landmarks on each"), [this] {
        if (m_seriesPanel->chooseFolder())
            m_window.workspaces().show(Panel::Series);
    });
    QAction *next = addAction(menu, tr("&Next Scan"), Qt::CTRL | Qt::Key_PageDown,
                              tr("Keep the landmarks and show the next scan"), [this] { m_series->next(); });
    QAction *previous =
        addAction(menu, tr("&Previous Scan"), Qt::CTRL | Qt::Key_PageUp,
                  tr("Keep the landmarks and show the previous scan"), [this] { m_series->previous(); });
    QAction *repeats =
        addAction(menu, tr("&Repeats…"), {},
                  tr("Show how well each landmark is repeated: its error of measurement over all placings"),
                  [this] { m_seriesPanel->showRepeats(); });
    QAction *close = addAction(menu, tr("&Close Series"), {}, tr("Keep the landmarks and leave the series"), [this] {
        if (m_series->close())
            m_window.workspaces().dock(Panel::Series).hide();
    });
    const auto enable = [this, next, previous, repeats, close] {
        next->setEnabled(m_series->hasNext());
        previous->setEnabled(m_series->hasPrevious());
        repeats->setEnabled(m_series->isOpen());
        close->setEnabled(m_series->isOpen());
    };
    connect(m_series, &ScanSeries::changed, &menu, enable);
    enable();
}

void LandmarksFeature::addPlacingActions(QMenu &menu, QToolBar &bar)
{
    menu.addSection(tr("Landmarks"));
    m_placing =
        addSwitch(menu, tr("&Place Landmarks"), Qt::Key_P, tr("A click places a landmark; a drag turns the view"));
    m_placing->setObjectName(QStringLiteral("place_points")); // for links in lessons
    connect(m_placing, &QAction::toggled, this, [this](bool isOn) {
        m_tool->setPlacing(isOn);
        if (isOn)
            m_window.view().setFocus(); // arrow keys move the landmark
    });
    connect(m_tool, &LandmarkTool::placingChanged, m_placing, &QAction::setChecked);
    putOnBar(bar, *m_placing, Drawing::Points);
    bar.addSeparator();
    addAction(menu, tr("S&kip Landmark"), Qt::Key_K,
              tr("Go on with the next landmark to place; the skipped one comes again after the others"),
              [this] { m_guided->skipNext(); });
    addAction(menu, tr("Mark as &Missing"), Qt::Key_X,
              tr("Mark the next landmark to place, else the selected ones, as missing on this specimen; again removes "
                 "the mark"),
              [this] { m_guided->toggleMissing(); });
    addAction(
        menu, tr("&Go to Landmark"), Qt::Key_G, tr("Turn the camera to face the surface at the selected landmark"),
        [this] { withCurrent([](SceneDocument &document, std::size_t index) { goToLandmark(document, index); }); });
    addAction(menu, tr("&Zoom to ± 0.01"), Qt::SHIFT | Qt::Key_G,
              tr("Move closer to the selected landmark until its pixel has an uncertainty of at most 0.01"),
              [this] {
                  withCurrent([](SceneDocument &document, std::size_t index) {
                      constexpr double kHalf = 0.01;
                      zoomToLandmark(document, index, kHalf);
                  });
              })
        ->setObjectName(QStringLiteral("zoom_to_point"));
    addAction(menu, tr("Turn to &Expected Place"), Qt::Key_N,
              tr("Turn the camera to face the surface where the other scans of the series expect the next landmark"),
              [this] {
                  if (const QString reason = m_expected->faceNext(); !reason.isEmpty())
                      m_window.notice(reason);
              });
    QAction *expected = addSwitch(menu, tr("Sho&w Expected Places"), {},
                                  tr("Show where the other scans of the series expect the landmarks to place"));
    expected->setChecked(m_expected->isShown());
    connect(expected, &QAction::toggled, m_expected, &ExpectedLandmarks::setShown);
    m_arrows = addSwitch(menu, tr("Axis Arro&ws"), Qt::Key_A,
                         tr("Show arrows at the selected landmark that move it along the axes, off the surface"));
    connect(m_arrows, &QAction::toggled, this, &LandmarksFeature::showArrows);
    connect(m_tool, &LandmarkTool::arrowsChanged, m_arrows, &QAction::setChecked);
    addAction(menu, tr("Put &Back on the Surface"), Qt::Key_B,
              tr("Move the selected landmarks to the closest point of the surface"),
              [this] { putSelectedOnSurface(); });
    addAction(menu, tr("&Join on the Surface"), Qt::Key_J,
              tr("Draw a curve through the selected landmarks, like a thread pulled tight on the surface"),
              [this] { join(landmarks::CurveKind::Geodesic); });
    addAction(menu, tr("Join Along a P&lane"), Qt::SHIFT | Qt::Key_J,
              tr("Draw a curve through the selected landmarks, where the plane along the surface's normals cuts it"),
              [this] { join(landmarks::CurveKind::PlaneSection); });
}

void LandmarksFeature::showArrows(bool areShown)
{
    if (m_tool->setArrowsShown(areShown))
        return;
    m_arrows->setChecked(false);
    tellToSelect();
}

void LandmarksFeature::withCurrent(void (*change)(SceneDocument &, std::size_t))
{
    const std::optional<std::size_t> index = m_document.sceneLandmarks().current();
    if (index && isPlaced(*index))
        change(m_document, *index);
    else
        tellToSelect();
}

void LandmarksFeature::tellToSelect()
{
    m_window.notice(tr("Select a placed landmark first: its marker in the view, or its row in the Landmarks panel."));
}

void LandmarksFeature::putSelectedOnSurface()
{
    const std::vector<std::size_t> &selected = m_document.sceneLandmarks().selection();
    if (std::any_of(selected.begin(), selected.end(), [this](std::size_t index) { return isPlaced(index); }))
        static_cast<void>(putOnSurface(m_document, selected));
    else
        m_window.notice(
            tr("Select placed landmarks first: their markers in the view, or their rows in the Landmarks panel."));
}

void LandmarksFeature::showLandmark(std::size_t scan, const NamedLandmark &landmark)
{
    if (scan >= m_series->scans().size()) // of a series that is closed
        return;
    m_wanted = {scan, landmark};
    if (m_series->current() != scan)
        m_series->show(scan);
    selectWanted();
}

void LandmarksFeature::selectWanted()
{
    if (!m_wanted || m_window.session().isLoading())
        return;
    const auto [scan, landmark] = *std::exchange(m_wanted, std::nullopt);
    if (m_series->current() != scan) // another scan was chosen, or this one cannot be read
        return;
    if (const std::optional<std::size_t> index = indexOf(m_document.landmarks(), landmark))
        m_document.sceneLandmarks().selectOnly(*index);
}

void LandmarksFeature::join(landmarks::CurveKind kind)
{
    if (m_document.sceneLandmarks().selection().size() < 2) {
        m_window.notice(tr("Select two or more landmarks first: their rows in the Landmarks panel, with Ctrl."));
        return;
    }
    m_window.workspaces().show(Panel::Landmarks); // lists the curve, or tells why there is none
    m_panel->join(kind);
}

Feature *makeLandmarksFeature(Window &window)
{
    return new LandmarksFeature(window);
}

} // namespace unprojector::gui

#include "landmarks_feature.moc"
