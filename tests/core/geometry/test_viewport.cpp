// The only code with a y flip, a pixel ratio or half a pixel. Both unprojections start from the
// same window point and would agree on an error here: so these rows are literal numbers, written
// out by hand.

#include "tests/support/test.h"

#include "tests/core/geometry/viewport_checks.h"

using namespace unprojector;
using namespace unprojector::geometry;
using namespace viewport_checks;

namespace {

bool isPixel(const Result<DevicePixel> &result, int i, int j)
{
    if (result && *result == DevicePixel{i, j})
        return true;
    if (result)
        qWarning("(%d, %d) is not (%d, %d)", result->i, result->j, i, j);
    else
        qWarning("no pixel instead of (%d, %d)", i, j);
    return false;
}

} // namespace

class TestViewport : public QObject {
    Q_OBJECT

private slots:
    /// A view that starts at logical 3 starts at device 4.5 with a pixel ratio of 1.5. Qt rounds that
    /// to 5: half a pixel less is left of it.
    void aViewsCornerIsOnAWholePixel()
    {
        const Surface surface{300, 150, 1.5};
        const WidgetPoint even = widgetOnSurface(surface, WidgetPoint(10, 20), WidgetPoint(2, 4));
        QCOMPARE(even.x, 10.0);
        QCOMPARE(even.y, 20.0);
        const WidgetPoint odd = widgetOnSurface(surface, WidgetPoint(10, 20), WidgetPoint(3, 5));
        QCOMPARE(odd.x * 1.5, 10 * 1.5 - 0.5);
        QCOMPARE(odd.y * 1.5, 20 * 1.5 - 0.5);
        const WidgetPoint rims = widgetOnSurface(surface, WidgetPoint(0, 100), WidgetPoint(3, 4));
        QCOMPARE(rims.x, 0.0);
        QCOMPARE(rims.y * 1.5, 149.5);
    }

    void logicalSizesComeBack()
    {
        for (const double ratio : {1.0, 1.25, 1.5, 1.75, 2.0}) {
            for (int logical = 1; logical < 400; ++logical) {
                const Surface surface = surfaceFromWidget(logical, logical, ratio);
                QCOMPARE(logicalFromDevice(surface, surface.widthPixels), logical);
            }
        }
    }

    void aClickGoesThroughPixelRowAndWindowToNdc_data()
    {
        addColumn<double>("ratio");
        addColumn<Viewport>("viewport");
        addColumn<WidgetPoint>("click");
        addColumn<int>("i");
        addColumn<int>("j");
        addColumn<int>("row");
        addColumn<glm::dvec2>("window");
        addColumn<glm::dvec2>("ndc");

        // A widget of 400 x 300 logical pixels; the clicks are on logical (0, 0), (399, 0), (0, 299),
        // (399, 299), (200, 150).
        const auto row = [](const char *name, double ratio, const Viewport &viewport, double x, double y, int i, int j,
                            int framebufferRow, double windowX, double windowY, double ndcX, double ndcY) {
            newRow(name) << ratio << viewport << WidgetPoint(x, y) << i << j << framebufferRow
                         << glm::dvec2(windowX, windowY) << glm::dvec2(ndcX, ndcY);
        };
        const Viewport at1{0, 0, 400, 300};
        row("top-left@1x", 1, at1, 0, 0, 0, 0, 299, 0.5, 299.5, -0.9975, 299 / 300.0);
        row("top-right@1x", 1, at1, 399, 0, 399, 0, 299, 399.5, 299.5, 0.9975, 299 / 300.0);
        row("bottom-left@1x", 1, at1, 0, 299, 0, 299, 0, 0.5, 0.5, -0.9975, -299 / 300.0);
        row("bottom-right@1x", 1, at1, 399, 299, 399, 299, 0, 399.5, 0.5, 0.9975, -299 / 300.0);
        row("centre@1x", 1, at1, 200, 150, 200, 150, 149, 200.5, 149.5, 0.0025, -1 / 300.0);

        // 500 x 375; 399 * 1.25 = 498.75 and 299 * 1.25 = 373.75: the last pixel (499, 374) has no
        // whole logical position.
        const Viewport at125{0, 0, 500, 375};
        row("top-left@1.25x", 1.25, at125, 0, 0, 0, 0, 374, 0.5, 374.5, -0.998, 374 / 375.0);
        row("top-right@1.25x", 1.25, at125, 399, 0, 498, 0, 374, 498.5, 374.5, 0.994, 374 / 375.0);
        row("bottom-left@1.25x", 1.25, at125, 0, 299, 0, 373, 1, 0.5, 1.5, -0.998, -372 / 375.0);
        row("bottom-right@1.25x", 1.25, at125, 399, 299, 498, 373, 1, 498.5, 1.5, 0.994, -372 / 375.0);
        row("last pixel@1.25x", 1.25, at125, 399.2, 299.2, 499, 374, 0, 499.5, 0.5, 0.998, -374 / 375.0);
        row("centre@1.25x", 1.25, at125, 200, 150, 250, 187, 187, 250.5, 187.5, 0.002, 0);

        // 600 x 450; 399 * 1.5 = 598.5, 299 * 1.5 = 448.5.
        const Viewport at15{0, 0, 600, 450};
        row("top-left@1.5x", 1.5, at15, 0, 0, 0, 0, 449, 0.5, 449.5, -599 / 600.0, 449 / 450.0);
        row("top-right@1.5x", 1.5, at15, 399, 0, 598, 0, 449, 598.5, 449.5, 597 / 600.0, 449 / 450.0);
        row("bottom-left@1.5x", 1.5, at15, 0, 299, 0, 448, 1, 0.5, 1.5, -599 / 600.0, -447 / 450.0);
        row("bottom-right@1.5x", 1.5, at15, 399, 299, 598, 448, 1, 598.5, 1.5, 597 / 600.0, -447 / 450.0);
        row("centre@1.5x", 1.5, at15, 200, 150, 300, 225, 224, 300.5, 224.5, 1 / 600.0, -1 / 450.0);

        // 700 x 525; 399 * 1.75 = 698.25, 299 * 1.75 = 523.25.
        const Viewport at175{0, 0, 700, 525};
        row("top-left@1.75x", 1.75, at175, 0, 0, 0, 0, 524, 0.5, 524.5, -699 / 700.0, 524 / 525.0);
        row("top-right@1.75x", 1.75, at175, 399, 0, 698, 0, 524, 698.5, 524.5, 697 / 700.0, 524 / 525.0);
        row("bottom-left@1.75x", 1.75, at175, 0, 299, 0, 523, 1, 0.5, 1.5, -699 / 700.0, -522 / 525.0);
        row("bottom-right@1.75x", 1.75, at175, 399, 299, 698, 523, 1, 698.5, 1.5, 697 / 700.0, -522 / 525.0);
        row("centre@1.75x", 1.75, at175, 200, 150, 350, 262, 262, 350.5, 262.5, 1 / 700.0, 0);

        const Viewport at2{0, 0, 800, 600};
        row("top-left@2x", 2, at2, 0, 0, 0, 0, 599, 0.5, 599.5, -799 / 800.0, 599 / 600.0);
        row("top-right@2x", 2, at2, 399, 0, 798, 0, 599, 798.5, 599.5, 797 / 800.0, 599 / 600.0);
        row("bottom-left@2x", 2, at2, 0, 299, 0, 598, 1, 0.5, 1.5, -799 / 800.0, -597 / 600.0);
        row("bottom-right@2x", 2, at2, 399, 299, 798, 598, 1, 798.5, 1.5, 797 / 800.0, -597 / 600.0);
        row("last pixel@2x", 2, at2, 399.5, 299.5, 799, 599, 0, 799.5, 0.5, 799 / 800.0, -599 / 600.0);
        row("centre@2x", 2, at2, 200, 150, 400, 300, 299, 400.5, 299.5, 1 / 800.0, -1 / 600.0);

        // glViewport(20, 10, 200, 100) in the same framebuffers: the window point stays, NDC moves.
        const Viewport offset{20, 10, 200, 100};
        row("top-left@1x, viewport offset", 1, offset, 0, 0, 0, 0, 299, 0.5, 299.5, -1.195, 4.79);
        row("top-right@1x, viewport offset", 1, offset, 399, 0, 399, 0, 299, 399.5, 299.5, 2.795, 4.79);
        row("bottom-left@1x, viewport offset", 1, offset, 0, 299, 0, 299, 0, 0.5, 0.5, -1.195, -1.19);
        row("bottom-right@1x, viewport offset", 1, offset, 399, 299, 399, 299, 0, 399.5, 0.5, 2.795, -1.19);
        row("viewport's top-left@1x", 1, offset, 20, 190, 20, 190, 109, 20.5, 109.5, -0.995, 0.99);
        row("viewport's bottom-right@1x", 1, offset, 219, 289, 219, 289, 10, 219.5, 10.5, 0.995, -0.99);
        row("viewport's centre@1x", 1, offset, 120, 240, 120, 240, 59, 120.5, 59.5, 0.005, -0.01);
        row("viewport's top-left@1.25x", 1.25, offset, 16, 212, 20, 265, 109, 20.5, 109.5, -0.995, 0.99);
        row("viewport's bottom-right@1.25x", 1.25, offset, 175.2, 291.2, 219, 364, 10, 219.5, 10.5, 0.995, -0.99);
        row("viewport's centre@1.5x", 1.5, offset, 80, 260, 120, 390, 59, 120.5, 59.5, 0.005, -0.01);
        row("viewport's top-left@1.75x", 1.75, offset, 80 / 7.0, 1660 / 7.0, 20, 415, 109, 20.5, 109.5, -0.995, 0.99);
        row("viewport's top-left@2x", 2, offset, 10, 245, 20, 490, 109, 20.5, 109.5, -0.995, 0.99);
        row("viewport's bottom-right@2x", 2, offset, 109.5, 294.5, 219, 589, 10, 219.5, 10.5, 0.995, -0.99);
    }

    void aClickGoesThroughPixelRowAndWindowToNdc()
    {
        QFETCH(double, ratio);
        QFETCH(Viewport, viewport);
        QFETCH(WidgetPoint, click);
        QFETCH(int, i);
        QFETCH(int, j);
        QFETCH(int, row);
        QFETCH(glm::dvec2, window);
        QFETCH(glm::dvec2, ndc);

        const Surface surface = surfaceFromWidget(400, 300, ratio);
        QVERIFY(isPixel(devicePixelFromWidget(surface, click), i, j));
        const DevicePixel pixel{i, j};
        QCOMPARE(framebufferRow(surface, pixel), row);

        const WindowPoint windowPoint = windowFromDevice(surface, pixelCenter(pixel), 0.25);
        QCOMPARE(windowPoint.x, window.x);
        QCOMPARE(windowPoint.y, window.y);
        QCOMPARE(windowPoint.z, 0.25);
        QCOMPARE(windowPoint.y, row + 0.5); // the depth that was read belongs to the point that is unprojected

        const NdcPoint ndcPoint = ndcFromWindow(viewport, DepthRange{}, windowPoint);
        QVERIFY(isNear(ndcPoint.x, ndc.x, kRoundingNdc));
        QVERIFY(isNear(ndcPoint.y, ndc.y, kRoundingNdc));
        QCOMPARE(ndcPoint.z, -0.5);
    }

    void theSurfaceOfAWidgetIsRoundedHalvesUp_data()
    {
        addColumn<int>("width");
        addColumn<int>("height");
        addColumn<double>("ratio");
        addColumn<int>("widthPixels");
        addColumn<int>("heightPixels");

        newRow("whole@1x") << 400 << 300 << 1.0 << 400 << 300;
        newRow("whole@1.25x") << 400 << 300 << 1.25 << 500 << 375;
        newRow("halves@1.5x") << 401 << 301 << 1.5 << 602 << 452;           // 601.5, 451.5
        newRow("quarters@1.25x") << 401 << 301 << 1.25 << 501 << 376;       // 501.25, 376.25
        newRow("three quarters@1.75x") << 401 << 301 << 1.75 << 702 << 527; // 701.75, 526.75
        newRow("whole@2x") << 401 << 301 << 2.0 << 802 << 602;
        newRow("empty") << 0 << 0 << 2.0 << 0 << 0;
    }

    void theSurfaceOfAWidgetIsRoundedHalvesUp()
    {
        QFETCH(int, width);
        QFETCH(int, height);
        QFETCH(double, ratio);
        QFETCH(int, widthPixels);
        QFETCH(int, heightPixels);
        QVERIFY((surfaceFromWidget(width, height, ratio) == Surface{widthPixels, heightPixels, ratio}));
    }

    void aPixelReachesFromItsEdgeToTheNext_data()
    {
        addColumn<double>("ratio");
        addColumn<double>("x");
        addColumn<int>("i");

        newRow("its left edge@1x") << 1.0 << 7.0 << 7;
        newRow("its centre@1x") << 1.0 << 7.5 << 7;
        newRow("just before the next@1x") << 1.0 << 7.99 << 7;
        newRow("within the snap of the next@1x") << 1.0 << 7.9999999 << 8;
        newRow("just outside the snap@1x") << 1.0 << 7.999998 << 7;
        newRow("just behind an edge@1x") << 1.0 << 8.0000001 << 8;
        newRow("first half@2x") << 2.0 << 7.0 << 14;
        newRow("second half@2x") << 2.0 << 7.5 << 15;
        newRow("61 / 1.75, whose product falls short of 61") << 1.75 << 61 / 1.75 << 61;
        newRow("within the snap of the left edge") << 1.0 << -1e-7 << 0;
    }

    void aPixelReachesFromItsEdgeToTheNext()
    {
        QFETCH(double, ratio);
        QFETCH(double, x);
        QFETCH(int, i);
        const Surface surface{1000, 1000, ratio};
        QVERIFY(isPixel(devicePixelFromWidget(surface, WidgetPoint(x, 3.0)), i, int(3 * ratio)));
        QVERIFY(isPixel(devicePixelFromWidget(surface, WidgetPoint(3.0, x)), int(3 * ratio), i));
    }

    void everyDeviceColumnIsFoundFromItsWidgetPosition_data()
    {
        addColumn<double>("ratio");
        for (const double ratio : {1.0, 1.1, 1.25, 1.3, 1.5, 1.75, 2.0, 2.25, 3.0})
            addRow("%gx", ratio) << ratio;
    }

    void everyDeviceColumnIsFoundFromItsWidgetPosition()
    {
        QFETCH(double, ratio);
        const Surface surface{8192, 8192, ratio};
        for (int i = 0; i < surface.widthPixels; ++i) {
            const WidgetPoint position(i / ratio, i / ratio);
            QVERIFY2(isPixel(devicePixelFromWidget(surface, position), i, i), qPrintable(QString::number(i)));
        }
    }

    void everyPixelCenterIsFoundFromItsWidgetPosition_data() { everyDeviceColumnIsFoundFromItsWidgetPosition_data(); }

    void everyPixelCenterIsFoundFromItsWidgetPosition()
    {
        QFETCH(double, ratio);
        const Surface surface{8192, 8192, ratio};
        for (int i = 0; i < surface.widthPixels; ++i) {
            const WidgetPoint position = widgetFromDevice(surface, pixelCenter({i, i}));
            QVERIFY2(isPixel(devicePixelFromWidget(surface, position), i, i), qPrintable(QString::number(i)));
            const DevicePoint back = deviceFromWidget(surface, position);
            QVERIFY(isNear(back.x, i + 0.5, kRoundingPixels));
            QVERIFY(isNear(back.y, i + 0.5, kRoundingPixels));
        }
    }

    void aPositionOffTheSurfaceIsRefused_data()
    {
        addColumn<Surface>("surface");
        addColumn<WidgetPoint>("position");
        addColumn<ErrorCode>("code");
        addColumn<double>("value");
        addColumn<double>("other");

        const Surface surface{500, 375, 1.25};
        const auto row = [](const char *name, const Surface &s, double x, double y, ErrorCode code, double value,
                            double other) { newRow(name) << s << WidgetPoint(x, y) << code << value << other; };
        using enum ErrorCode;
        row("left of it", surface, -0.01, 5, OutsideFramebuffer, -0.01, 5);
        row("above it", surface, 5, -0.01, OutsideFramebuffer, 5, -0.01);
        row("on its right edge", surface, 400, 5, OutsideFramebuffer, 400, 5);
        row("on its bottom edge", surface, 5, 300, OutsideFramebuffer, 5, 300);
        row("far outside", surface, 1e300, 5, OutsideFramebuffer, 1e300, 5);
        row("negative", surface, -7, -8, OutsideFramebuffer, -7, -8);
        row("NaN across", surface, kNan, 5, NotFinite, kNan, kNan);
        row("NaN down", surface, 5, kNan, NotFinite, kNan, kNan);
        row("infinite across", surface, kInfinity, 5, NotFinite, kInfinity, kNan);
        row("infinite down", surface, 5, -kInfinity, NotFinite, -kInfinity, kNan);
        row("no surface", {0, 0, 1.25}, 0, 0, EmptyFramebuffer, 0, 0);
        row("no width", {0, 375, 1.25}, 0, 0, EmptyFramebuffer, 0, 375);
        row("negative height", {500, -1, 1.25}, 0, 0, EmptyFramebuffer, 500, -1);
        row("ratio 0", {500, 375, 0.0}, 5, 5, PixelRatioNotPositive, 0, kNan);
        row("ratio -1", {500, 375, -1.0}, 5, 5, PixelRatioNotPositive, -1, kNan);
        row("ratio NaN", {500, 375, kNan}, 5, 5, PixelRatioNotPositive, kNan, kNan);
        row("ratio infinite", {500, 375, kInfinity}, 5, 5, PixelRatioNotPositive, kInfinity, kNan);
    }

    void aPositionOffTheSurfaceIsRefused()
    {
        QFETCH(Surface, surface);
        QFETCH(WidgetPoint, position);
        QFETCH(ErrorCode, code);
        QFETCH(double, value);
        QFETCH(double, other);
        const auto pixel = devicePixelFromWidget(surface, position);
        QVERIFY(!pixel);
        QCOMPARE(errorOf(pixel).code, code);
        QVERIFY(isSame(errorOf(pixel).value, value));
        QVERIFY(isSame(errorOf(pixel).other, other));
    }

    void windowAndDeviceAreInverse()
    {
        const Surface surface{500, 375, 1.25};
        // (7) and (8): the top edge of the framebuffer is y_w = 375, the bottom edge 0.
        QCOMPARE(windowFromDevice(surface, DevicePoint(12.25, 0), 0.5).y, 375.0);
        QCOMPARE(windowFromDevice(surface, DevicePoint(12.25, 375), 0.5).y, 0.0);
        QCOMPARE(windowFromDevice(surface, DevicePoint(12.25, 100.5), 0.5).x, 12.25);
        QCOMPARE(windowFromDevice(surface, DevicePoint(12.25, 100.5), 0.5).y, 274.5);
        for (int quarter = -40; quarter < 1600; ++quarter) {
            const double y = quarter / 4.0;
            const DevicePoint back = deviceFromWindow(surface, windowFromDevice(surface, DevicePoint(12.25, y), 0.5));
            QVERIFY(back.coordinates() == glm::dvec2(12.25, y));
        }
    }

    void theWholeSurfaceIsAViewport() { QVERIFY((wholeSurface({500, 375, 1.25}) == Viewport{0, 0, 500, 375})); }
};

UNPROJECTOR_TEST(TestViewport)
#include "test_viewport.moc"
