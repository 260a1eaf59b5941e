#include "gui/shading/shading_feature.h"

#include "gui/document/clip_cuts.h"
#include "gui/document/model_store.h"
#include "gui/document/pick_history.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/document/session.h"
#include "gui/shading/curvature_bar.h"
#include "gui/shading/light_drag.h"
#include "gui/shading/model_curvatures.h"
#include "gui/text/number_text.h"
#include "gui/view/scene_view.h"
#include "gui/window/actions.h"
#include "gui/window/feature.h"
#include "gui/window/view_frame.h"
#include "gui/window/window.h"

#include <QAction>
#include <QMenu>
#include <QSettings>

#include <algorithm>
#include <utility>
#include <vector>

namespace unprojector::gui {
using namespace geometry;
using namespace mesh;
using namespace scene;

class ShadingFeature : public Feature {
    Q_OBJECT
public:
    explicit ShadingFeature(Window &window);

    void addActions(MenuKind kind, QMenu &menu, QToolBar &) override;
    void keep(QSettings &settings) const override;
    void restore(const QSettings &settings) override;
    using Feature::restore;

private:
    void addCuts(QMenu &menu);
    void cutAtPick();
    void cutThroughPicks();
    void tell(CutFault fault);

    /// Computes missing curvatures, if they are shown.
    void prepareCurvatures();
    void cancelCurvatures();
    /// Follows the computation of curvatures.
    void takeCurvatures();
    /// Explains the shades, once they are shown.
    void explainCurvature();
    void apply();

    Window &m_window;
    SceneDocument &m_document;
    PickHistory *m_picks;
    LightDrag *m_light;
    ModelCurvatures *m_curvatures;
    CurvatureBar *m_bar;
    QAction *m_isLit = nullptr;
    QAction *m_isCurved = nullptr;
    QAction *m_hasColors = nullptr;
    QAction *m_hasEdges = nullptr;
    bool m_isToExplain = false; ///< the user has just asked for the curvature
};

ShadingFeature::ShadingFeature(Window &window)
    : Feature(&window), m_window(window), m_document(window.document()), m_picks(new PickHistory(m_document, this)),
      m_light(new LightDrag(window.view())), m_curvatures(new ModelCurvatures), m_bar(new CurvatureBar)
{
    m_light->setParent(this);
    m_curvatures->setParent(this);
    window.frame().addNote(*m_bar);
    connect(m_light, &LightDrag::turned, this, [this] {
        m_isLit->setChecked(true);
        apply();
    });
    connect(m_curvatures, &ModelCurvatures::changed, this, &ShadingFeature::takeCurvatures);
    connect(m_curvatures, &ModelCurvatures::progressed, m_bar, &CurvatureBar::setProgress);
    connect(m_curvatures, &ModelCurvatures::jobFailed, &window, [this](const JobFailure &failure) {
        m_window.showFailure(tr("The curvature is not shown: %1.").arg(failureText(failure)));
    });
    connect(m_bar, &CurvatureBar::cancelRequested, this, &ShadingFeature::cancelCurvatures);
    connect(&window.session().models(), &ModelStore::standInReady, this, &ShadingFeature::prepareCurvatures);
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Objects)
            prepareCurvatures();
    });
}

void ShadingFeature::addActions(MenuKind kind, QMenu &menu, QToolBar &)
{
    if (kind != MenuKind::View)
        return;
    QMenu &shading = *menu.addMenu(tr("Sha&ding"));
    m_isLit = addSwitch(shading, tr("&Light from the Side"), Qt::Key_L,
                        tr("Light the surface from one side, so that ridges and wrinkles show. Ctrl + Shift + drag "
                           "turns the light"));
    m_isCurved =
        addSwitch(shading, tr("&Curvature"), Qt::Key_C, tr("Draw ridges light and valleys dark, in any light"));
    m_hasColors = addSwitch(shading, tr("C&olours and Textures"), Qt::Key_T,
                            tr("Show the colours of the model; without them, the surface is grey"));
    m_hasColors->setChecked(true);
    m_hasEdges = addSwitch(shading, tr("&Edges of Triangles"), Qt::Key_W,
                           tr("Draw the edges of triangles that are more than a few pixels large"));
    for (QAction *action : {m_isLit, m_hasColors, m_hasEdges})
        connect(action, &QAction::toggled, this, &ShadingFeature::apply);
    connect(m_isCurved, &QAction::toggled, this, [this](bool isOn) {
        if (!isOn) {
            m_isToExplain = false;
            m_curvatures->cancel();
        }
        prepareCurvatures();
        if (!m_curvatures->isComputing()) // else a large model would be drawn once more for nothing
            takeCurvatures();
    });
    connect(m_isCurved, &QAction::triggered, this, [this](bool isOn) { // after `toggled`
        m_isToExplain = isOn;
        if (!m_curvatures->isComputing())
            explainCurvature();
    });
    addCuts(shading);
}

void ShadingFeature::addCuts(QMenu &menu)
{
    menu.addSeparator();
    addAction(menu, tr("Clip &at the Pick"), Qt::SHIFT | Qt::Key_C,
              tr("Cut away everything in front of the picked point, across the view"), [this] { cutAtPick(); });
    addAction(menu, tr("Clip &Through the Last Two Picks"), {},
              tr("Cut along the line through the last two picked points, straight away from the eye"),
              [this] { cutThroughPicks(); });
    QAction *flip = addAction(menu, tr("&Flip the Last Clip Plane"), {},
                              tr("Keep the other side of the last clip plane"), [this] { flipLastCut(m_document); });
    QAction *remove =
        addAction(menu, tr("&Remove the Last Clip Plane"), {}, tr("Show what the last clip plane has cut away"),
                  [this] { removeLastCut(m_document); });
    const auto enable = [this, flip, remove] {
        for (QAction *action : {flip, remove})
            action->setEnabled(!m_document.scene().clipPlanes.empty());
    };
    connect(&m_document, &SceneDocument::changed, flip, enable);
    enable();
}

void ShadingFeature::keep(QSettings &settings) const
{
    settings.setValue(QStringLiteral("shading/isLitFromTheSide"), m_isLit->isChecked());
    settings.setValue(QStringLiteral("shading/light"),
                      QPointF(static_cast<double>(m_light->place().x), static_cast<double>(m_light->place().y)));
    settings.setValue(QStringLiteral("shading/hasCurvature"), m_isCurved->isChecked());
    settings.setValue(QStringLiteral("shading/hasColours"), m_hasColors->isChecked());
    settings.setValue(QStringLiteral("shading/hasEdges"), m_hasEdges->isChecked());
}

void ShadingFeature::restore(const QSettings &settings)
{
    const QVariant light = settings.value(QStringLiteral("shading/light"));
    if (light.canConvert<QPointF>())
        m_light->setPlace(glm::vec2(light.toPointF().x(), light.toPointF().y()));
    m_isLit->setChecked(settings.value(QStringLiteral("shading/isLitFromTheSide"), false).toBool());
    m_isCurved->setChecked(settings.value(QStringLiteral("shading/hasCurvature"), false).toBool());
    m_hasColors->setChecked(settings.value(QStringLiteral("shading/hasColours"), true).toBool());
    m_hasEdges->setChecked(settings.value(QStringLiteral("shading/hasEdges"), false).toBool());
}

void ShadingFeature::tell(CutFault fault)
{
    switch (fault) {
    case CutFault::None: return;
    case CutFault::TooMany:
        m_window.notice(tr("The scene has %1 clip planes, and takes no more. Remove one first.").arg(kMostClipPlanes));
        return;
    case CutFault::NoDirection:
        m_window.notice(tr("The two points are behind each other in this view. Turn the view, or pick another point."));
        return;
    case CutFault::Refused: m_window.notice(tr("The clip plane could not be set here.")); return;
    }
}

void ShadingFeature::cutAtPick()
{
    if (const std::optional<WorldPoint> point = m_document.picks().pickedPoint())
        tell(cutAcrossView(m_document, *point));
    else
        m_window.notice(tr("Click a point of the surface first: the clip plane goes through it."));
}

void ShadingFeature::cutThroughPicks()
{
    std::vector<WorldPoint> points;
    for (const EarlierPick &pick : m_picks->picks()) {
        if (const std::optional<WorldPoint> point = pickedPoint(pick.kept))
            points.push_back(*point);
    }
    if (points.size() < 2)
        m_window.notice(tr("Click two points of the surface first: the clip plane goes through them."));
    else
        tell(cutAlongView(m_document, points[points.size() - 2], points.back()));
}

void ShadingFeature::prepareCurvatures()
{
    if (!m_isCurved->isChecked()) {
        m_bar->finish();
        return;
    }
    ModelCurvatures::ModelList models;
    for (const SceneObject &object : m_document.objects())
        models.push_back(object.model);
    if (const auto standIns = m_window.session().models().standInsFor(m_document.objects())) {
        for (const SceneObject &object : *standIns)
            models.push_back(object.model);
    }
    m_curvatures->prepare(models);
    if (m_curvatures->isComputing())
        m_bar->start();
    else
        m_bar->finish();
}

void ShadingFeature::cancelCurvatures()
{
    m_isCurved->setChecked(false);
    m_window.notice(tr("The curvature was cancelled. Press C to compute it."));
}

void ShadingFeature::takeCurvatures()
{
    if (!m_curvatures->isComputing()) {
        m_bar->finish();
        explainCurvature();
    }
    apply();
}

void ShadingFeature::explainCurvature()
{
    if (!std::exchange(m_isToExplain, false))
        return;
    double distance = 0.0;
    for (const SceneObject &object : m_document.objects()) {
        if (const auto found = m_curvatures->all().find(object.model); found != m_curvatures->all().end())
            distance = std::max(distance, found->second->smoothingDistance);
    }
    constexpr int kDigits = 2;
    m_window.notice(
        distance > 0.0
            ? tr("Ridges are light, valleys are dark. Smoothed over %1 units.").arg(significantText(distance, kDigits))
            : tr("No object has a surface with a curvature."));
}

void ShadingFeature::apply()
{
    Shading shading;
    if (m_isLit->isChecked())
        shading.sideLight = m_light->direction();
    shading.hasColors = m_hasColors->isChecked();
    shading.hasEdges = m_hasEdges->isChecked();
    if (m_isCurved->isChecked())
        shading.curvatures = m_curvatures->all();
    m_window.view().setShading(std::move(shading));
}

Feature *makeShadingFeature(Window &window)
{
    return new ShadingFeature(window);
}

} // namespace unprojector::gui

#include "shading_feature.moc"
