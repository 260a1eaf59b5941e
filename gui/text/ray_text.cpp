#include "gui/text/ray_text.h"

#include "core/ray/snap.h"
#include "gui/text/number_text.h"
#include "gui/text/sentences.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
using namespace geometry;
using namespace ray;

namespace {

struct RayTexts {
    Q_DECLARE_TR_FUNCTIONS(RayTexts)
};

using Kind = RayComparison::Kind;

constexpr qsizetype kMostOfName = 14;

/// A name shortened so that the sentence fits.
QString shortName(const QString &name)
{
    return name.size() <= kMostOfName ? name : name.left(kMostOfName - 1) + u'…';
}

/// Less than a thousandth of a step is irrelevant.
QString stepsText(double steps)
{
    const double size = std::abs(steps);
    return size < 0.001 ? QStringLiteral("0") : significantText(size, 2);
}

QString numbered(std::uint32_t number)
{
    return QString::number(number);
}

/// The plane of a face: "0.6 x − 0.8 y + 0 z = 1.5".
QString planeText(const SceneHit &hit)
{
    constexpr int kDigits = 7;
    const WorldVector &n = hit.triangle->normal;
    const auto term = [](double factor, const char *axis) {
        return QStringLiteral(" %1 %2 %3")
            .arg(factor < 0.0 ? QStringLiteral("−") : QStringLiteral("+"), writtenText(std::abs(factor), kDigits),
                 QLatin1String(axis));
    };
    QString left = term(n.x, "x") + term(n.y, "y") + term(n.z, "z");
    left = n.x < 0.0 ? QStringLiteral("−") + left.mid(3) : left.mid(3);
    const double right = dot(n, hit.world - WorldPoint(0.0, 0.0, 0.0));
    return left + QStringLiteral(" = ") + writtenText(right, kDigits).replace(u'-', u'−');
}

QString surfaceText(const SceneHit &hit)
{
    const TriangleDetail &triangle = *hit.triangle;
    return RayTexts::tr("Triangle %1, barycentric (%2, %3, %4); vertex %5 is %6 away, edge %7–%8 %9 away.")
        .arg(numbered(triangle.triangle), significantText(triangle.barycentric.x, 4),
             significantText(triangle.barycentric.y, 4), significantText(triangle.barycentric.z, 4),
             numbered(hit.vertex.id), readableText(hit.vertex.distance), numbered(triangle.edge.ids[0]),
             numbered(triangle.edge.ids[1]), readableText(triangle.edge.distance));
}

} // namespace

QString rayComparisonText(const RayComparison &comparison, const QString &shown, const QString &met)
{
    const QString distance = readableText(comparison.distance), steps = stepsText(comparison.depthSteps);
    const QString frame = shortName(shown), ray = shortName(met);
    const bool isBehind = comparison.depthSteps >= 0.0;
    switch (comparison.kind) {
    case Kind::SameSurface:
        return RayTexts::tr(
                   "Exact hit: %1 from the formula, in depth steps %2. Trust the exact hit: it does not use the depth "
                   "buffer.")
            .arg(distance, steps);
    case Kind::OtherPart:
        return isBehind
                   ? RayTexts::tr("Exact hit: %1 behind the formula: an edge passes the pixel's centre, and the GPU "
                                  "draws edges to 1/256 pixel. Trust the exact hit.")
                         .arg(distance)
                   : RayTexts::tr("Exact hit: %1 before the formula: an edge passes the pixel's centre, and the GPU "
                                  "draws edges to 1/256 pixel. Trust the exact hit.")
                         .arg(distance);
    case Kind::OtherObject:
        return isBehind
                   ? RayTexts::tr("The ray meets %1, %2 behind %3: an edge passes the pixel's centre, and the GPU "
                                  "draws edges to 1/256 pixel. Trust the exact hit.")
                         .arg(ray, distance, frame)
                   : RayTexts::tr("The ray meets %1, %2 before %3: an edge, or a sliver that the GPU leaves out. Trust "
                                  "the exact hit.")
                         .arg(ray, distance, frame);
    case Kind::SameDepth:
        return RayTexts::tr("Two surfaces at one depth, %1 apart: %2 is drawn, the ray meets %3. Neither method shows "
                            "which is in front; trust the exact hit's coordinates.")
            .arg(distance, frame, ray);
    case Kind::OnlyFrame:
        return RayTexts::tr(
                   "The ray meets nothing, %1 is drawn: its outline passes the pixel's centre, and the GPU draws "
                   "edges to 1/256 pixel. Trust the formula.")
            .arg(frame);
    case Kind::OnlyRay:
        return RayTexts::tr(
                   "The ray meets %1, nothing is drawn: an outline passes the pixel's centre, or a sliver that "
                   "the GPU leaves out. Trust the exact hit.")
            .arg(ray);
    case Kind::TooFar:
        return RayTexts::tr("The ray meets %1, nothing is drawn: the depth buffer rounds its depth to that of the far "
                            "plane. Trust the exact hit, or move near and far closer together.")
            .arg(ray);
    case Kind::Nothing: return RayTexts::tr("The ray meets no mesh either.");
    case Kind::CloudPoint:
        return comparison.distance > 0.0
                   ? RayTexts::tr("The ray takes the nearest point, %1 from the formula, which has the pixel's centre. "
                                  "Trust the point: it is the file's.")
                         .arg(distance)
                   : RayTexts::tr("The ray takes the nearest point, within 8 pixels.");
    }
    Q_UNREACHABLE();
}

QString pixelEdgeText(const PixelEdge &edge, const QString &other, bool hasHit)
{
    if (!hasHit)
        return RayTexts::tr("This pixel holds an edge of %1. The click is beside it.").arg(other);
    const QString centre = QStringLiteral(" ") + RayTexts::tr("The ± is for the pixel's centre only.");
    if (!edge.object)
        return RayTexts::tr("This pixel holds an edge of the surface: beside it is the background.") + centre;
    const QString away = significantText(std::abs(edge.behind), 2);
    return (edge.behind >= 0.0 ? RayTexts::tr("This pixel holds an edge of the surface: %1 behind it lies %2.")
                               : RayTexts::tr("This pixel holds an edge of the surface: %1 before it lies %2."))
               .arg(away, other)
           + centre;
}

QString rayPreparingText()
{
    return RayTexts::tr("The exact hit comes as soon as the model is prepared for it.");
}

QString rayImpossibleText(const QString &reason)
{
    return reason.isEmpty() ? RayTexts::tr("This setup has no ray.")
                            : RayTexts::tr("There is no exact hit: %1.").arg(reason);
}

QString rayDetailText(Snap snap, const std::optional<SceneHit> &hit)
{
    if (hit && !hit->triangle)
        return RayTexts::tr("Point %1 of the cloud.").arg(numbered(hit->vertex.id));
    switch (snap) {
    case Snap::Surface: return hit ? surfaceText(*hit) : QString();
    case Snap::Vertex:
        return hit ? RayTexts::tr("Snapped to vertex %1 of triangle %2.")
                         .arg(numbered(hit->vertex.id), numbered(hit->triangle->triangle))
                   : sentence(ray::nothingText(snap));
    case Snap::Edge:
        return hit ? RayTexts::tr("Snapped to the nearest point of edge %1 to %2 of triangle %3.")
                         .arg(numbered(hit->triangle->edge.ids[0]), numbered(hit->triangle->edge.ids[1]),
                              numbered(hit->triangle->triangle))
                   : sentence(ray::nothingText(snap));
    case Snap::Face:
        return hit ? RayTexts::tr("Snapped to face %1 in the plane %2.")
                         .arg(numbered(hit->triangle->triangle), planeText(*hit))
                   : sentence(ray::nothingText(snap));
    }
    Q_UNREACHABLE();
}

QString takenText(Snap snap, const SceneHit &taken, const QString &object)
{
    if (snap == Snap::Vertex || !taken.triangle)
        return taken.triangle ? RayTexts::tr("Vertex %1 of %2").arg(numbered(taken.vertex.id), object)
                              : RayTexts::tr("Point %1 of %2").arg(numbered(taken.vertex.id), object);
    if (snap == Snap::Edge)
        return RayTexts::tr("A point of edge %1–%2 of %3")
            .arg(numbered(taken.triangle->edge.ids[0]), numbered(taken.triangle->edge.ids[1]), object);
    return RayTexts::tr("A point of face %1 of %2").arg(numbered(taken.triangle->triangle), object);
}

QString takenCertaintyText(Snap snap, const SceneHit &taken)
{
    const WorldVector &u = taken.uncertainty;
    const QString most = boundText(std::max({u.x, u.y, u.z}));
    if (snap == Snap::Vertex || !taken.triangle)
        return RayTexts::
            tr("The vertex is accurate to ± %1: its coordinate comes from the file. The table shows the clicked pixel.")
                .arg(most);
    if (snap == Snap::Edge)
        return RayTexts::tr("The point on the edge is accurate to ± %1: it does not use the depth buffer. The table "
                            "shows the clicked pixel.")
            .arg(most);
    return RayTexts::tr("The point on the face is accurate to ± %1: it does not use the depth buffer. The table shows "
                        "the clicked pixel.")
        .arg(most);
}

} // namespace unprojector::gui
