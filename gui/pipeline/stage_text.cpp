#include "gui/pipeline/stage_text.h"

#include "gui/text/help_anchors.h"
#include "gui/text/number_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <utility>
#include <vector>

namespace unprojector::gui {
using namespace geometry;
using namespace pipeline;

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::StageText)
};

} // namespace

QString stageName(PipelineStage stage, PipelineDirection direction)
{
    QString name;
    switch (stage) {
    case PipelineStage::ModelMatrix: name = Texts::tr("Model"); break;
    case PipelineStage::ViewMatrix: name = Texts::tr("View"); break;
    case PipelineStage::ProjectionMatrix: name = Texts::tr("Projection"); break;
    case PipelineStage::ViewportMatrix: name = Texts::tr("Viewport"); break;
    case PipelineStage::ModelviewMatrix: name = Texts::tr("Modelview"); break;
    case PipelineStage::WholeMatrix: name = Texts::tr("All"); break;
    }
    return direction == PipelineDirection::Forward ? name : name + QStringLiteral("⁻¹");
}

QString stageSpaces(PipelineStage stage, PipelineDirection direction)
{
    using Space = PointModel::Space;
    const auto ends = [stage] {
        switch (stage) {
        case PipelineStage::ModelMatrix: return std::pair(Space::Object, Space::World);
        case PipelineStage::ViewMatrix: return std::pair(Space::World, Space::Eye);
        case PipelineStage::ProjectionMatrix: return std::pair(Space::Eye, Space::Clip);
        case PipelineStage::ViewportMatrix: return std::pair(Space::Ndc, Space::Window);
        case PipelineStage::ModelviewMatrix: return std::pair(Space::Object, Space::Eye);
        case PipelineStage::WholeMatrix: return std::pair(Space::Object, Space::Window);
        }
        Q_UNREACHABLE();
    };
    auto [from, to] = ends();
    if (direction == PipelineDirection::Backward)
        std::swap(from, to);
    return QStringLiteral("%1 → %2").arg(PointModel::nameOf(from), PointModel::nameOf(to));
}

QString stageTitle(PipelineStage stage, PipelineDirection direction)
{
    return Texts::tr("%1: %2").arg(stageName(stage, direction), stageSpaces(stage, direction));
}

QString productText(PipelineStage stage, PipelineDirection direction, MatrixLayout layout)
{
    std::vector<PipelineStage> stages;
    if (stage == PipelineStage::ModelviewMatrix)
        stages = {PipelineStage::ViewMatrix, PipelineStage::ModelMatrix};
    else if (stage == PipelineStage::WholeMatrix)
        stages = {PipelineStage::ViewportMatrix, PipelineStage::ProjectionMatrix, PipelineStage::ViewMatrix,
                  PipelineStage::ModelMatrix};
    else
        return {};
    // The inverse and row vectors each reverse the order.
    if ((direction == PipelineDirection::Backward) != (layout == MatrixLayout::Row))
        std::reverse(stages.begin(), stages.end());
    QStringList names;
    for (const PipelineStage factor : stages)
        names << stageName(factor, direction);
    return QStringLiteral("= ") + names.join(QStringLiteral(" · "));
}

QString stageHelp(PipelineStage stage, PipelineDirection direction, ProjectionKind projection)
{
    if (direction == PipelineDirection::Backward)
        return QStringLiteral("matrix");
    switch (stage) {
    case PipelineStage::ModelMatrix: return QStringLiteral("model");
    case PipelineStage::ViewMatrix: return QStringLiteral("view");
    case PipelineStage::ProjectionMatrix: return helpAnchorOf(projection);
    case PipelineStage::ViewportMatrix: return QStringLiteral("viewport");
    case PipelineStage::ModelviewMatrix:
    case PipelineStage::WholeMatrix: return QStringLiteral("mvpw");
    }
    Q_UNREACHABLE();
}

QString flipText(const PipelineModel &model, const Surface &surface)
{
    const ApiConventions &api = conventionsOf(model.api());
    const double pixelRatio = api.areLogicalPixels ? 1.0 : surface.devicePixelRatio;
    const bool isForward = model.direction() == PipelineDirection::Forward;
    const QString ratio = pixelRatio == 1.0 ? QString() : significantText(pixelRatio, 6);
    const QString half = api.pixelCentre != 0.0 ? QString()
                         : isForward            ? QStringLiteral(" + ½")
                                                : QStringLiteral(" − ½");
    const auto axis = [&](QChar name, bool isFlipped) {
        const QString scaled =
            isForward || ratio.isEmpty() ? QString(name) : QStringLiteral("%1 · %2").arg(name).arg(ratio);
        return (isFlipped ? QStringLiteral("%1 − ").arg(surface.heightPixels) : QString()) + scaled + half;
    };
    QString text = QStringLiteral("↓  (%1, %2)").arg(axis(u'x', false), axis(u'y', !api.isOriginTop));
    if (isForward && !ratio.isEmpty())
        text += QStringLiteral(" / ") + ratio;
    if (isForward)
        return text;
    return model.isDepthRead() ? Texts::tr("%1, depth as read").arg(text) : Texts::tr("%1, depth computed").arg(text);
}

} // namespace unprojector::gui
