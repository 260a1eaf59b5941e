#include "gui/panels/pipeline_model.h"

#include "core/geometry/matrix_projection.h"
#include "gui/document/scene_document.h"
#include "gui/panels/since_click_text.h"
#include "gui/text/error_text.h"

namespace unprojector::gui {
namespace {

using Space = PointModel::Space;

QString movedForwardText()
{
    return PipelineModel::tr(
        "The view has changed since this click: the point on its way through the view as it is now.");
}

QString movedBackText()
{
    return PipelineModel::tr("The view has changed since this click: back from where the point is now.");
}

} // namespace

QStringList PipelineModel::longestStatusTexts()
{
    return longestSinceClickTexts() << movedForwardText() << movedBackText();
}

PipelineModel::PipelineModel(const SceneDocument &document, QObject *parent)
    : QObject(parent), m_document(document), m_chosen(new FollowedObject(document, this)),
      m_given(new MatrixModel(PipelineStage::WholeMatrix, this))
{
    m_given->setVariableName(QStringLiteral("clipFromEyeAsGiven"));
    for (const PipelineStage stage : kPipelineStages)
        m_matrices[static_cast<std::size_t>(stage)] = new MatrixModel(stage, this);
    for (int space = 0; space < PointModel::kSpaces; ++space)
        m_points[static_cast<std::size_t>(space)] = new PointModel(static_cast<Space>(space), this);
    connect(&document, &SceneDocument::opened, this, [this] { m_isIdentity = false; });
    update();
}

std::optional<std::size_t> PipelineModel::shownObject() const
{
    const std::size_t count = m_document.objects().size();
    if (m_isIdentity || count == 0)
        return std::nullopt;
    if (const std::optional<std::size_t> chosen = m_chosen->place())
        return chosen;
    const std::size_t picked = m_document.pick() ? m_document.pick()->object.value_or(0) : 0;
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
    const std::optional<std::size_t> chosen = m_chosen->place();
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
    for (PointModel *point : m_points)
        point->setView(view);
}

void PipelineModel::update()
{
    const std::optional<Pick> &pick = m_document.pick();
    const std::optional<std::size_t> object = shownObject();
    const glm::dmat4 model = object ? worldFromObject(m_document.objects()[*object].transform) : glm::dmat4(1.0);
    const Result<Pipeline> pipeline = matrices::pipeline(m_document.geometry(), model);
    if (!pipeline) {
        // The matrices stay as they last were good.
        clearPoints();
        m_status = errorText(pipeline.error());
        return;
    }
    showGiven();
    const ProjectionKind kind = kindOf(m_document.geometry().projection());
    for (const PipelineStage stage : kPipelineStages)
        matrix(stage)->setMatrix(pipeline->matrix(stage, m_direction), m_direction, kind);
    if (!pick) {
        clearPoints();
        m_status = tr("Press the left button on the model: its point appears at every stage.");
    } else if (!pick->hit()) {
        clearPoints();
        m_status = tr("Background: no surface here, so there is no point to follow.");
    } else {
        showPoints(*pipeline);
    }
}

void PipelineModel::showGiven()
{
    const std::optional<GivenProjection> &given = m_document.scene().given;
    m_givenNote.clear();
    if (!given || given->converted != m_document.geometry().projection())
        return;
    const Result<RecognisedProjection> form = recognised(given->matrix);
    if (!form)
        return;
    m_given->setMatrix(given->matrix.clipFromEye, PipelineDirection::Forward, kindOf(given->converted));
    QStringList said{form->ndcDepth == NdcDepth::ZeroToOne ? tr("z of NDC from 0 to 1") : tr("z of NDC from −1 to 1")};
    if (form->reversed)
        said << tr("reversed: the depth range is turned round for it");
    if (form->infiniteFar)
        said << tr("the far plane at infinity: here at a million times near");
    m_givenNote =
        tr("As the file gives it: %1. Clip and NDC are those of its conversion, OpenGL's matrix of the same view "
           "volume, which follows.")
            .arg(said.join(QStringLiteral("; ")));
}

void PipelineModel::showPoints(const Pipeline &pipeline)
{
    const Pick &pick = *m_document.pick();
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
        m_status = isFresh ? tr("Back from the clicked pixel's centre and the depth read there.") : movedBackText();
    } else {
        m_status = tr("The picked point on its way to the window.");
    }
    // What has changed since the click is said in the words of the comparison; only that the numbers of the other view are
    // shown here, and not those of the click, is the pipeline's own.
    const SinceClick since = m_document.sinceClick();
    const bool isOutside = since.isOtherPicture && points.clip && !isInsideViewVolume(*points.clip);
    if (since.isObjectMoved || since.isObjectHidden || since.isCutAway || isOutside)
        m_status = sinceClickText(m_document);
    else if (since.isOtherPicture && m_direction == PipelineDirection::Forward)
        m_status = movedForwardText();
    point(Space::Object)->setPoint(points.object);
    point(Space::World)->setPoint(points.world);
    point(Space::Eye)->setPoint(points.eye);
    if (m_direction == PipelineDirection::Forward)
        point(Space::Clip)->setPoint(points.clip);
    else
        point(Space::Clip)->setUndivided(points.undividedEye);
    point(Space::Ndc)->setPoint(points.ndc);
    point(Space::Window)->setPoint(points.window);
    point(Space::Widget)->setPoint(points.widget);
    if (!points.widget)
        m_status = errorText(points.widget.error());
    else if (!points.object)
        m_status = errorText(points.object.error());
}

bool PipelineModel::isDepthRead() const
{
    const std::optional<Pick> &pick = m_document.pick();
    return pick && pick->hit() && pick->geometry == m_document.geometry();
}

void PipelineModel::clearPoints()
{
    for (PointModel *point : m_points)
        point->clearPoint();
}

QString PipelineModel::text() const
{
    QString text = m_status + u'\n';
    const bool forward = m_direction == PipelineDirection::Forward;
    for (int i = 0; i < PointModel::kSpaces; ++i) {
        const PointModel *model = m_points[static_cast<std::size_t>(forward ? i : PointModel::kSpaces - 1 - i)];
        text += QStringLiteral("%1\t%2\n").arg(model->name(), model->fullText());
    }
    for (const MatrixModel *model : m_matrices)
        text += QStringLiteral("\n%1\n%2").arg(model->variableName(), model->copyText(MatrixSyntax::Text));
    if (!m_givenNote.isEmpty())
        text += QStringLiteral("\n%1\n%2").arg(m_given->variableName(), m_given->copyText(MatrixSyntax::Text));
    return text;
}

} // namespace unprojector::gui
