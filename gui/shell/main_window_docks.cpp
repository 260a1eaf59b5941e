// The window's panels and its work places.

#include "gui/shell/main_window.h"

#include "gui/click/comparison_panel.h"
#include "gui/doctor/doctor_panel.h"
#include "gui/document/point_files.h"
#include "gui/landmarks/points_panel.h"
#include "gui/landmarks/series_panel.h"
#include "gui/lessons/lesson_panel.h"
#include "gui/lessons/lesson_player.h"
#include "gui/objects/objects_panel.h"
#include "gui/outside/observer_inset.h"
#include "gui/outside/observer_panel.h"
#include "gui/outside/observer_view.h"
#include "gui/parameters/parameters_panel.h"
#include "gui/pipeline/depth_precision_panel.h"
#include "gui/pipeline/lifecycle_panel.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/pipeline/viewport_inspector.h"
#include "gui/shell/kept_bytes.h"
#include "gui/shell/place_ids.h"
#include "gui/shell/work_places.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {
namespace {

constexpr char kGeometryKey[] = "window/geometry", kParametersKey[] = "parameters/state";

/// On a small window the panel scrolls, instead of holding the window open; a bar beside it takes nothing of its width.
class PanelScroll : public QScrollArea {
public:
    explicit PanelScroll(QWidget *panel)
    {
        setFrameShape(QFrame::NoFrame);
        setWidgetResizable(true);
        setWidget(panel);
    }
    QSize sizeHint() const override
    {
        return {widget()->sizeHint().width() + verticalScrollBar()->sizeHint().width(),
                QScrollArea::sizeHint().height()};
    }
    QSize minimumSizeHint() const override
    {
        constexpr int kLeastDigits = 20, kLeastLines = 4;
        return {kLeastDigits * fontMetrics().horizontalAdvance(u'0'), kLeastLines * fontMetrics().lineSpacing()};
    }

protected:
    /// Where the panel has its least width there is no bar below it: Qt can otherwise leave both bars standing, each
    /// there for the room that the other takes.
    void resizeEvent(QResizeEvent *event) override
    {
        const int least = std::max(widget()->minimumWidth(), widget()->minimumSizeHint().width())
                          + verticalScrollBar()->sizeHint().width();
        setHorizontalScrollBarPolicy(width() >= least ? Qt::ScrollBarAlwaysOff : Qt::ScrollBarAsNeeded);
        QScrollArea::resizeEvent(event);
    }
};

} // namespace

void MainWindow::createPanels()
{
    m_comparison = new ComparisonPanel(*m_document);
    m_inspector = new ViewportInspector(*m_document);
    m_parameters = new ParametersPanel(*m_document);
    m_lessonPanel = new LessonPanel(*m_lessons, *m_document);
    m_observerHome = new QWidget;
    m_observerHome->setLayout(new QVBoxLayout);
    m_observerHome->layout()->setContentsMargins(0, 0, 0, 0);
    constexpr auto kLeft = Qt::LeftDockWidgetArea, kRight = Qt::RightDockWidgetArea, kBottom = Qt::BottomDockWidgetArea;
    auto *objects = new ObjectsPanel(*m_document);
    connect(m_session, &Session::typedToCount, objects, &ObjectsPanel::applyTyped);
    m_pointsPanel = new PointsPanel(*m_document, *m_templates);
    PointsPanel *points = m_pointsPanel;
    connect(m_session, &Session::typedToCount, points, &PointsPanel::applyTyped);
    connect(points, &PointsPanel::warned, m_session, &Session::warned);
    connect(m_session, &Session::pointFilesOpened, points, [points](const std::vector<std::filesystem::path> &files) {
        for (const std::filesystem::path &file : files) {
            if (PointFiles::isTemplate(file))
                points->takeTemplate(file);
        }
    });
    m_seriesPanel = new SeriesPanel(*m_series);
    auto *pipeline = new PipelinePanel(*m_document);
    connect(m_session, &Session::typedToCount, pipeline, &PipelinePanel::applyTyped);
    connect(pipeline, &PipelinePanel::aboutToPaste, m_session, &Session::typedToCount);
    pipeline->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored); // up and down it scrolls by itself
    m_doctor = new DoctorPanel(*m_document);
    const auto scrolled = [](QWidget *panel) { return new PanelScroll(panel); };
    std::vector<WorkPlaces::Panel> panels = {
        {"comparison", tr("Comparison"), scrolled(m_comparison), kRight, Qt::ALT | Qt::Key_1},
        {kPipelinePanel, tr("Pipeline"), scrolled(pipeline), kRight, Qt::ALT | Qt::Key_2},
        {"parameters", tr("Parameters"), m_parameters, kLeft, Qt::ALT | Qt::Key_3},
        {"inspector", tr("Viewport"), scrolled(m_inspector), kBottom, Qt::ALT | Qt::Key_4},
        {"lifecycle", tr("Life of the View"), new LifecyclePanel(*m_lifecycle), kBottom, Qt::ALT | Qt::Key_5},
        {"precision", tr("Depth Precision"), scrolled(new DepthPrecisionPanel(*m_document)), kBottom,
         Qt::ALT | Qt::Key_9},
        {"objects", tr("Objects"), objects, kRight, Qt::ALT | Qt::Key_6},
        {"points", tr("Points"), points, kRight, Qt::ALT | Qt::Key_7},
        {"series", tr("Series"), m_seriesPanel, kBottom, Qt::ALT | Qt::Key_8},
        {"doctor", tr("Doctor"), scrolled(m_doctor), kRight, {}},
        {kObserverPanel, tr("View from Outside"), m_observerHome, kRight, {}, true},
        {kLessonPanel, tr("Lesson"), m_lessonPanel, kLeft, {}, true},
    };
    std::vector<WorkPlaces::Place> places = {
        {kClickPlace, tr("Click"), tr("The view and what a click gives"), Qt::Key_F5, {"comparison", "objects"}},
        {kPipelinePlace,
         tr("Pipeline"),
         tr("Every number and every matrix between an object and its pixel"),
         Qt::Key_F6,
         {"pipeline", "parameters", "inspector", "lifecycle"}},
        {kPointsPlace,
         tr("Points"),
         tr("Place points on the surface, name them, move them, measure between them"),
         Qt::Key_F7,
         {"points", "objects"}},
        {kDoctorPlace,
         tr("Doctor"),
         tr("Find the mistake by which your program gets a wrong coordinate"),
         Qt::Key_F8,
         {"doctor", "objects"}},
    };
    Q_ASSERT(std::equal(places.begin(), places.end(), kPlaceIds.begin(), kPlaceIds.end(),
                        [](const WorkPlaces::Place &place, const char *id) { return qstrcmp(place.id, id) == 0; }));
    m_places = new WorkPlaces(*this, std::move(panels), std::move(places));
    connect(m_lessonPanel, &LessonPanel::closeRequested, m_lessons, &LessonPlayer::leave);
    connect(m_lessonPanel, &LessonPanel::linkFollowed, this, &MainWindow::followLessonLink);
    connect(m_places, &WorkPlaces::titled, this, [this](const char *panel, bool hasTitleBar) {
        if (qstrcmp(panel, kLessonPanel) == 0)
            m_lessonPanel->setClosesItself(!hasTitleBar);
    });
    connect(m_places, &WorkPlaces::laidOut, this, &MainWindow::showAccompanying);
    connect(m_places, &WorkPlaces::closed, this, [this](const char *panel) {
        if (qstrcmp(panel, kObserverPanel) == 0)
            m_observerAction->setChecked(false);
        else if (qstrcmp(panel, kLessonPanel) == 0)
            leaveLessonOrStay();
    });
}

void MainWindow::showAccompanying()
{
    m_places->dock(kLessonPanel)->setVisible(m_lessons->lesson() != nullptr);
    hideAnswers();
    giveLessonRoom(false);
    m_places->dock(kObserverPanel)->setVisible(m_observerAction->isChecked() && !m_inset);
    placeFirstSteps();
}

QMenu *MainWindow::createPopupMenu()
{
    auto *menu = new QMenu(this);
    for (const WorkPlaces::Panel &panel : m_places->panels()) {
        if (!panel.standsAlone) // the others would be empty without what shows them
            menu->addAction(panel.dock->toggleViewAction());
    }
    menu->addSeparator();
    menu->addAction(findChild<QToolBar *>()->toggleViewAction());
    return menu;
}

void MainWindow::createPlaceActions(QMenu &menu)
{
    QMenu *places = menu.addMenu(tr("&Work Place")); // two panels have the names of places
    for (const WorkPlaces::Place &place : m_places->places())
        places->addAction(place.action);
    menu.addSeparator();
    for (const WorkPlaces::Panel &panel : m_places->panels()) {
        if (!panel.standsAlone) // the others have actions of their own
            menu.addAction(panel.dock->toggleViewAction());
    }
    QAction *hides = addAction(&menu, tr("H&ide All Panels"), Qt::Key_F9, tr("Give the view the whole window"), {});
    hides->setCheckable(true);
    connect(hides, &QAction::toggled, m_places, &WorkPlaces::hidePanels);
    connect(m_places, &WorkPlaces::panelsHidden, hides, &QAction::setChecked);
    connect(m_places, &WorkPlaces::panelsHidden, this, [this] { wantViewOfLesson(m_viewOfLesson, m_isViewAskedFor); });
    addAction(&menu, tr("R&eset Layout"), {}, tr("Put all panels of this work place back to where they were at first"),
              [this] { m_places->reset(); });
}

void MainWindow::showObserver(bool isShown)
{
    if (!m_observer) {
        if (!isShown)
            return;
        createObserver();
    }
    if (m_inset)
        m_inset->setVisible(isShown);
    else
        m_places->dock(kObserverPanel)->setVisible(isShown);
    m_observer->setVisible(isShown);
}

void MainWindow::createObserver()
{
    m_observer = new ObserverPanel(*m_document);
    m_observer->view().setSmoothEdges(m_smoothEdges);
    m_observer->view().setModelStore(m_session->models());
    connect(&m_observer->view(), &ObserverView::failed, this, &MainWindow::showFailure);
    connect(m_observer, &ObserverPanel::dockRequested, this, &MainWindow::dockObserver);
    connect(m_observer, &ObserverPanel::closeRequested, m_observerAction,
            [this] { m_observerAction->setChecked(false); });
    dockObserver(m_options.remembers && QSettings().value(QStringLiteral("observer/isDocked"), false).toBool());
    showHighlights();
}

void MainWindow::dockObserver(bool isDocked)
{
    m_observer->setIsInset(!isDocked);
    if (isDocked) {
        m_observerHome->layout()->addWidget(m_observer);
        if (m_inset)
            m_insetShare = m_inset->share();
        delete m_inset;
        m_inset = nullptr;
        m_places->show(kObserverPanel);
    } else {
        m_inset = new ObserverInset(*m_observer, *m_viewFrame, m_insetShare);
        m_places->dock(kObserverPanel)->hide();
        m_inset->show();
    }
    m_observer->show();
    if (m_options.remembers && !m_observerBeforeLesson)
        QSettings().setValue(QStringLiteral("observer/isDocked"), isDocked);
}

void MainWindow::hidePanels(bool isHidden)
{
    m_places->hidePanels(isHidden);
}

void MainWindow::restoreLayout()
{
    if (!m_options.remembers)
        return;
    const QSettings settings;
    m_comparison->setShowsFloat(settings.value(QStringLiteral("comparison/showsFloat"), false).toBool());
    const auto kept = [&settings](const char *key) { return unsealed(settings.value(QLatin1String(key)), key); };
    m_parameters->restoreState(kept(kParametersKey));
    restoreGeometry(kept(kGeometryKey));
    m_places->restore(settings);
    m_insetShare = settings.value(QStringLiteral("observer/share")).toSizeF();
    m_observerAction->setChecked(settings.value(QStringLiteral("observer/isShown"), false).toBool());
}

void MainWindow::keepLayout() const
{
    if (!m_options.remembers)
        return;
    QSettings settings;
    settings.setValue(QLatin1String(kGeometryKey), sealed(saveGeometry(), kGeometryKey));
    settings.setValue(QLatin1String(kParametersKey), sealed(m_parameters->saveState(), kParametersKey));
    settings.setValue(QStringLiteral("comparison/showsFloat"), m_comparison->showsFloat());
    m_places->keep(settings);
    settings.setValue(QStringLiteral("observer/share"), m_inset ? m_inset->share() : m_insetShare);
    settings.setValue(QStringLiteral("observer/isShown"), m_observerAction->isChecked());
}

} // namespace unprojector::gui
