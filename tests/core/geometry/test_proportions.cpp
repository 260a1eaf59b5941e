// The shape of a circle and the proportions (3) and (4) as literal numbers, worked out by hand.

#include "tests/support/test.h"

#include "core/geometry/proportions.h"

using namespace unprojector;
using namespace unprojector::geometry;

namespace {

constexpr double kRounding = 1e-14;
constexpr double kQuarterTurn = 1.5707963267948966;

} // namespace

class TestProportions : public QObject {
    Q_OBJECT

private slots:
    void aCircleIsDrawnSoMuchWiderThanHigh_data()
    {
        addColumn<Viewport>("viewport");
        addColumn<Projection>("projection");
        addColumn<double>("aspect");
        const auto row = [](const char *name, const Viewport &viewport, const Projection &projection, double aspect) {
            newRow(name) << viewport << projection << aspect;
        };
        const Viewport wide{0, 0, 800, 600}, square{0, 0, 300, 300};
        // projection-derivation's glFrustum(-1, 1, -1, 1, ...) and its gluPerspective(90, w / h, ...).
        row("square frustum at 800x600", wide, Frustum{-1, 1, -1, 1, 1, 100}, 4.0 / 3.0);
        row("square frustum in a square window", square, Frustum{-1, 1, -1, 1, 1, 100}, 1.0);
        row("perspective that follows the aspect", wide, Perspective{kQuarterTurn, 4.0 / 3.0, 5, 80000}, 1.0);
        row("perspective that does not", wide, Perspective{kQuarterTurn, 1.0, 5, 80000}, 4.0 / 3.0);
        row("perspective wider than the window", square, Perspective{kQuarterTurn, 2.0, 1, 10}, 0.5);
        row("square box at 600x800", {0, 0, 600, 800}, Ortho{-10, 10, -10, 10, -10, 10}, 0.75);
        row("mirrored box", wide, Ortho{1, -1, 1, -1, 1, 100}, 4.0 / 3.0);
        row("off-centre box of the viewport's shape", wide, Ortho{2, 10, -3, 3, 1, 100}, 1.0);
        row("oblique goes by its box", square, Oblique{Ortho{-10, 10, -5, 5, 2, 9}, 0.78, 0.78}, 0.5);
        row("viewport beside the corner", {400, 0, 400, 300}, Frustum{-2, 2, -1, 1, 1, 100}, 2.0 / 3.0);
    }

    void aCircleIsDrawnSoMuchWiderThanHigh()
    {
        QFETCH(Viewport, viewport);
        QFETCH(Projection, projection);
        QFETCH(double, aspect);
        const Setup setup{{800, 600, 1.0}, viewport, {}, projection, {}};
        QVERIFY2(std::abs(circleAspect(setup) - aspect) < kRounding,
                 qPrintable(QString::number(circleAspect(setup), 'g', 17)));
    }

    void aWindowPositionHasItsPlaceInTheProjectionWindow_data()
    {
        addColumn<Viewport>("viewport");
        addColumn<glm::dvec2>("window");
        addColumn<glm::dvec2>("share");
        addColumn<glm::dvec2>("position");
        const auto row = [](const char *name, const Viewport &viewport, double x, double y, double shareX,
                            double shareY, double xw, double yw) {
            newRow(name) << viewport << glm::dvec2(x, y) << glm::dvec2(shareX, shareY) << glm::dvec2(xw, yw);
        };
        // The projection window is [-4, 12] x [-3, 1].
        const Viewport whole{0, 0, 800, 600}, quarter{400, 0, 400, 300};
        row("bottom left corner", whole, 0, 0, 0, 0, -4, -3);
        row("top right corner", whole, 800, 600, 1, 1, 12, 1);
        row("middle", whole, 400, 300, 0.5, 0.5, 4, -1);
        row("quarter of the way", whole, 200, 450, 0.25, 0.75, 0, 0);
        row("quarter viewport's corner", quarter, 400, 0, 0, 0, -4, -3);
        row("quarter viewport's middle", quarter, 600, 150, 0.5, 0.5, 4, -1);
        row("viewport away from both edges", {100, 150, 400, 200}, 200, 300, 0.25, 0.75, 0, 0);
        row("left of and above the quarter viewport", quarter, 0, 600, -1, 2, -20, 5);
    }

    void aWindowPositionHasItsPlaceInTheProjectionWindow()
    {
        QFETCH(Viewport, viewport);
        QFETCH(glm::dvec2, window);
        QFETCH(glm::dvec2, share);
        QFETCH(glm::dvec2, position);
        const Setup setup{{800, 600, 1.0}, viewport, {}, Ortho{-4, 12, -3, 1, 1, 100}, {}};
        const Proportions p = proportions(setup, WindowPoint(window.x, window.y, 0.5));
        QCOMPARE(p.share.x, share.x);
        QCOMPARE(p.share.y, share.y);
        QCOMPARE(p.position.x, position.x);
        QCOMPARE(p.position.y, position.y);
    }
};

UNPROJECTOR_TEST(TestProportions)
#include "test_proportions.moc"
