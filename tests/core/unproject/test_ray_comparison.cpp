// The hit of a click's ray against the point of the frame: the case, and the distance between the
// two.

#include "tests/support/test.h"

#include "core/ray/ray_comparison.h"
#include "tests/support/unprojecting.h"

#include <cmath>
#include <optional>

using namespace unprojector;
using namespace unprojector::ray;
using namespace unprojector::geometry;
using namespace unprojector::unproject;

Q_DECLARE_METATYPE(RayComparison::Kind)

namespace {

using Kind = RayComparison::Kind;

const Setup kPicture{{800, 600, 1.0},
                     {0.0, 0.0, 800.0, 600.0},
                     {},
                     Frustum{-0.8, 0.8, -0.6, 0.6, 2.0, 10.0},
                     LookAt{WorldPoint(0.0, 0.0, 5.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}}};

/// z = 20 / (2.5 + 1.5) = 5: on the plane z = 0. A step there is 25 * 8 / 20 / (2^24 - 1).
constexpr double kStep = 10.0 / 16777215.0;

/// @param degrees  by which the triangle that was drawn is inclined to the picture
Pick picked(bool hit, double degrees = 0.0)
{
    const double slope = std::tan(degrees * 3.14159265358979 / 180.0);
    DrawnSurface surface;
    surface.triangle = {{{-8.0, -8.0, -8.0 * slope}, {8.0, -8.0, -8.0 * slope}, {0.0, 8.0, 8.0 * slope}}};
    const DepthSample sample{hit ? 0.75 : 1.0, hit ? std::optional<std::size_t>(0) : std::nullopt, 24};
    return refined(*pickAt(kPicture, WidgetPoint(412.0, 299.0), sample), surface);
}

/// A hit on the pick's ray, farther along it than the formula's point by this distance.
SceneHit hitAt(const Pick &pick, double farther)
{
    const WorldPoint eye(0.0, 0.0, 5.0);
    const WorldVector way = *pick.point.world[Method::Formula] - eye;
    SceneHit hit;
    hit.world = eye + (1.0 + farther / length(way)) * way;
    hit.triangle = TriangleDetail();
    return hit;
}

} // namespace

class TestRayComparison : public QObject {
    Q_OBJECT

private slots:
    void eachCaseIsToldFromTheOthers_data()
    {
        addColumn<bool>("isDrawn");
        addColumn<std::optional<double>>("share");
        addColumn<double>("degrees");
        addColumn<bool>("isSameObject");
        addColumn<Kind>("kind");
        // A share of the uncertainty that the click states: so far behind, or before.
        using Share = std::optional<double>;
        const auto row = [](const char *name, bool isDrawn, Share share, double degrees, bool isSameObject, Kind kind) {
            newRow(name) << isDrawn << share << degrees << isSameObject << kind;
        };
        row("the very point", true, 0.0, 0.0, true, Kind::SameSurface);
        row("deeper, as far as is said", true, 0.99, 0.0, true, Kind::SameSurface);
        row("nearer, as far as is said", true, -0.99, 0.0, true, Kind::SameSurface);
        row("deeper than is said", true, 1.01, 0.0, true, Kind::OtherPart);
        row("nearer than is said", true, -1.01, 0.0, true, Kind::OtherPart);
        row("on a slope", true, 0.99, 85.0, true, Kind::SameSurface);
        row("farther on a slope", true, 1.01, 85.0, true, Kind::OtherPart);
        row("another object behind", true, 100.0, 0.0, false, Kind::OtherObject);
        row("another object before", true, -1e5, 0.0, false, Kind::OtherObject);
        row("another object at the same place", true, 0.5, 0.0, false, Kind::SameDepth);
        row("nothing met", true, {}, 0.0, false, Kind::OnlyFrame);
        row("nothing drawn", false, 0.0, 0.0, false, Kind::OnlyRay);
        row("nothing at all", false, {}, 0.0, true, Kind::Nothing);
    }

    void eachCaseIsToldFromTheOthers()
    {
        QFETCH(bool, isDrawn);
        QFETCH(std::optional<double>, share);
        QFETCH(double, degrees);
        QFETCH(bool, isSameObject);
        QFETCH(Kind, kind);
        const Pick pick = picked(isDrawn, degrees);
        const bool hasBoth = isDrawn && share;
        const double farther = hasBoth ? *share * length(pick.uncertainty.world) : 0.0;
        const std::optional<SceneHit> hit = share ? std::optional(hitAt(picked(true, degrees), farther)) : std::nullopt;
        const RayComparison comparison = compared(pick, hit, isSameObject);
        QCOMPARE(static_cast<int>(comparison.kind), static_cast<int>(kind));
        const double apart = hasBoth ? distance(hit->world, *pick.point.world[Method::Formula]) : 0.0;
        QCOMPARE(comparison.distance, apart);
        QVERIFY(std::abs(apart - std::abs(farther)) <= 1e-3 * std::abs(farther));
        const double deeper = hasBoth ? pick.point.world[Method::Formula]->z - hit->world.z : 0.0;
        QVERIFY2(std::abs(comparison.depthSteps * kStep - deeper) <= 1e-6 * std::abs(deeper) + 1e-6 * kStep,
                 qPrintable(QString::number(comparison.depthSteps)));
    }

    void theMeshIsSureOfItselfToSomeExtent()
    {
        const Pick pick = picked(true);
        const double stated = length(pick.uncertainty.world);
        SceneHit hit = hitAt(pick, 1.5 * stated);
        QVERIFY(compared(pick, hit, true).kind == Kind::OtherPart);
        hit.uncertainty = {0.0, 0.0, 0.6 * stated};
        QVERIFY(compared(pick, hit, true).kind == Kind::SameSurface);
    }

    /// Half a step of the depth buffer before the far plane is 1.2e-6 there.
    void whatTheDepthBufferTakesForTheFarPlane()
    {
        SceneHit hit;
        hit.triangle = TriangleDetail();
        hit.world = WorldPoint(0.0, 0.0, -5.0 + 1e-6);
        QCOMPARE(static_cast<int>(compared(picked(false), hit, false).kind), static_cast<int>(Kind::TooFar));
        hit.world = WorldPoint(0.0, 0.0, -5.0 + 1.5e-6);
        QCOMPARE(static_cast<int>(compared(picked(false), hit, false).kind), static_cast<int>(Kind::OnlyRay));
    }

    void aPointOfACloudIsNoSurface()
    {
        SceneHit hit = hitAt(picked(true), 0.01);
        hit.triangle.reset();
        for (const bool isDrawn : {true, false}) {
            const RayComparison comparison = compared(picked(isDrawn), hit, isDrawn);
            QVERIFY(comparison.kind == Kind::CloudPoint);
            QVERIFY((comparison.distance > 0.0) == isDrawn);
        }
    }
};

UNPROJECTOR_TEST(TestRayComparison)
#include "test_ray_comparison.moc"
