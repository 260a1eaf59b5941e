#include "gui/pipeline/pipeline_model.h"

#include "core/base/expression.h"
#include "core/geometry/matrix_projection.h"
#include "gui/document/given_points.h"
#include "gui/document/object_names.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/document/since_click_text.h"
#include "gui/pipeline/matrix_text.h"
#include "gui/text/api_text.h"
#include "gui/text/error_text.h"
#include "gui/text/sentences.h"
#include "gui/text/typed_numbers.h"

#include <type_traits>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace cameras;
using namespace pipeline;
using namespace scene;
using namespace unproject;

namespace {

using Space = PointModel::Space;

} // namespace

PipelineModel::PipelineModel(SceneDocument &document, QObject *parent)
    : QObject(parent), m_document(document), m_chosen(new FollowedObject(document, this)),
      m_given(new MatrixModel(PipelineStage::WholeMatrix, this)),
      m_givenView(new MatrixModel(PipelineStage::WholeMatrix, this))
{
    m_given->setVariableName(QStringLiteral("clipFromEyeAsGiven"));
    m_givenView->setVariableName(QStringLiteral("eyeFromWorldAsGiven"));
    for (const PipelineStage stage : kPipelineStages)
        m_matrices[static_cast<std::size_t>(stage)] = new MatrixModel(stage, this);
    for (int space = 0; space < PointModel::kSpaces; ++space)
        m_points[static_cast<std::size_t>(space)] = new PointModel(static_cast<Space>(space), this);
    for (PointModel *point : m_points)
        connect(point, &PointModel::typed, this,
                [this, point](int coordinate, const QString &text) { take(point->space(), coordinate, text); });
    connect(&document, &SceneDocument::opened, this, [this] { m_isIdentity = false; });
    // Follows changes while hidden too: the later of the two is shown.
    connect(&document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Pick)
            m_showsClick = false;
        if (changes & Change::GivenPoint)
            m_followsGiven = m_document.scene().givenPoint.has_value();
        else if (changes & Change::Pick && m_document.picks().pick())
            m_followsGiven = false;
        else
            return;
        emit followedChanged();
    });
    m_followsGiven = document.scene().givenPoint.has_value();
    update();
}

bool PipelineModel::followsGiven() const
{
    return m_followsGiven && m_document.scene().givenPoint;
}

void PipelineModel::followGiven(bool follows)
{
    if (std::exchange(m_followsGiven, follows) == follows)
        return;
    update();
    emit followedChanged();
}

bool PipelineModel::canShowClick() const
{
    const SinceClick since = m_document.picks().sinceClick();
    return !followsGiven() && (since.isOtherSetup || since.isObjectMoved);
}

void PipelineModel::setShowsClick(bool shows)
{
    shows = shows && canShowClick();
    if (std::exchange(m_showsClick, shows) == shows)
        return;
    update();
    emit followedChanged();
}

const Setup &PipelineModel::setup() const
{
    return showsClick() ? m_document.picks().pick()->setup : m_document.setup();
}

bool PipelineModel::isViewGiven() const
{
    return !showsClick() && m_document.scene().camera.matrix();
}

bool PipelineModel::isProjectionGiven() const
{
    return !showsClick() && m_document.scene().projection.matrix();
}

glm::dmat4 PipelineModel::placement() const
{
    const std::optional<std::size_t> object = shownObject();
    if (!object)
        return glm::dmat4(1.0);
    const KeptPick &kept = m_document.picks().keptPick();
    return showsClick() && kept.pick->object == object ? kept.placement.rounded()
                                                       : worldFromObject(m_document.objects()[*object].transform);
}

void PipelineModel::removeGiven()
{
    static_cast<void>(m_document.edit({tr("Remove Your Point")}, [](Scene &scene) { scene.givenPoint.reset(); }));
}

void PipelineModel::take(Space space, int coordinate, const QString &typed)
{
    if (showsClick()) {
        emit refused(tr("These are the values at the click. To give a point, choose “Now” first."));
        return;
    }
    const std::size_t count = point(space)->ownCount();
    std::vector<double> values = point(space)->coordinates();
    if (values.empty()) { // a clip point's w is 1 until it is typed
        values.assign(count, 0.0);
        if (space == Space::Clip)
            values.back() = 1.0;
    }
    const std::optional<std::vector<double>> all = count < 3 ? std::nullopt : typedNumbers(typed, count);
    if (all) {
        values = *all;
    } else {
        const base::Expected<double, base::ExpressionError> value = base::evaluate(typed.toStdString());
        if (!value) {
            emit refused(errorText(value.error(), typed));
            return;
        }
        values[static_cast<std::size_t>(coordinate)] = *value;
    }
    const AxisChange ours = changeOf(space).inverse();
    if (count == 4) {
        const glm::dvec4 p = ours * glm::dvec4(values[0], values[1], values[2], values[3]);
        values = {p.x, p.y, p.z, p.w};
    } else if (count == 3) {
        const glm::dvec3 p = ours * glm::dvec3(values[0], values[1], values[2]);
        values = {p.x, p.y, p.z};
    }
    GivenPoint given;
    switch (space) {
    case Space::Object: {
        given.point = ObjectPoint(values[0], values[1], values[2]);
        if (const std::optional<std::size_t> object = shownObject())
            given.object = m_document.objects()[*object].name;
        break;
    }
    case Space::World: given.point = WorldPoint(values[0], values[1], values[2]); break;
    case Space::Eye: given.point = EyePoint(values[0], values[1], values[2]); break;
    case Space::Clip: given.point = ClipPoint(values[0], values[1], values[2], values[3]); break;
    case Space::Ndc: given.point = NdcPoint(values[0], values[1], values[2]); break;
    case Space::Window: given.point = WindowPoint(values[0], values[1], values[2]); break;
    case Space::Widget: {
        const std::vector<double> window = point(Space::Window)->coordinates();
        if (window.empty()) {
            emit refused(
                tr("A widget position has no depth. Type the window point instead: its third number is the depth."));
            return;
        }
        const Surface &surface = m_document.setup().surface;
        const double depth = (m_spaces.window.inverse() * glm::dvec3(window[0], window[1], window[2])).z;
        given.point = windowFromDevice(surface, deviceFromWidget(surface, WidgetPoint(values[0], values[1])), depth);
        break;
    }
    }
    const Check taken = m_document.edit({tr("Give a Point in %1 Coordinates").arg(point(space)->name())},
                                        [&](Scene &scene) { scene.givenPoint = given; });
    if (!taken) {
        emit refused(errorText(taken.error()));
        return;
    }
    followGiven(true); // also for the same numbers again
}

std::optional<std::size_t> PipelineModel::shownObject() const
{
    const std::size_t count = m_document.objects().size();
    if (m_isIdentity || count == 0)
        return std::nullopt;
    if (const std::optional<std::size_t> chosen = m_chosen->index())
        return chosen;
    if (followsGiven() && std::holds_alternative<ObjectPoint>(m_document.scene().givenPoint->point))
        return indexOf(*m_document.scene().givenPoint, m_document.objects());
    const std::size_t picked = m_document.picks().pick() ? m_document.picks().pick()->object.value_or(0) : 0;
    return picked < count ? std::optional(picked) : std::nullopt;
}

void PipelineModel::setDirection(PipelineDirection direction)
{
    m_direction = direction;
    for (PointModel *point : m_points)
        point->setDirection(direction);
    update();
}

int PipelineModel::object() const
{
    if (m_isIdentity)
        return kNoObject;
    const std::optional<std::size_t> chosen = m_chosen->index();
    return chosen ? static_cast<int>(*chosen) : kAutomaticObject;
}

void PipelineModel::setObject(int object)
{
    m_isIdentity = object == kNoObject;
    m_chosen->choose(object >= 0 ? std::optional(static_cast<std::size_t>(object)) : std::nullopt);
    update();
}

void PipelineModel::setView(const MatrixView &view)
{
    m_view = view;
    for (MatrixModel *matrix : m_matrices)
        matrix->setView(view);
    m_given->setView(view);
    m_givenView->setView(view);
    for (PointModel *point : m_points)
        point->setView(view);
}

void PipelineModel::update()
{
    m_showsClick = showsClick(); // where the view is as it was again, the next change is seen
    const std::optional<Pick> &pick = m_document.picks().pick();
    const Result<Pipeline> pipeline = pipeline::pipelineOf(setup(), placement());
    if (!pipeline) {
        // The matrices keep their last valid values.
        clearPoints();
        m_status = errorText(pipeline.error());
        return;
    }
    showApi();
    showGiven();
    const ProjectionKind kind = kindOf(setup().projection());
    const bool isSkewed = projectionWindow(setup().projection()).skew != 0.0;
    const Pipeline shown = m_api == Api::OpenGl ? *pipeline : inApi(*pipeline, m_spaces);
    for (const PipelineStage stage : kPipelineStages) {
        const glm::dmat4 &entries = shown.matrix(stage, m_direction);
        matrix(stage)->setMatrix(entries, m_direction, kind, entries == pipeline->matrix(stage, m_direction), isSkewed);
    }
    if (followsGiven()) {
        showGivenPoint(*pipeline);
    } else if (!pick) {
        clearPoints();
        m_status = tr("Click the model, or type a point into any row.");
    } else if (!pick->hit()) {
        clearPoints();
        m_status = tr("Background: no surface here, so there is no point to follow.");
    } else {
        showPoints(*pipeline);
    }
}

AxisChange PipelineModel::changeOf(Space space) const
{
    switch (space) {
    case Space::World: return m_spaces.world;
    case Space::Eye: return m_spaces.eye;
    case Space::Clip:
    case Space::Ndc: return m_spaces.clip;
    case Space::Window: return m_spaces.window;
    case Space::Object:
    case Space::Widget: break;
    }
    return {};
}

std::optional<std::vector<MatrixFactor>> PipelineModel::factors(PipelineStage stage) const
{
    if (m_direction == PipelineDirection::Backward)
        return std::nullopt;
    if (stage == PipelineStage::ViewMatrix) {
        if (const auto parts = pipeline::factors(setup().camera()))
            return inConventions(*parts, m_spaces.world, m_spaces.eye);
    } else if (stage == PipelineStage::ProjectionMatrix) {
        if (const auto parts = pipeline::factors(setup().projection()))
            return inConventions(*parts, m_spaces.eye, m_spaces.clip);
    }
    return std::nullopt;
}

void PipelineModel::setApi(Api api)
{
    static_cast<void>(m_document.edit({tr("Conventions of %1").arg(QString::fromUtf8(conventionsOf(api).name))},
                                      [api](Scene &scene) { scene.conventions = api; }));
}

void PipelineModel::showApi()
{
    m_api = m_document.scene().conventions;
    m_spaces = apiSpaces(setup(), m_api);
    for (PointModel *point : m_points)
        point->setApi(m_api);
    m_apiNote.clear();
    if (m_api == Api::OpenGl)
        return;
    m_apiNote = apiText(m_api);
    if (m_api != Api::OpenCv)
        return;
    // OpenCV's camera has no clip space and no depth buffer: these rows are OpenGL's, computed from
    // OpenCV's eye space.
    const auto camera = apiCamera(setup(), m_api);
    m_apiNote =
        joinSentences({m_apiNote, tr("Here clip, NDC and depth stay OpenGL's; the view's matrix is [R t].")}) + u'\n';
    m_apiNote += camera && camera->intrinsics ? intrinsicsText(*camera->intrinsics)
                                              : tr("Without a perspective there is no camera matrix K.");
}

void PipelineModel::showGiven()
{
    m_givenNote.clear();
    m_projectionFindings.clear();
    m_viewFindings.clear();
    const MatrixProjection *given = isProjectionGiven() ? m_document.scene().projection.matrix() : nullptr;
    if (const glm::dmat4 *view = isViewGiven() ? m_document.scene().camera.matrix() : nullptr) {
        m_givenView->setMatrix(viewFromOurs(*view, m_api), PipelineDirection::Forward, ProjectionKind::Perspective);
        m_viewFindings =
            findings(*view, MatrixRole::View, std::nullopt, given ? std::optional(given->clipFromEye) : std::nullopt);
    }
    const Result<RecognisedProjection> form = given ? recognised(*given) : Error{};
    if (!form)
        return;
    m_projectionFindings = findings(given->clipFromEye, MatrixRole::Projection, given->ndcDepth);
    m_given->setMatrix(apiFromOurs(*given, m_api).clipFromEye, PipelineDirection::Forward,
                       kindOf(m_document.setup().projection()), m_api == Api::OpenGl);
    QStringList said{form->ndcDepth == NdcDepth::ZeroToOne ? tr("z of NDC from 0 to 1") : tr("z of NDC from −1 to 1")};
    if (form->reversed)
        said << tr("reversed: the depth range is reversed to match");
    if (form->infiniteFar)
        said << tr("the far plane at infinity: here at a million times near");
    m_givenNote = tr("The matrix as given: %1. Clip and NDC use its conversion, which follows: OpenGL's matrix of the "
                     "same view volume.")
                      .arg(said.join(QStringLiteral("; ")));
}

const std::vector<MatrixFinding> &PipelineModel::givenFindings(MatrixRole role) const
{
    return role == MatrixRole::View ? m_viewFindings : m_projectionFindings;
}

void PipelineModel::repair(MatrixRole role, const MatrixFinding &finding)
{
    const EditLabel label{repairName(finding, NumberOrder::ByColumns)};
    std::optional<Lens> projection;
    std::optional<glm::dmat4> view;
    if (const MatrixProjection *given = m_document.scene().projection.matrix();
        given && role == MatrixRole::Projection) {
        const bool isZeroToOne = finding.repair == MatrixRepair::DepthZeroToOne;
        projection = MatrixProjection{repaired(given->clipFromEye, finding),
                                      isZeroToOne ? NdcDepth::ZeroToOne : given->ndcDepth};
    } else if (const glm::dmat4 *eyeFromWorld = m_document.scene().camera.matrix();
               eyeFromWorld && role == MatrixRole::View) {
        view = repaired(*eyeFromWorld, finding);
    }
    if (const Check done = editMatrices(m_document, projection, view, label); !done)
        emit refused(errorText(done.error()));
}

void PipelineModel::showPoints(const Pipeline &pipeline)
{
    const Pick &pick = *m_document.picks().pick();
    const Result<WorldPoint> &world = pick.point.world[Method::Formula];
    if (!world) {
        clearPoints();
        m_status = errorText(world.error());
        return;
    }
    const bool isFresh = isDepthRead();
    PipelinePoints points = pointsForward(pipeline, *world);
    if (m_direction == PipelineDirection::Backward) {
        const Result<WindowPoint> start = isFresh ? Result<WindowPoint>(pick.window) : points.window;
        if (start)
            points = pointsBackward(pipeline, *start);
        m_status = isFresh ? tr("Backward from the clicked pixel's centre and its depth.")
                           : tr("The view has changed since this click. Values below use the current view.");
    } else {
        m_status = tr("Forward from the clicked point.");
    }
    // The comparison's text describes the changes since the click. The pipeline adds only whether
    // its numbers belong to the click or to the current view.
    if (showsClick()) {
        m_status = m_direction == PipelineDirection::Forward
                       ? tr("Values at the click: forward from the clicked point.")
                       : tr("Values at the click: backward from the pixel's centre and its depth.");
        showAll(points);
        return;
    }
    const SinceClick since = m_document.picks().sinceClick();
    const bool isOutside = since.isOtherSetup && points.clip && !isInsideViewVolume(*points.clip);
    if (since.isObjectMoved || since.isObjectHidden || since.isCutAway || isOutside)
        m_status = sinceClickText(m_document);
    else if (since.isOtherSetup && m_direction == PipelineDirection::Forward)
        m_status = tr("The view has changed since this click. Values below use the current view.");
    showAll(points);
}

void PipelineModel::showGivenPoint(const Pipeline &pipeline)
{
    const GivenPoint &given = *m_document.scene().givenPoint;
    const PipelinePoints points = pointsFrom(pipeline, given);
    const QString space = point(static_cast<Space>(given.point.index()))->name();
    const bool isObject = std::holds_alternative<ObjectPoint>(given.point);
    if (isObject && !given.object.empty() && !indexOf(given, m_document.objects()))
        m_status = tr("Your point was given in the space of “%1”, which does not exist: it is read as a world point.")
                       .arg(shownObjectName(given.object, m_document.objects()));
    else if (const QString outside = points.clip ? clipTestText(*points.clip) : QString(); !outside.isEmpty())
        m_status = tr("Your point in %1 coordinates is outside the view volume: %2.").arg(space, outside);
    else
        m_status = tr("Your point in %1 coordinates. Every other stage is computed from it.").arg(space);
    showAll(points);
}

void PipelineModel::showAll(const PipelinePoints &points)
{
    point(Space::Object)->setPoint(points.object);
    const auto show = [this](Space space, const auto &ours) {
        auto shown = ours;
        if (ours)
            shown = std::decay_t<decltype(*ours)>(changeOf(space) * ours->coordinates());
        point(space)->setPoint(shown);
    };
    show(Space::World, points.world);
    show(Space::Eye, points.eye);
    if (m_direction == PipelineDirection::Forward)
        show(Space::Clip, points.clip);
    else // the eye point before the division
        point(Space::Clip)
            ->setUndivided(points.undividedEye ? std::optional(m_spaces.eye * *points.undividedEye) : std::nullopt);
    show(Space::Ndc, points.ndc);
    show(Space::Window, points.window);
    point(Space::Widget)->setPoint(points.widget);
    if (!points.widget)
        m_status = errorText(points.widget.error());
    else if (!points.object)
        m_status = errorText(points.object.error());
}

bool PipelineModel::isDepthRead() const
{
    if (followsGiven())
        return false;
    const std::optional<Pick> &pick = m_document.picks().pick();
    return pick && pick->hit() && pick->setup == setup();
}

void PipelineModel::clearPoints()
{
    for (PointModel *point : m_points)
        point->clearPoint();
}

QString PipelineModel::text() const
{
    QString text = m_status + u'\n';
    if (m_api != Api::OpenGl)
        text += QString::fromUtf8(conventionsOf(m_api).name) + QStringLiteral(": ") + m_apiNote + u'\n';
    const bool forward = m_direction == PipelineDirection::Forward;
    for (int i = 0; i < PointModel::kSpaces; ++i) {
        const PointModel *model = m_points[static_cast<std::size_t>(forward ? i : PointModel::kSpaces - 1 - i)];
        text += QStringLiteral("%1\t%2\n").arg(model->name(), model->fullText());
    }
    for (const MatrixModel *model : m_matrices)
        text += QStringLiteral("\n%1\n%2").arg(model->variableName(), model->copyText(MatrixSyntax::Text));
    if (isViewGiven())
        text += QStringLiteral("\n%1\n%2").arg(m_givenView->variableName(), m_givenView->copyText(MatrixSyntax::Text));
    if (!m_givenNote.isEmpty())
        text += QStringLiteral("\n%1\n%2").arg(m_given->variableName(), m_given->copyText(MatrixSyntax::Text));
    return text;
}

} // namespace unprojector::gui
