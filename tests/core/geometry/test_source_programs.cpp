// The results of the originals' programs and formulas for their scenes, worked out by hand, forward
// and back.

#include "tests/support/test.h"

#include "tests/core/geometry/source_examples.h"
#include "tests/support/is_near.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace source_examples;
using namespace unprojector::geometry;

namespace {

/// The numbers worked out by hand have seven decimals.
constexpr double kPrintedDigits = 5e-7;

/// Forward by matrices, for the vertices of the originals' programs: their model-view matrix is the
/// identity.
WindowPoint windowFromEye(const Projection &projection, const Viewport &viewport, const EyePoint &point)
{
    const glm::dvec4 clip = clipFromEye(projection).value() * glm::dvec4(point.coordinates(), 1.0);
    return windowFromNdc(viewport, DepthRange{}, NdcPoint(glm::dvec3(clip) / clip.w));
}

} // namespace

class TestSourcePrograms : public QObject {
    Q_OBJECT

private slots:
    /// The steps of parallel-projection: move, scale, mirror in z; for a box without symmetry.
    void glOrthoIsThreeSteps()
    {
        const Ortho box{-1, 3, -2, 1, 2, 10};
        const glm::dmat4 steps = worldFromObject({Scale{{1, 1, -1}}, Scale{{2.0 / 4.0, 2.0 / 3.0, 2.0 / 8.0}},
                                                  Translate{{-2.0 / 2.0, 1.0 / 2.0, 12.0 / 2.0}}});
        const glm::dmat4 ortho = clipFromEye(box).value();
        for (int index = 0; index < 16; ++index)
            QVERIFY2(isNear(element(steps, index), element(ortho, index), kRounding),
                     qPrintable(QString::number(index)));
    }

    /// opencascade-transforms: BuildNorm2ViewportMatrix.
    void theViewportWithYDownCountsFromTheTop()
    {
        const Surface surface{300, 200, 1.0};
        const glm::dmat4 yDown{{150, 0, 0, 0}, {0, -100, 0, 0}, {0, 0, 0.5, 0}, {150, 100, 0.5, 1}};
        for (const NdcPoint &ndc : {NdcPoint(0, 0, 0), NdcPoint(0.25, -0.75, 0.5), NdcPoint(-1, 1, -1)}) {
            const glm::dvec4 byMatrix = yDown * glm::dvec4(ndc.coordinates(), 1.0);
            const WindowPoint window = windowFromNdc(wholeSurface(surface), DepthRange{}, ndc);
            const DevicePoint device = deviceFromWindow(surface, window);
            QVERIFY(isNear(glm::dvec3(byMatrix), {device.x, device.y, window.z}, kRounding));
        }
    }

    void theWorldOriginIsTheMiddleOfTheWidgetAndBack_data()
    {
        addColumn<Projection>("projection");
        addColumn<WorldPoint>("eye");
        addColumn<double>("depth");

        // The origin is 5, or sqrt(3^2 + 4^2 + 12^2) = 13, in front of the eye.
        newRow("perspective from the front")
            << Projection(Perspective{kRightAngle, 1, 1, 100}) << WorldPoint(0, 0, 5) << 400.0 / 495.0;
        newRow("perspective from aside") << Projection(Perspective{kRightAngle, 1, 1, 100}) << WorldPoint(3, 4, 12)
                                         << 1200.0 / 1287.0;
        newRow("ortho from the front") << Projection(Ortho{-10, 10, -10, 10, 1, 9}) << WorldPoint(0, 0, 5) << 0.5;
        newRow("ortho from aside") << Projection(Ortho{-10, 10, -10, 10, 3, 33}) << WorldPoint(3, 4, 12) << 1.0 / 3.0;
    }

    void theWorldOriginIsTheMiddleOfTheWidgetAndBack()
    {
        QFETCH(Projection, projection);
        QFETCH(WorldPoint, eye);
        QFETCH(double, depth);
        const EyeFrame frame = eyeFrame({eye, WorldPoint(0, 0, 0), {0, 1, 0}}).value();
        const Surface surface = surfaceFromWidget(300, 300, 1.0);
        const Viewport viewport = wholeSurface(surface);

        const WindowPoint window = windowFromEye(projection, viewport, eyeFromWorld(frame, WorldPoint(0, 0, 0)));
        const WidgetPoint widget = widgetFromDevice(surface, deviceFromWindow(surface, window));
        QVERIFY(isNear({widget.x, widget.y, window.z}, {150, 150, depth}, kRoundTrip));

        const WindowPoint clicked = windowFromDevice(surface, deviceFromWidget(surface, WidgetPoint(150, 150)), depth);
        const EyePoint byFormula = unprojectClosedForm(projection, viewport, DepthRange{}, clicked).value();
        QVERIFY(isNear(worldFromEye(frame, byFormula).coordinates(), {0, 0, 0}, kRoundTrip));
        const glm::dmat4 clipFromWorld = clipFromEye(projection).value() * eyeFromWorld(frame);
        QVERIFY(
            isNear(unprojectByInverse<WorldSpace>(clipFromWorld, viewport, DepthRange{}, clicked).value().coordinates(),
                   {0, 0, 0}, kRoundTrip));
    }

    void threeProjectionsGiveOnePictureOnlyInASquareWindow_data()
    {
        addColumn<double>("width");
        addColumn<double>("height");
        addColumn<double>("handMade");
        addColumn<double>("gluPerspective");

        newRow("800x600: the pictures differ") << 800.0 << 600.0 << 1.3333333 << 0.75;
        newRow("600x600: the pictures agree") << 600.0 << 600.0 << 1.0 << 1.0;
        newRow("600x800: the pictures differ the other way") << 600.0 << 800.0 << 0.75 << 1.3333333;
    }

    void threeProjectionsGiveOnePictureOnlyInASquareWindow()
    {
        QFETCH(double, width);
        QFETCH(double, height);
        QFETCH(double, handMade);
        QFETCH(double, gluPerspective);

        // The formulas of the original's program: AspectRatio = height / width, ViewAngleV across,
        // ViewAngleH up.
        const double viewAngleH = kRightAngle;
        const double viewAngleV = std::atan(std::tan(viewAngleH / 2.0) * (height / width)) * 2.0;
        const double right = 5.0 * std::tan(viewAngleV / 2.0);
        const double top = 5.0 * std::tan(viewAngleH / 2.0);
        const glm::dmat4 frustum = clipFromEye(Frustum{-right, right, -top, top, 5, 80000}).value();
        QVERIFY(isNear(element(frustum, 0), 1.0 / std::tan(viewAngleV / 2.0), 1e-15));
        QVERIFY(isNear(element(frustum, 0), handMade, kPrintedDigits));
        QVERIFY(isNear(element(frustum, 5), 1.0, kPrintedDigits));

        const glm::dmat4 perspective = clipFromEye(Perspective{kRightAngle, width / height, 5, 80000}).value();
        QVERIFY(isNear(element(perspective, 0), gluPerspective, kPrintedDigits));
        QVERIFY(isNear(element(perspective, 5), 1.0, kPrintedDigits));
        // The depth rows agree: -80005/79995 and -800000/79995.
        for (const glm::dmat4 &m : {frustum, perspective}) {
            QVERIFY(isNear(element(m, 10), -1.0001250, kPrintedDigits));
            QVERIFY(isNear(element(m, 14), -10.0006250, kPrintedDigits));
            QCOMPARE(element(m, 11), -1.0);
        }
    }

    void programVerticesGoToTheirPixelsAndBack_data()
    {
        addColumn<Projection>("projection");
        addColumn<Viewport>("viewport");
        addColumn<EyePoint>("vertex");
        addColumn<glm::dvec3>("window");

        // projection-derivation. x_n = x / |z| * 4/3 for the hand-made matrix, * 3/4 for
        // gluPerspective.
        const Viewport wide{0, 0, 800, 600};
        const Projection handMade = Frustum{-3.75, 3.75, -5, 5, 5, 80000};
        const Projection perspective = Perspective{kRightAngle, 800.0 / 600.0, 5, 80000};
        const double at10 = 0.5000312519532471, at20 = 0.7500468779298706, at30 = 0.8333854199220785,
                     at40 = 0.8750546909181824;
        newRow("fan, hand-made, as printed: apex")
            << handMade << wide << EyePoint(0, 0, -20) << glm::dvec3(400, 300, at20);
        newRow("fan, hand-made, as printed: second")
            << handMade << wide << EyePoint(30, 20, -40) << glm::dvec3(800, 450, at40);
        newRow("fan, hand-made, as printed: third, right of the window")
            << handMade << wide << EyePoint(40, 10, -30) << glm::dvec3(400 + 400 * 16.0 / 9.0, 400, at30);
        newRow("fan, hand-made, translated: apex")
            << handMade << wide << EyePoint(0, 0, -10) << glm::dvec3(400, 300, at10);
        newRow("fan, hand-made, translated: second")
            << handMade << wide << EyePoint(30, 20, -30) << glm::dvec3(400 + 400 * 4.0 / 3.0, 500, at30);
        newRow("fan, gluPerspective, as printed: apex")
            << perspective << wide << EyePoint(0, 0, -20) << glm::dvec3(400, 300, at20);
        newRow("fan, gluPerspective, as printed: second")
            << perspective << wide << EyePoint(30, 20, -40) << glm::dvec3(625, 450, at40);
        newRow("fan, gluPerspective, as printed: third")
            << perspective << wide << EyePoint(40, 10, -30) << glm::dvec3(800, 400, at30);
        newRow("fan, gluPerspective, translated: third")
            << perspective << wide << EyePoint(40, 10, -20) << glm::dvec3(1000, 450, at20);

        // parallel-projection 1: SIZE = 4.5 is truncated to 4, so the corners are at 4/9 of the half
        // window.
        const Projection box = Ortho{-9, 9, -9, 9, 2, 9};
        const double left = 400 - 1600.0 / 9.0, right = 400 + 1600.0 / 9.0, below = 300 - 1200.0 / 9.0,
                     above = 300 + 1200.0 / 9.0;
        newRow("quad A, red") << box << wide << EyePoint(-4, 4, -4) << glm::dvec3(left, above, 2.0 / 7.0);
        newRow("quad B, green") << box << wide << EyePoint(4, 4, -4) << glm::dvec3(right, above, 2.0 / 7.0);
        newRow("quad C, blue") << box << wide << EyePoint(4, -4, -4) << glm::dvec3(right, below, 2.0 / 7.0);
        newRow("quad D, white") << box << wide << EyePoint(-4, -4, -4) << glm::dvec3(left, below, 2.0 / 7.0);
        newRow("quad on the near plane") << box << wide << EyePoint(9, -9, -2) << glm::dvec3(800, 0, 0);
        newRow("quad on the far plane") << box << wide << EyePoint(-9, 9, -9) << glm::dvec3(0, 600, 1);

        // parallel-projection 2: x_n = (x - 1.0108550 |z|) / 10. With cot = 1 the front corner would be
        // at 0.15, not 0.1467.
        const Projection sheared = Oblique{{-10, 10, -10, 10, 2, 9}, 0.78, 0.78};
        const Viewport square{0, 0, 600, 600};
        const auto at = [](double ndc) { return 300.0 * (1.0 + ndc); };
        const double front = 1.0 / 7.0, back = 2.5 / 7.0;
        newRow("box H, front top right") << sheared << square << EyePoint(4.5, 4.5, -3)
                                         << glm::dvec3(at(0.1467434911629235), at(0.1467434911629235), front);
        newRow("box A, front bottom left") << sheared << square << EyePoint(-4.5, -4.5, -3)
                                           << glm::dvec3(at(-0.7532565088370765), at(-0.7532565088370765), front);
        newRow("box C, front top left") << sheared << square << EyePoint(-4.5, 4.5, -3)
                                        << glm::dvec3(at(-0.7532565088370765), at(0.1467434911629235), front);
        newRow("box D, front bottom right") << sheared << square << EyePoint(4.5, -4.5, -3)
                                            << glm::dvec3(at(0.1467434911629235), at(-0.7532565088370765), front);
        newRow("box F, back top left") << sheared << square << EyePoint(-4.5, 4.5, -4.5)
                                       << glm::dvec3(at(-0.9048847632556147), at(-0.0048847632556147), back);
        newRow("box B, back bottom left") << sheared << square << EyePoint(-4.5, -4.5, -4.5)
                                          << glm::dvec3(at(-0.9048847632556147), at(-0.9048847632556147), back);
        newRow("box E, back top right") << sheared << square << EyePoint(4.5, 4.5, -4.5)
                                        << glm::dvec3(at(-0.0048847632556147), at(-0.0048847632556147), back);
        newRow("box G, back bottom right") << sheared << square << EyePoint(4.5, -4.5, -4.5)
                                           << glm::dvec3(at(-0.0048847632556147), at(-0.9048847632556147), back);
    }

    void programVerticesGoToTheirPixelsAndBack()
    {
        QFETCH(Projection, projection);
        QFETCH(Viewport, viewport);
        QFETCH(EyePoint, vertex);
        QFETCH(glm::dvec3, window);

        QVERIFY(isNear(windowFromEye(projection, viewport, vertex).coordinates(), window, kRoundTrip));

        const WindowPoint clicked(window);
        QVERIFY(isNear(unprojectClosedForm(projection, viewport, DepthRange{}, clicked).value().coordinates(),
                       vertex.coordinates(), kRoundTrip));
        // 5 : 80000 costs the inverse matrix four more digits.
        const glm::dmat4 matrix = clipFromEye(projection).value();
        QVERIFY(isNear(unprojectByInverse<EyeSpace>(matrix, viewport, DepthRange{}, clicked).value().coordinates(),
                       vertex.coordinates(), 1e-9));
    }

    /// Help, 4: n f / (f - d (f - n)) against (13), at n : f = 0.01 : 10^6, as shares of the scene's
    /// size.
    void theUsualFormOfTheDistanceLosesSevenDigits()
    {
        constexpr double kUsual = 9e-10, kStable = 6e-16;
        constexpr double n = 0.01, f = 1e6;
        const Projection deep = Frustum{-n, n, -n, n, n, f};
        std::mt19937_64 random(1);
        double usual = 0.0, stable = 0.0;
        for (int click = 0; click < 2000; ++click) {
            const double share = double(random() >> 11U) * 0x1p-53;
            const double distance = n + share * (f - n);
            const double d = (1.0 / n - 1.0 / distance) / (1.0 / n - 1.0 / f);
            const double z =
                -unprojectClosedForm(deep, Viewport{0, 0, 800, 600}, DepthRange{}, WindowPoint(400, 300, d)).value().z;
            usual = std::max(usual, std::abs(n * f / (f - d * (f - n)) - z) / f);
            stable = std::max(stable, std::abs(n * f / (f * (1.0 - d) + n * d) - z) / f);
        }
        QVERIFY2(usual > kUsual, qPrintable(QString::number(usual)));
        QVERIFY2(stable < kStable, qPrintable(QString::number(stable)));
        QVERIFY2(usual > 1e6 * stable, qPrintable(QString::number(usual / stable)));
    }
};

UNPROJECTOR_TEST(TestSourcePrograms)
#include "test_source_programs.moc"
