// The NDC half of the viewport: window coordinates from NDC and back, and the depth between them.
// Literal numbers, written out by hand.

#include "tests/support/test.h"

#include "tests/core/geometry/viewport_checks.h"

using namespace unprojector;
using namespace unprojector::geometry;
using namespace viewport_checks;

class TestViewportNdc : public QObject {
    Q_OBJECT

private slots:
    void ndcCornersAreTheViewportsCorners_data()
    {
        addColumn<Viewport>("viewport");
        addColumn<DepthRange>("range");
        addColumn<glm::dvec3>("ndc");
        addColumn<glm::dvec3>("window");

        const auto row = [](const char *name, const Viewport &viewport, const DepthRange &range, const glm::dvec3 &ndc,
                            const glm::dvec3 &window) { newRow(name) << viewport << range << ndc << window; };
        const Viewport square{0, 0, 50, 50}, offset{100, -20, 640, 480};
        row("near bottom left", square, {}, {-1, -1, -1}, {0, 0, 0});
        row("far top right", square, {}, {1, 1, 1}, {50, 50, 1});
        row("middle, depth one half", square, {}, {0, 0, 0.5}, {25, 25, 0.75});
        row("offset: near bottom left", offset, {}, {-1, -1, -1}, {100, -20, 0});
        row("offset: far top right", offset, {}, {1, 1, 1}, {740, 460, 1});
        row("offset: middle", offset, {}, {0, 0, 0}, {420, 220, 0.5});
        row("offset: outside", offset, {}, {2, -3, 3}, {1060, -500, 2});
        row("reversed depth: near", offset, {1, 0}, {0, 0, -1}, {420, 220, 1});
        row("reversed depth: far", offset, {1, 0}, {0, 0, 1}, {420, 220, 0});
        row("reversed depth: three quarters", offset, {1, 0}, {0, 0, 0.5}, {420, 220, 0.25});
        row("partial depth: near", offset, {0.25, 0.75}, {0, 0, -1}, {420, 220, 0.25});
        row("partial depth: far", offset, {0.25, 0.75}, {0, 0, 1}, {420, 220, 0.75});
        row("partial depth: middle", offset, {0.25, 0.75}, {0, 0, 0}, {420, 220, 0.5});
    }

    void ndcCornersAreTheViewportsCorners()
    {
        QFETCH(Viewport, viewport);
        QFETCH(DepthRange, range);
        QFETCH(glm::dvec3, ndc);
        QFETCH(glm::dvec3, window);
        QVERIFY(windowFromNdc(viewport, range, NdcPoint(ndc)).coordinates() == window);
        QVERIFY(ndcFromWindow(viewport, range, WindowPoint(window)).coordinates() == ndc);
        QVERIFY(windowFromNdc(viewport, range) * glm::dvec4(ndc, 1) == glm::dvec4(window, 1));
    }

    void ndcAndWindowAreInverse()
    {
        const Viewport viewport{13, -7, 641, 479};
        for (const DepthRange &range : {DepthRange{}, DepthRange{1, 0}, DepthRange{0.2, 0.7}}) {
            for (int step = -150; step <= 150; ++step) {
                const double t = step / 100.0;
                const NdcPoint ndc(t, -t / 2.0, t / 1.5);
                const NdcPoint back = ndcFromWindow(viewport, range, windowFromNdc(viewport, range, ndc));
                for (int k = 0; k < 3; ++k)
                    QVERIFY(isNear(back[k], ndc[k], kRoundingNdc));
            }
        }
    }

    void theMatrixDoesWhatTheFunctionDoes()
    {
        const Viewport viewport{13, -7, 641, 479};
        for (const DepthRange &range : {DepthRange{}, DepthRange{1, 0}, DepthRange{0.2, 0.7}}) {
            const glm::dmat4 matrix = windowFromNdc(viewport, range);
            for (int step = -150; step <= 150; ++step) {
                const double t = step / 100.0;
                const NdcPoint ndc(t, -t / 2.0, t / 1.5);
                const WindowPoint window = windowFromNdc(viewport, range, ndc);
                const glm::dvec4 product = matrix * glm::dvec4(ndc.coordinates(), 1.0);
                for (int k = 0; k < 3; ++k)
                    QVERIFY(isNear(product[k], window[k], k < 2 ? kRoundingPixels : kRoundingNdc));
                QCOMPARE(product.w, 1.0);
            }
        }
    }

    void depthIsMappedBackToUnitDepth_data()
    {
        addColumn<DepthRange>("range");
        addColumn<double>("depth");
        addColumn<double>("unit");

        const auto row = [](const char *name, const DepthRange &range, double depth, double unit) {
            newRow(name) << range << depth << unit;
        };
        row("near end", {}, 0, 0);
        row("far end", {}, 1, 1);
        row("inside", {}, 0.3, 0.3);
        row("smallest step above the near end", {}, 5e-324, 5e-324);
        row("smallest step below the far end", {}, 1 - 0x1p-53, 1 - 0x1p-53);
        row("reversed: near end", {1, 0}, 1, 0);
        row("reversed: far end", {1, 0}, 0, 1);
        row("reversed: inside", {1, 0}, 0.25, 0.75);
        row("partial: near end", {0.25, 0.75}, 0.25, 0);
        row("partial: far end", {0.25, 0.75}, 0.75, 1);
        row("partial: inside", {0.25, 0.75}, 0.375, 0.25);
        row("partial, reversed: inside", {0.75, 0.25}, 0.375, 0.75);
    }

    void depthIsMappedBackToUnitDepth()
    {
        QFETCH(DepthRange, range);
        QFETCH(double, depth);
        QFETCH(double, unit);
        const Result<double> result = unitDepth(range, depth);
        QVERIFY(result);
        QVERIFY(*result == unit);
    }

    void depthOutsideTheRangeIsRefused_data()
    {
        addColumn<DepthRange>("range");
        addColumn<double>("depth");
        addColumn<ErrorCode>("code");
        addColumn<double>("value");

        const auto row = [](const char *name, const DepthRange &range, double depth, ErrorCode code, double value) {
            newRow(name) << range << depth << code << value;
        };
        using enum ErrorCode;
        row("NaN", {}, kNan, DepthOutsideRange, kNan);
        row("-0.1", {}, -0.1, DepthOutsideRange, -0.1);
        row("1.1", {}, 1.1, DepthOutsideRange, 1.1);
        row("infinite", {}, kInfinity, DepthOutsideRange, kInfinity);
        row("minus infinite", {}, -kInfinity, DepthOutsideRange, -kInfinity);
        row("smallest step below the near end", {}, -5e-324, DepthOutsideRange, -5e-324);
        row("smallest step above the far end", {}, 1 + 0x1p-52, DepthOutsideRange, 1 + 0x1p-52);
        row("reversed: 1.1", {1, 0}, 1.1, DepthOutsideRange, 1.1);
        row("partial: below", {0.25, 0.75}, 0.2, DepthOutsideRange, 0.2);
        row("partial: above", {0.25, 0.75}, 0.8, DepthOutsideRange, 0.8);
        row("partial, reversed: above", {0.75, 0.25}, 0.8, DepthOutsideRange, 0.8);
        row("equal ends", {0.5, 0.5}, 0.5, EmptyDepthRange, 0.5);
        row("NaN end", {kNan, 1}, 0.5, NotFinite, kNan);
        row("infinite end", {0, kInfinity}, 0.5, NotFinite, kInfinity);
    }

    void depthOutsideTheRangeIsRefused()
    {
        QFETCH(DepthRange, range);
        QFETCH(double, depth);
        QFETCH(ErrorCode, code);
        QFETCH(double, value);
        const Result<double> unit = unitDepth(range, depth);
        QVERIFY(!unit);
        QCOMPARE(errorOf(unit).code, code);
        QVERIFY(isSame(errorOf(unit).value, value));
    }
};

UNPROJECTOR_TEST(TestViewportNdc)
#include "test_viewport_ndc.moc"
