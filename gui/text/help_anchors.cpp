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

} // namespace unprojector::gui
