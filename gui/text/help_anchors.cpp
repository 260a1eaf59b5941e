#include "gui/text/help_anchors.h"

namespace unprojector::gui {

QString helpAnchorOf(const QString &number)
{
    constexpr int kLastOfPaper = 12;
    bool isNumber = false;
    const int n = number.mid(1, number.size() - 2).toInt(&isNumber);
    if (!isNumber)
        return QStringLiteral("closed");
    if (n <= kLastOfPaper)
        return QStringLiteral("w%1").arg(n);
    switch (n) {
    case 13: return QStringLiteral("z-perspective");
    case 14: return QStringLiteral("z-ortho");
    case 15: return QStringLiteral("shear");
    default: return QStringLiteral("eye-to-world");
    }
}

QString helpAnchorOf(geometry::ProjectionKind kind)
{
    switch (kind) {
    case geometry::ProjectionKind::Frustum: return QStringLiteral("frustum");
    case geometry::ProjectionKind::Perspective: return QStringLiteral("perspective");
    case geometry::ProjectionKind::Ortho: return QStringLiteral("ortho");
    case geometry::ProjectionKind::Oblique: return QStringLiteral("oblique");
    }
    Q_UNREACHABLE();
}

QString helpAnchorOfSteps(geometry::ProjectionKind kind)
{
    switch (kind) {
    case geometry::ProjectionKind::Frustum:
    case geometry::ProjectionKind::Perspective: return QStringLiteral("frustum-steps");
    case geometry::ProjectionKind::Ortho: return QStringLiteral("ortho-steps");
    case geometry::ProjectionKind::Oblique: return QStringLiteral("oblique");
    }
    Q_UNREACHABLE();
}

QString helpAddress(const QString &anchor)
{
    return QStringLiteral("formulas:") + anchor;
}

QString manualPlaceOf(lessons::Panel panel)
{
    using lessons::Panel;
    switch (panel) {
    case Panel::Comparison: return QStringLiteral("picking.md#the-comparison-panel-top-to-bottom");
    case Panel::Pipeline: return QStringLiteral("pipeline.md#the-pipeline-panel");
    case Panel::Parameters: return QStringLiteral("pipeline.md#parameters");
    case Panel::Inspector: return QStringLiteral("pipeline.md#viewport");
    case Panel::Lifecycle: return QStringLiteral("pipeline.md#life-of-the-view");
    case Panel::Precision: return QStringLiteral("maps.md#depth-precision");
    case Panel::Objects: return QStringLiteral("first-steps.md#the-objects-panel");
    case Panel::Landmarks: return QStringLiteral("landmarks.md#the-landmarks-panel");
    case Panel::Series: return QStringLiteral("series.md");
    case Panel::Doctor: return QStringLiteral("doctor.md#ask-the-doctor");
    case Panel::Observer: return QStringLiteral("maps.md#view-from-outside");
    case Panel::Lesson: return QStringLiteral("lessons.md");
    }
    Q_UNREACHABLE();
}

QString manualAddress(const QString &place)
{
    return QStringLiteral("manual:") + place;
}

} // namespace unprojector::gui
