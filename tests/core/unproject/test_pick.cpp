// The chain of a click from the widget to the world, and the uncertainty of its end. The rows are
// written out by hand from formulas (7) to (12): both methods would agree on a lost flip, half
// pixel, pixel ratio or viewport offset.

#include "tests/support/test.h"

#include "core/unproject/pick.h"
#include "tests/support/is_near.h"
#include "tests/support/unprojecting.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::unproject;

namespace {

/// A few roundings of numbers up to 1000.
constexpr double kRounding = 1e-12;
/// The matrix is inverted, which costs digits: its condition number here stays below 10^4.
constexpr double kInverseRounding = 1e-10;
/// Single precision: 24 bits of numbers up to 100, times that condition.
constexpr double kFloatRounding = 2e-3;

/// 800 x 600 logical pixels, looked at from (0, 0, 5) towards the origin.
Setup plainFrustum()
{
    return {{800, 600, 1.0},
            {0.0, 0.0, 800.0, 600.0},
            {},
            Frustum{-1.0, 1.0, -0.75, 0.75, 1.0, 10.0},
            LookAt{WorldPoint(0.0, 0.0, 5.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}}};
}

/// 1200 x 900 device pixels at ratio 1.5, with a viewport that neither starts in the corner nor
/// fills the surface. The camera looks along -z, so that its axes are the world's.
Setup offsetBox()
{
    return {{1200, 900, 1.5},
            {100.0, 50.0, 600.0, 400.0},
            {},
            Ortho{-3.0, 3.0, -2.0, 2.0, 1.0, 9.0},
            LookAt{WorldPoint(10.0, 20.0, 30.0), WorldPoint(10.0, 20.0, 20.0), {0.0, 1.0, 0.0}}};
}

} // namespace

class TestPick : public QObject {
    Q_OBJECT

private slots:
    void aClickIsFollowedBackToTheWorld_data()
    {
        addColumn<Setup>("geometry");
        addColumn<glm::dvec3>("click"); // widget x, y; depth
        addColumn<QPoint>("pixel");
        addColumn<glm::dvec3>("window");
        addColumn<glm::dvec3>("eye");
        addColumn<glm::dvec3>("world");

        // z = 1 x 10 / (10 x 0.5 + 1 x 0.5) = 10 / 5.5; x = z (400.5 x 2 / 800 - 1), y = z (299.5 x 1.5
        // / 600 - 0.75)
        const double z = 1.8181818181818181;
        newRow("frustum, middle@1x") << plainFrustum() << glm::dvec3(400.0, 300.0, 0.5) << QPoint(400, 300)
                                     << glm::dvec3(400.5, 299.5, 0.5) << glm::dvec3(0.00125 * z, -0.00125 * z, -z)
                                     << glm::dvec3(0.00125 * z, -0.00125 * z, 5.0 - z);
        // The corner pixels: half a pixel, 0.00125 of z, inside the window's edges -1 .. 1 and -0.75 ..
        // 0.75.
        newRow("frustum, top-left@1x, near plane")
            << plainFrustum() << glm::dvec3(0.0, 0.0, 0.0) << QPoint(0, 0) << glm::dvec3(0.5, 599.5, 0.0)
            << glm::dvec3(-0.99875, 0.74875, -1.0) << glm::dvec3(-0.99875, 0.74875, 4.0);
        newRow("frustum, bottom-right@1x, far plane")
            << plainFrustum() << glm::dvec3(799.9, 599.9, 1.0) << QPoint(799, 599) << glm::dvec3(799.5, 0.5, 1.0)
            << glm::dvec3(9.9875, -7.4875, -10.0) << glm::dvec3(9.9875, -7.4875, -5.0);

        // device (450.75, 750.75); y_v = 900 - 750.5; x = 350.5 x 6 / 600 - 3, y = 99.5 x 4 / 400 - 2;
        // z = 0.75 + 9 x 0.25
        const glm::dvec3 click(300.5, 500.5, 0.25), window(450.5, 149.5, 0.25);
        newRow("ortho, offset viewport@1.5x") << offsetBox() << click << QPoint(450, 750) << window
                                              << glm::dvec3(0.505, -1.005, -3.0) << glm::dvec3(10.505, 18.995, 27.0);
        Setup reversed = offsetBox();
        reversed.depthRange = {1.0, 0.0};
        newRow("ortho, reversed depth range@1.5x")
            << reversed << glm::dvec3(300.5, 500.5, 0.75) << QPoint(450, 750) << glm::dvec3(450.5, 149.5, 0.75)
            << glm::dvec3(0.505, -1.005, -3.0) << glm::dvec3(10.505, 18.995, 27.0);
        // cot 45 degrees = 1: x and y grow by z = 3.
        Setup oblique = offsetBox();
        oblique.projection() =
            Oblique{std::get<Ortho>(offsetBox().projection()), radiansFromDegrees(45.0), radiansFromDegrees(45.0)};
        newRow("oblique, offset viewport@1.5x") << oblique << click << QPoint(450, 750) << window
                                                << glm::dvec3(3.505, 1.995, -3.0) << glm::dvec3(13.505, 21.995, 27.0);
        // The same window as a frustum with n = 1, f = 9: z = 9 / (9 x 0.75 + 0.25) = 9 / 7, x = 0.505
        // z, y = -1.005 z
        Setup frustum = offsetBox();
        frustum.projection() = Frustum{-3.0, 3.0, -2.0, 2.0, 1.0, 9.0};
        const double distance = 9.0 / 7.0;
        newRow("frustum, offset viewport@1.5x")
            << frustum << click << QPoint(450, 750) << window
            << glm::dvec3(0.505 * distance, -1.005 * distance, -distance)
            << glm::dvec3(10.0 + 0.505 * distance, 20.0 - 1.005 * distance, 30.0 - distance);
        // Seen along +x with z up: s = -y, u = z, f = x, so world = eye + (z, -x, y).
        Setup turned = offsetBox();
        turned.camera() = {WorldPoint(10.0, 20.0, 30.0), WorldPoint(11.0, 20.0, 30.0), {0.0, 0.0, 1.0}};
        newRow("ortho, turned camera@1.5x") << turned << click << QPoint(450, 750) << window
                                            << glm::dvec3(0.505, -1.005, -3.0) << glm::dvec3(13.0, 19.495, 28.995);
        // Column 413 of ratio 1.5 comes as 413 / 1.5, whose product with 1.5 may fall just below 413.
        newRow("ortho, device column as a widget position@1.5x")
            << offsetBox() << glm::dvec3(413.0 / 1.5, 750.0 / 1.5, 0.25) << QPoint(413, 750)
            << glm::dvec3(413.5, 149.5, 0.25) << glm::dvec3(0.135, -1.005, -3.0) << glm::dvec3(10.135, 18.995, 27.0);
    }

    void aClickIsFollowedBackToTheWorld()
    {
        QFETCH(Setup, geometry);
        QFETCH(glm::dvec3, click);
        QFETCH(QPoint, pixel);
        QFETCH(glm::dvec3, window);
        QFETCH(glm::dvec3, eye);
        QFETCH(glm::dvec3, world);

        const Result<Pick> pick = pickAt(geometry, WidgetPoint(click.x, click.y), {click.z, 0, 24});
        QVERIFY(pick.hasValue());
        QVERIFY(pick->hit());
        QCOMPARE(pick->widget.x, click.x);
        QCOMPARE(pick->widget.y, click.y);
        QCOMPARE(QPoint(pick->devicePixel.i, pick->devicePixel.j), pixel);
        QVERIFY(isNear(pick->window.coordinates(), window, 0.0));
        QVERIFY(isNear(pick->point.eye[Method::Formula]->coordinates(), eye, kRounding));
        QVERIFY(isNear(pick->point.eye[Method::Matrix]->coordinates(), eye, kInverseRounding));
        QVERIFY(isNear(pick->point.eye[Method::MatrixInFloat]->coordinates(), eye, kFloatRounding));
        QVERIFY(isNear(pick->point.world[Method::Formula]->coordinates(), world, kRounding));
        QVERIFY(isNear(pick->point.world[Method::Matrix]->coordinates(), world, kInverseRounding));
        QVERIFY(isNear(pick->point.world[Method::MatrixInFloat]->coordinates(), world, kFloatRounding));

        const Result<WindowPoint> back = windowFromWorld(geometry, WorldPoint(world));
        QVERIFY(back.hasValue());
        QVERIFY(isNear(back->coordinates(), window, kInverseRounding));
    }

    void allPositionsInAPixelGiveTheSamePoint()
    {
        const Setup setup = plainFrustum();
        const Result<Pick> middle = pickAt(setup, WidgetPoint(412.5, 300.5), {0.5, 0, 24});
        QVERIFY(middle.hasValue());
        for (const WidgetPoint &position :
             {WidgetPoint(412.0, 300.0), WidgetPoint(412.99, 300.0), WidgetPoint(412.0, 300.99)}) {
            const Result<Pick> pick = pickAt(setup, position, {0.5, 0, 24});
            QVERIFY(pick.hasValue());
            QVERIFY(pick->devicePixel == (DevicePixel{412, 300}));
            QVERIFY(isNear(pick->point.world[Method::Formula]->coordinates(),
                           middle->point.world[Method::Formula]->coordinates(), 0.0));
            QVERIFY(isNear(pick->point.world[Method::Matrix]->coordinates(),
                           middle->point.world[Method::Matrix]->coordinates(), 0.0));
        }
    }

    void aBackgroundClickGivesTheRayOfItsPixel()
    {
        const Result<Pick> pick = pickAt(plainFrustum(), WidgetPoint(0.0, 0.0), {1.0, {}, 24});
        QVERIFY(pick.hasValue());
        QVERIFY(!pick->hit());
        QVERIFY(isNear(pick->window.coordinates(), {0.5, 599.5, 1.0}, 0.0));
        QVERIFY(isNear(pick->rayNear.eye[Method::Formula]->coordinates(), {-0.99875, 0.74875, -1.0}, kRounding));
        QVERIFY(isNear(pick->rayFar.eye[Method::Formula]->coordinates(), {-9.9875, 7.4875, -10.0}, kRounding));
        QVERIFY(isNear(pick->rayNear.world[Method::Formula]->coordinates(), {-0.99875, 0.74875, 4.0}, kRounding));
        QVERIFY(isNear(pick->rayFar.world[Method::Formula]->coordinates(), {-9.9875, 7.4875, -5.0}, kRounding));
        QVERIFY(isNear(pick->rayNear.world[Method::Matrix]->coordinates(), {-0.99875, 0.74875, 4.0}, kInverseRounding));
        QVERIFY(isNear(pick->rayFar.world[Method::Matrix]->coordinates(), {-9.9875, 7.4875, -5.0}, kInverseRounding));

        // The ray's ends follow the depth range, also a reversed one.
        Setup reversed = plainFrustum();
        reversed.depthRange = {1.0, 0.25};
        const Result<Pick> other = pickAt(reversed, WidgetPoint(0.0, 0.0), {0.25, {}, 24});
        QVERIFY(other.hasValue());
        QVERIFY(isNear(other->rayNear.world[Method::Formula]->coordinates(), {-0.99875, 0.74875, 4.0}, kRounding));
        QVERIFY(isNear(other->rayFar.world[Method::Formula]->coordinates(), {-9.9875, 7.4875, -5.0}, kRounding));
    }

    void whatCannotBePickedIsRefused_data()
    {
        addColumn<Setup>("geometry");
        addColumn<glm::dvec3>("click");
        addColumn<int>("code");
        const auto row = [](const char *name, const Setup &g, const glm::dvec3 &click, ErrorCode code) {
            newRow(name) << g << click << static_cast<int>(code);
        };
        constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
        const glm::dvec3 middle(400.0, 300.0, 0.5);
        row("right of the view", plainFrustum(), {800.0, 300.0, 0.5}, ErrorCode::OutsideFramebuffer);
        row("below the view", plainFrustum(), {400.0, 600.0, 0.5}, ErrorCode::OutsideFramebuffer);
        row("above the view", plainFrustum(), {400.0, -0.5, 0.5}, ErrorCode::OutsideFramebuffer);
        row("position NaN", plainFrustum(), {kNan, 0.0, 0.5}, ErrorCode::NotFinite);
        Setup g = plainFrustum();
        g.surface.heightPixels = 0;
        row("no framebuffer", g, middle, ErrorCode::EmptyFramebuffer);
        g = plainFrustum();
        g.viewport.width = 0.0;
        row("no viewport", g, middle, ErrorCode::EmptyViewport);
        g = plainFrustum();
        g.depthRange = {0.5, 0.5};
        row("no depth range", g, middle, ErrorCode::EmptyDepthRange);
        g = plainFrustum();
        g.projection() = Frustum{-1.0, 1.0, -1.0, 1.0, 0.0, 1.0};
        row("near 0", g, middle, ErrorCode::NearNotPositive);
        g = plainFrustum();
        g.camera().center = g.camera().eye;
        row("camera without direction", g, middle, ErrorCode::EyeEqualsCenter);
    }

    void whatCannotBePickedIsRefused()
    {
        QFETCH(Setup, geometry);
        QFETCH(glm::dvec3, click);
        QFETCH(int, code);
        for (const std::optional<std::size_t> object : {std::optional<std::size_t>(0), {}}) {
            const Result<Pick> pick = pickAt(geometry, WidgetPoint(click.x, click.y), {click.z, object, 24});
            QVERIFY(!pick.hasValue());
            QCOMPARE(static_cast<int>(pick.error().code), code);
        }
    }

    void aDepthOutsideItsRangeIsRefusedOnASurfaceOnly()
    {
        for (const double depth : {-0.001, 1.001, std::numeric_limits<double>::quiet_NaN()}) {
            const Result<Pick> surface = pickAt(plainFrustum(), WidgetPoint(1.0, 1.0), {depth, 0, 24});
            QVERIFY(!surface.hasValue());
            QCOMPARE(surface.error().code, ErrorCode::DepthOutsideRange);
            // The background's depth is not unprojected: its ray takes the ends of the range.
            QVERIFY(pickAt(plainFrustum(), WidgetPoint(1.0, 1.0), {depth, {}, 24}).hasValue());
        }
    }

    void certaintyHasTheDepthStepAndThePixel_data()
    {
        addColumn<Setup>("geometry");
        addColumn<double>("distance");
        addColumn<int>("bits");
        addColumn<glm::dvec3>("expected"); // half a depth step, pixel's width and height

        // 25 x 9 / 10 / (2^24 - 1) / 2; 2 x 5 / 800, 1.5 x 5 / 600
        newRow("frustum, 24 bits") << plainFrustum() << 5.0 << 24 << glm::dvec3(6.705522936911759e-7, 0.0125, 0.0125);
        // 25 x 9 / 10 / 65535 / 2
        newRow("frustum, 16 bits") << plainFrustum() << 5.0 << 16 << glm::dvec3(1.7166399633783476e-4, 0.0125, 0.0125);
        // 81 x 9 / 10 / 255 / 2
        newRow("frustum, 8 bits, far away")
            << plainFrustum() << 9.0 << 8 << glm::dvec3(0.14294117647058824, 0.0225, 0.0225);
        // 8 / (2^24 - 1) / 2; 6 / 600, 4 / 400, wherever it lies
        newRow("ortho, 24 bits") << offsetBox() << 3.0 << 24 << glm::dvec3(2.3841859331241806e-7, 0.01, 0.01);
        newRow("ortho, 24 bits, behind the eye")
            << offsetBox() << -3.0 << 24 << glm::dvec3(2.3841859331241806e-7, 0.01, 0.01);
        Setup half = offsetBox();
        half.depthRange = {0.75, 0.25};
        newRow("ortho, half the depth range") << half << 3.0 << 24 << glm::dvec3(4.768371866248361e-7, 0.01, 0.01);
        // gluPerspective(90 degrees, 2, 0.5, 8): window 2 x 1 at n = 0.5; 16 x 7.5 / 4 / (2^24 - 1) /
        // 2; 2 x 4 / 0.5 / 800, 4 / 0.5 / 600
        Setup perspective = plainFrustum();
        perspective.projection() = Perspective{1.5707963267948966, 2.0, 0.5, 8.0};
        newRow("perspective, wide pixels")
            << perspective << 4.0 << 24 << glm::dvec3(8.940697249215677e-7, 0.02, 4.0 / 300.0);
        // A mirrored window: sizes stay positive.
        Setup mirrored = plainFrustum();
        mirrored.projection() = Frustum{1.0, -1.0, 0.75, -0.75, 1.0, 10.0};
        newRow("mirrored frustum") << mirrored << 5.0 << 24 << glm::dvec3(6.705522936911759e-7, 0.0125, 0.0125);
    }

    void certaintyHasTheDepthStepAndThePixel()
    {
        QFETCH(Setup, geometry);
        QFETCH(double, distance);
        QFETCH(int, bits);
        QFETCH(glm::dvec3, expected);
        const Certainty certainty = Certainties(geometry).at(distance, {DepthFormat(bits).halfStep(0.5), 0.0});
        constexpr double kLiteral = 1e-9; // the digits written above
        QVERIFY(isRelativelyNear(certainty.halfDepthStep, expected.x, kLiteral));
        QVERIFY(isRelativelyNear(certainty.footprintWidth, expected.y, kLiteral));
        QVERIFY(isRelativelyNear(certainty.footprintHeight, expected.z, kLiteral));
    }

    void thePickKeepsTheCertaintyOfItsDistance()
    {
        // z = 10 / 5.5 as above: z^2 x 9 / 10 / (2^24 - 1) / 2; 2 z / 800, 1.5 z / 600
        const Result<Pick> pick = pickAt(plainFrustum(), WidgetPoint(400.0, 300.0), {0.5, 0, 24});
        QVERIFY(pick.hasValue());
        QVERIFY(isRelativelyNear(pick->certainty.halfDepthStep, 3.305785123966942 * 0.9 / 2.0 / 16777215.0, 1e-12));
        QVERIFY(isRelativelyNear(pick->certainty.footprintWidth, 1.8181818181818181 / 400.0, 1e-12));
        QVERIFY(isRelativelyNear(pick->certainty.footprintHeight, 1.8181818181818181 / 400.0, 1e-12));
    }

    void eachAxisHasItsOwnUncertainty_data()
    {
        addColumn<Setup>("geometry");
        addColumn<EyePoint>("point");
        addColumn<glm::dvec3>("inEye");
        addColumn<glm::dvec3>("inWorld");
        // Half a depth step of 0.5, a pixel of 0.2 x 0.1.
        Setup setup = plainFrustum();
        setup.pose = LookAt{WorldPoint(0, 0, 0), WorldPoint(0, 0, -1), {0, 1, 0}};
        // The ray through (1, -2, -4) is (0.25, -0.5, -1) a unit: 0.125 + 0.1, 0.25 + 0.05, 0.5.
        newRow("frustum along the axes") << setup << EyePoint(1, -2, -4) << glm::dvec3(0.225, 0.3, 0.5)
                                         << glm::dvec3(0.225, 0.3, 0.5);
        // Looking along +x with z up: s = -y, u = z, f = x.
        setup.pose = LookAt{WorldPoint(5, 5, 5), WorldPoint(6, 5, 5), {0, 0, 1}};
        newRow("frustum along x") << setup << EyePoint(1, -2, -4) << glm::dvec3(0.225, 0.3, 0.5)
                                  << glm::dvec3(0.5, 0.225, 0.3);
        // A rotation by 45 degrees about y: s = (r, 0, -r), f = (-r, 0, -r) with r = sqrt(1/2). The
        // ray's step is 0.125 s - 0.25 u + 0.5 f = (-0.375 r, -0.25, -0.625 r); the pixel adds 0.1 r,
        // 0.05, 0.1 r.
        const double r = std::sqrt(0.5);
        setup.pose = LookAt{WorldPoint(1, 0, 1), WorldPoint(0, 0, 0), {0, 1, 0}};
        newRow("frustum at an angle") << setup << EyePoint(1, -2, -4) << glm::dvec3(0.225, 0.3, 0.5)
                                      << glm::dvec3(0.475 * r, 0.3, 0.725 * r);
        Setup box = offsetBox();
        box.pose = LookAt{WorldPoint(0, 0, 0), WorldPoint(0, 0, -1), {0, 1, 0}};
        newRow("box") << box << EyePoint(1, -2, -4) << glm::dvec3(0.1, 0.05, 0.5) << glm::dvec3(0.1, 0.05, 0.5);
        newRow("box, behind the eye") << box << EyePoint(1, -2, 4) << glm::dvec3(0.1, 0.05, 0.5)
                                      << glm::dvec3(0.1, 0.05, 0.5);
        // cot 45 degrees is 1: x goes along with the depth.
        box.projection() = Oblique{{-3, 3, -2, 2, 1, 9}, std::acos(-1.0) / 4.0, std::acos(-1.0) / 2.0};
        newRow("oblique") << box << EyePoint(1, -2, -4) << glm::dvec3(0.6, 0.05, 0.5) << glm::dvec3(0.6, 0.05, 0.5);
    }

    void eachAxisHasItsOwnUncertainty()
    {
        QFETCH(Setup, geometry);
        QFETCH(EyePoint, point);
        QFETCH(glm::dvec3, inEye);
        QFETCH(glm::dvec3, inWorld);
        const Uncertainty uncertainty = Certainties(geometry).withinPixel(point, WorldPoint(), {0.0, 0.2, 0.1, 0.5});
        // The pixel's centre is exact: the error that remains goes along the ray, and is as much of it
        // on each axis.
        const Uncertainty along = Certainties(geometry).of(point, WorldPoint(), {0.0, 0.2, 0.1, 0.5});
        const Uncertainty pixelAlone = Certainties(geometry).withinPixel(point, WorldPoint(), {0.0, 0.2, 0.1, 0.0});
        for (int axis = 0; axis < 3; ++axis) {
            QVERIFY(std::abs(uncertainty.eye[axis] - inEye[axis]) < 1e-12);
            QVERIFY(std::abs(uncertainty.world[axis] - inWorld[axis]) < 1e-12);
            QVERIFY(std::abs(along.eye[axis] + pixelAlone.eye[axis] - inEye[axis]) < 1e-12);
            QVERIFY(std::abs(along.world[axis] + pixelAlone.world[axis] - inWorld[axis]) < 1e-12);
        }
    }

    void whatHasTheDepthAndThePixelLiesWithinThePixel()
    {
        // Every corner of the pixel, half a step of a coarse depth buffer before and behind.
        Setup setup = plainFrustum();
        setup.pose = LookAt{WorldPoint(4, 3, 7), WorldPoint(0.3, 0.2, 0.1), {0.1, 1, 0.2}};
        const Unprojector unprojector = Unprojector::of(setup).value();
        const Result<Pick> pick = unproject::pickAt(unprojector, {{}, {123, 456}, {0.625, 0, 10}});
        QVERIFY(pick.hasValue());
        const double halfStep = 0.5 / 1023.0;
        for (const double x : {-0.5, 0.5}) {
            for (const double y : {-0.5, 0.5}) {
                for (const double d : {-halfStep, halfStep}) {
                    const WindowPoint corner(pick->window.x + x, pick->window.y + y, pick->window.z + d);
                    const WorldVector off =
                        *unprojector.worldAt(Method::Formula, corner) - *pick->point.world[Method::Formula];
                    for (int axis = 0; axis < 3; ++axis) // to first order
                        QVERIFY(std::abs(off[axis]) <= pick->withinPixel.world[axis] * 1.01);
                }
            }
        }
    }
};

UNPROJECTOR_TEST(TestPick)
#include "test_pick.moc"
