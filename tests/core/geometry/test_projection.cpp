// Properties that a projection keeps when its window or its clip distances change.

#include "tests/support/test.h"

#include "core/geometry/projection.h"

#include <algorithm>
#include <numbers>

using namespace unprojector;
using namespace unprojector::geometry;

namespace {

/// A few roundings of numbers of order 1 to 10.
constexpr double kRounding = 1e-14;

const double kRightAngle = std::numbers::pi / 2.0;

bool isNear(double a, double b)
{
    if (std::abs(a - b) <= kRounding * std::max({1.0, std::abs(a), std::abs(b)}))
        return true;
    qWarning("%.17g is not %.17g", a, b);
    return false;
}

glm::dvec3 ndcFromEye(const Projection &projection, const glm::dvec3 &eye)
{
    const glm::dvec4 clip = clipFromEye(projection).value() * glm::dvec4(eye, 1.0);
    return glm::dvec3(clip) / clip.w;
}

void addProjections()
{
    addColumn<Projection>("projection");
    newRow("frustum") << Projection(Frustum{-1, 1, -1, 1, 1, 10});
    newRow("off-centre frustum") << Projection(Frustum{-1, 3, -2, 1, 1, 10});
    newRow("mirrored frustum") << Projection(Frustum{3, -1, 1, -2, 1, 10});
    newRow("skewed frustum") << Projection(Frustum{-1, 3, -2, 1, 1, 10, 0.25});
    newRow("ortho") << Projection(Ortho{-4, 4, -3, 3, 1, 10});
    newRow("off-centre ortho") << Projection(Ortho{-1, 5, 2, 4, 1, 10});
    newRow("mirrored ortho") << Projection(Ortho{5, -1, 4, 2, 1, 10});
    newRow("perspective") << Projection(Perspective{1, 1.5, 1, 10});
    newRow("oblique") << Projection(Oblique{{-4, 4, -3, 3, 1, 10}, 1, 2});
}

} // namespace

class TestProjection : public QObject {
    Q_OBJECT

private slots:
    void cornersOfTheViewVolumeAreTheCornersOfNdc_data()
    {
        addColumn<Projection>("projection");
        addColumn<glm::dvec3>("nearBottomLeft");
        addColumn<glm::dvec3>("farTopRight");

        const auto row = [](const char *name, const Projection &projection, const glm::dvec3 &nearBottomLeft,
                            const glm::dvec3 &farTopRight) {
            newRow(name) << projection << nearBottomLeft << farTopRight;
        };
        row("frustum", Frustum{-1, 3, -2, 1, 2, 10}, {-1, -2, -2}, {15, 5, -10});
        row("mirrored frustum", Frustum{3, -1, 1, -2, 2, 10}, {3, 1, -2}, {-5, -10, -10});
        // x + y / 4 reaches the edges.
        row("skewed frustum", Frustum{-1, 3, -2, 1, 2, 10, 0.25}, {-0.5, -2, -2}, {13.75, 5, -10});
        // (X, Y, Z) of the corner (0, 360) is (-4.5, 2, 2), of the corner (640, 0) (49, -20, 10).
        row("pinhole", Pinhole{100, 120, 200, 240, 25, 640, 360, 2, 10}, {-4.5, -2, -2}, {49, 20, -10});
        // The same camera, with the first pixel's centre at 0.
        row("pinhole, centres whole", Pinhole{100, 120, 199.5, 239.5, 25, 640, 360, 2, 10, true}, {-4.5, -2, -2},
            {49, 20, -10});
        row("ortho", Ortho{-1, 3, -2, 1, 2, 10}, {-1, -2, -2}, {3, 1, -10});
        row("ortho around the eye", Ortho{-1, 3, -2, 1, -5, 5}, {-1, -2, 5}, {3, 1, -5});
        row("perspective of 90 degrees", Perspective{kRightAngle, 2, 2, 10}, {-4, -2, -2}, {20, 10, -10});
        // cot(pi/4) = 1: x_box = x + z_eye.
        row("oblique", Oblique{{-1, 3, -2, 1, 2, 10}, kRightAngle / 2.0, kRightAngle}, {1, -2, -2}, {13, 1, -10});
    }

    void cornersOfTheViewVolumeAreTheCornersOfNdc()
    {
        QFETCH(Projection, projection);
        QFETCH(glm::dvec3, nearBottomLeft);
        QFETCH(glm::dvec3, farTopRight);
        for (int k = 0; k < 3; ++k) {
            QVERIFY(isNear(ndcFromEye(projection, nearBottomLeft)[k], -1.0));
            QVERIFY(isNear(ndcFromEye(projection, farTopRight)[k], 1.0));
        }
    }

    void aPerspectiveIsItsFrustum()
    {
        const Frustum frustum = frustumFromPerspective({kRightAngle, 2, 3, 30});
        QVERIFY(isNear(frustum.left, -6) && isNear(frustum.right, 6));
        QVERIFY(isNear(frustum.bottom, -3) && isNear(frustum.top, 3));
        QCOMPARE(frustum.nearDistance, 3.0);
        QCOMPARE(frustum.farDistance, 30.0);
        QVERIFY(isPerspective(Perspective{}) && isPerspective(Frustum{}) && isPerspective(Pinhole{}));
        QVERIFY(!isPerspective(Ortho{}) && !isPerspective(Oblique{}));
        const ProjectionWindow window = projectionWindow(Perspective{kRightAngle, 2, 3, 30});
        QVERIFY(isNear(window.right, 6) && isNear(window.top, 3));
    }

    void otherClipDistancesGiveTheSamePicture_data() { addProjections(); }

    void otherClipDistancesGiveTheSamePicture()
    {
        QFETCH(Projection, projection);
        for (const auto &[n, f] : {std::pair(0.5, 20.0), std::pair(2.0, 7.0), std::pair(0.01, 1e4)}) {
            const Projection other = withClipDistances(projection, n, f);
            QCOMPARE(other.index(), projection.index());
            QVERIFY(check(other));
            QCOMPARE(projectionWindow(other).nearDistance, n);
            QCOMPARE(projectionWindow(other).farDistance, f);
            for (const glm::dvec3 &eye : {glm::dvec3(0.5, -0.25, -3), glm::dvec3(-2, 1, -5), glm::dvec3(3, 3, -1)}) {
                QVERIFY(isNear(ndcFromEye(other, eye).x, ndcFromEye(projection, eye).x));
                QVERIFY(isNear(ndcFromEye(other, eye).y, ndcFromEye(projection, eye).y));
            }
            QVERIFY(isNear(ndcFromEye(other, {0, 0, -n}).z, -1.0));
            QVERIFY(isNear(ndcFromEye(other, {0, 0, -f}).z, 1.0));
        }
    }

    void anotherAspectKeepsCirclesRoundAndTheHeight_data() { addProjections(); }

    void anotherAspectKeepsCirclesRoundAndTheHeight()
    {
        QFETCH(Projection, projection);
        for (const double aspect : {0.5, 1.0, 1.7777777777777777, 3.0}) {
            const Projection other = withAspect(projection, aspect);
            QCOMPARE(other.index(), projection.index());
            const ProjectionWindow before = projectionWindow(projection), after = projectionWindow(other);
            QCOMPARE(after.bottom, before.bottom);
            QCOMPARE(after.top, before.top);
            QCOMPARE(after.nearDistance, before.nearDistance);
            QCOMPARE(after.farDistance, before.farDistance);
            // A viewport of that aspect has as many pixels across as down for a unit of the window.
            QVERIFY(isNear(std::abs(after.right - after.left), aspect * std::abs(after.top - after.bottom)));
            QCOMPARE(after.left < after.right, before.left < before.right);
            if (isPerspective(projection)) {
                // The view axis keeps its share of the width.
                QVERIFY(isNear(after.left / (after.right - after.left), before.left / (before.right - before.left)));
            } else {
                QVERIFY(isNear(after.left + after.right, before.left + before.right));
            }
        }
    }

    void itsOwnAspectChangesNothing()
    {
        QVERIFY(std::get<Frustum>(withAspect(Frustum{-1, 3, -2, 2, 1, 10}, 1.0)) == (Frustum{-1, 3, -2, 2, 1, 10}));
        QVERIFY(std::get<Ortho>(withAspect(Ortho{3, -1, -2, 2, 1, 10}, 1.0)) == (Ortho{3, -1, -2, 2, 1, 10}));
        QVERIFY(std::get<Perspective>(withAspect(Perspective{1, 2, 1, 10}, 2.0)) == (Perspective{1, 2, 1, 10}));
    }

    void anObliqueBoxWithoutShearIsAnOrtho()
    {
        const Ortho box{-1, 3, -2, 1, 2, 10};
        QVERIFY(clipFromEye(Oblique{box, kRightAngle, kRightAngle}).value() == clipFromEye(box).value());
    }
};

UNPROJECTOR_TEST(TestProjection)
#include "test_projection.moc"
