// Camera motions by hand, judged by the window positions of points before and after.
// windowFromWorld, which has tests of its own, computes these; the motion's own terms don't.

#include "tests/support/test.h"

#include "core/geometry/camera_motion.h"
#include "core/geometry/numbers.h"
#include "tests/support/is_near.h"

#include <glm/geometric.hpp>

#include <cmath>

using namespace unprojector;
using namespace unprojector::geometry;

namespace {

/// Window positions up to 1000, after some dozens of roundings.
constexpr double kRoundingPixels = 1e-8;
constexpr double kRounding = 1e-12;

/// The window position of a point; NaN if it has none.
glm::dvec2 placeOf(const Setup &g, const WorldPoint &point)
{
    const Result<WindowPoint> window = windowFromWorld(g, point);
    return window ? glm::dvec2(window->x, window->y) : glm::dvec2(std::nan(""));
}

bool hasSamePlace(const Setup &before, const Setup &after, const WorldPoint &point)
{
    const glm::dvec2 a = placeOf(before, point), b = placeOf(after, point);
    return isNear(a.x, b.x, kRoundingPixels) && isNear(a.y, b.y, kRoundingPixels);
}

double distanceOf(const LookAt &camera)
{
    return glm::length(camera.center.coordinates() - camera.eye.coordinates());
}

glm::dvec3 forwardOf(const LookAt &camera)
{
    return glm::normalize(camera.center.coordinates() - camera.eye.coordinates());
}

/// The angle of the view direction above the horizon.
double elevationOf(const LookAt &camera)
{
    return std::asin(forwardOf(camera).y);
}

Setup withCamera(Setup g, const LookAt &camera)
{
    g.camera() = camera;
    return g;
}

/// A camera off every axis, with a point of interest at (1, 2, 3).
LookAt obliqueCamera()
{
    return {WorldPoint(5.0, 6.0, 9.0), WorldPoint(1.0, 2.0, 3.0), {0.0, 1.0, 0.0}};
}

Setup geometryWith(const Projection &projection)
{
    return {{1200, 800, 1.5}, {0.0, 0.0, 1200.0, 800.0}, {}, projection, obliqueCamera()};
}

void addProjections()
{
    addColumn<Setup>("geometry");
    const Ortho box{-4.0, 8.0, -3.0, 5.0, -2.0, 40.0};
    newRow("frustum") << geometryWith(Frustum{-0.6, 0.6, -0.4, 0.4, 1.0, 100.0});
    newRow("frustum, off-centre") << geometryWith(Frustum{-0.2, 1.0, -0.7, 0.1, 1.0, 100.0});
    newRow("perspective") << geometryWith(Perspective{kPi / 4.0, 1.5, 0.1, 100.0});
    newRow("ortho") << geometryWith(Ortho{-6.0, 6.0, -4.0, 4.0, -2.0, 40.0});
    newRow("ortho, off-centre") << geometryWith(box);
    newRow("oblique") << geometryWith(Oblique{box, kPi / 3.0, 2.0 * kPi / 3.0});
    Setup offset = geometryWith(Frustum{-0.2, 1.0, -0.7, 0.1, 1.0, 100.0});
    offset.viewport = {100.0, 50.0, 600.0, 400.0};
    newRow("frustum, off-centre, in an offset viewport") << offset;
}

/// A box that the oblique camera looks at, its eight corners.
Box someBounds()
{
    Box box;
    box.add(glm::dvec3(-1.0, 0.5, 2.0));
    box.add(glm::dvec3(3.0, 2.5, 5.0));
    return box;
}

std::vector<WorldPoint> cornersOf(const Box &box)
{
    std::vector<WorldPoint> corners;
    for (const double x : {box.lowest.x, box.highest.x}) {
        for (const double y : {box.lowest.y, box.highest.y}) {
            for (const double z : {box.lowest.z, box.highest.z})
                corners.push_back(WorldPoint(x, y, z));
        }
    }
    return corners;
}

} // namespace

class TestCameraMotion : public QObject {
    Q_OBJECT

private slots:
    void orbitKeepsThePivotsPlaceAndAllDistances_data() { addProjections(); }

    void orbitKeepsThePivotsPlaceAndAllDistances()
    {
        QFETCH(Setup, geometry);
        for (const WorldPoint &pivot :
             {WorldPoint(1.0, 2.0, 3.0), WorldPoint(0.0, 1.0, 2.5), WorldPoint(2.0, 0.0, 4.0)}) {
            for (const double yaw : {-2.0, 0.0, 0.3, 3.0}) {
                for (const double pitch : {-0.4, 0.0, 0.5}) {
                    const LookAt camera = orbited(geometry.camera(), pivot, yaw, pitch);
                    const Setup after = withCamera(geometry, camera);
                    QVERIFY(check(after).hasValue());
                    QVERIFY(hasSamePlace(geometry, after, pivot));
                    QVERIFY(isNear(distanceOf(camera), distanceOf(geometry.camera()), kRounding * 10.0));
                    QVERIFY(isNear(glm::length(camera.eye.coordinates() - pivot.coordinates()),
                                   glm::length(geometry.camera().eye.coordinates() - pivot.coordinates()),
                                   kRounding * 10.0));
                }
            }
        }
        const LookAt same = orbited(geometry.camera(), WorldPoint(0.0, 1.0, 2.5), 0.0, 0.0);
        QVERIFY(isNear(same.eye.coordinates(), geometry.camera().eye.coordinates(), kRounding));
        QVERIFY(isNear(same.center.coordinates(), geometry.camera().center.coordinates(), kRounding * 10.0));
    }

    void orbitTurnsTheSceneWithTheHand()
    {
        const Setup g{{800, 800, 1.0},
                      {0.0, 0.0, 800.0, 800.0},
                      {},
                      Frustum{-1.0, 1.0, -1.0, 1.0, 1.0, 100.0},
                      LookAt{WorldPoint(0.0, 0.0, 10.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}}};
        const WorldPoint pivot(0.0, 0.0, 0.0);
        const WorldPoint nearest(0.0, 0.0, 1.0), top(0.0, 1.0, 0.0);
        // A turn to the right: the nearest point moves right by the sine of the angle, 1 x sin 0.1 at a
        // distance of 10 - cos 0.1.
        const Setup right = withCamera(g, orbited(g.camera(), pivot, 0.1, 0.0));
        QVERIFY(
            isNear(placeOf(right, nearest).x, 400.0 + 400.0 * std::sin(0.1) / (10.0 - std::cos(0.1)), kRoundingPixels));
        QVERIFY(isNear(placeOf(right, nearest).y, 400.0, kRoundingPixels));
        // Down: the top comes towards the viewer, so the nearest point sinks.
        const Setup down = withCamera(g, orbited(g.camera(), pivot, 0.0, 0.1));
        QVERIFY(
            isNear(placeOf(down, nearest).y, 400.0 - 400.0 * std::sin(0.1) / (10.0 - std::cos(0.1)), kRoundingPixels));
        QVERIFY(isNear(placeOf(down, nearest).x, 400.0, kRoundingPixels));
        QVERIFY(isNear(placeOf(down, top).y, 400.0 + 400.0 * std::cos(0.1) / (10.0 - std::sin(0.1)), kRoundingPixels));
        QVERIFY(isNear(down.camera().eye.coordinates(), {0.0, 10.0 * std::sin(0.1), 10.0 * std::cos(0.1)},
                       kRounding * 10.0));
    }

    void orbitStopsShortOfThePoles_data()
    {
        addColumn<double>("pitch");
        addColumn<double>("elevation");
        constexpr double kLimit = kPi / 2.0 - 0.01;
        newRow("over the top") << 5.0 << -kLimit;
        newRow("a quarter turn") << kPi / 2.0 << -kLimit;
        newRow("under the bottom") << -5.0 << kLimit;
        newRow("to the horizon and back") << 0.0 << std::asin(-4.0 / std::sqrt(68.0));
    }

    void orbitStopsShortOfThePoles()
    {
        QFETCH(double, pitch);
        QFETCH(double, elevation);
        const LookAt camera = orbited(obliqueCamera(), WorldPoint(1.0, 2.0, 3.0), 0.7, pitch);
        QVERIFY(isNear(elevationOf(camera), elevation, 1e-9));
        QVERIFY(eyeFrame(camera).hasValue());
        QVERIFY(eyeFrame(camera).value().upward.y > 0.0);
        // Pulling on changes nothing, and the way back is open at once.
        const LookAt further = orbited(camera, WorldPoint(1.0, 2.0, 3.0), 0.0, pitch);
        QVERIFY(isNear(elevationOf(further), elevation, 1e-9));
        const double back = pitch > 0.0 ? -0.2 : 0.2;
        QVERIFY(isNear(elevationOf(orbited(camera, WorldPoint(1.0, 2.0, 3.0), 0.0, back)), elevation - back, 1e-9));
    }

    void orbitLeavesAPoleItStandsAt_data()
    {
        addColumn<int>("side");
        addColumn<double>("pitch");
        addColumn<double>("elevation");
        newRow("from the top, on") << static_cast<int>(StandardView::Top) << 0.3 << -kPi / 2.0;
        newRow("from the top, back") << static_cast<int>(StandardView::Top) << -0.3 << -kPi / 2.0 + 0.3;
        newRow("from the bottom, on") << static_cast<int>(StandardView::Bottom) << -0.3 << kPi / 2.0;
        newRow("from the bottom, back") << static_cast<int>(StandardView::Bottom) << 0.3 << kPi / 2.0 - 0.3;
    }

    void orbitLeavesAPoleItStandsAt()
    {
        QFETCH(int, side);
        QFETCH(double, pitch);
        QFETCH(double, elevation);
        const LookAt pole = seenFrom(obliqueCamera(), static_cast<StandardView>(side));
        const Setup before = withCamera(geometryWith(Frustum{-0.2, 1.0, -0.7, 0.1, 1.0, 100.0}), pole);
        const WorldPoint pivot(0.5, 2.5, 2.0);
        const LookAt camera = orbited(pole, pivot, 0.4, pitch);
        QVERIFY(hasSamePlace(before, withCamera(before, camera), pivot));
        // asin is flat at the poles: a rounding of 1e-16 in the sine is 1e-8 in the angle.
        QVERIFY(isNear(elevationOf(camera), elevation, 1e-7));
    }

    void manyOrbitsStayLevel()
    {
        LookAt camera = obliqueCamera();
        const WorldPoint pivot(0.5, 2.5, 2.0);
        const double distance = distanceOf(camera);
        for (int step = 0; step < 2000; ++step)
            camera = orbited(camera, pivot, 0.01, step % 400 < 200 ? 0.01 : -0.01);
        const Result<EyeFrame> frame = eyeFrame(camera);
        QVERIFY(frame.hasValue());
        QVERIFY(isNear(frame->side.y, 0.0, 1e-9));
        QVERIFY(isNear(distanceOf(camera), distance, 1e-9));
        QVERIFY(isNear(camera.up.coordinates(), {0.0, 1.0, 0.0}, 0.0));
    }

    void movedShiftsEyeAndCenter()
    {
        const LookAt camera = moved(obliqueCamera(), {1.0, -2.0, 0.5});
        QVERIFY(isNear(camera.eye.coordinates(), {6.0, 4.0, 9.5}, 0.0));
        QVERIFY(isNear(camera.center.coordinates(), {2.0, 0.0, 3.5}, 0.0));
        QVERIFY(isNear(camera.up.coordinates(), {0.0, 1.0, 0.0}, 0.0));
    }

    void seenFromLooksAlongTheNamedAxis_data()
    {
        addColumn<int>("side");
        addColumn<glm::dvec3>("eye");
        addColumn<glm::dvec3>("rightInPicture");
        addColumn<glm::dvec3>("upInPicture");
        const auto row = [](const char *name, StandardView side, const glm::dvec3 &eye, const glm::dvec3 &right,
                            const glm::dvec3 &up) { newRow(name) << static_cast<int>(side) << eye << right << up; };
        // The centre (1, 2, 3) at a distance of 10.
        row("front", StandardView::Front, {1.0, 2.0, 13.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
        row("back", StandardView::Back, {1.0, 2.0, -7.0}, {-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
        row("right", StandardView::Right, {11.0, 2.0, 3.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0});
        row("left", StandardView::Left, {-9.0, 2.0, 3.0}, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0});
        row("top", StandardView::Top, {1.0, 12.0, 3.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0});
        row("bottom", StandardView::Bottom, {1.0, -8.0, 3.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
    }

    void seenFromLooksAlongTheNamedAxis()
    {
        QFETCH(int, side);
        QFETCH(glm::dvec3, eye);
        QFETCH(glm::dvec3, rightInPicture);
        QFETCH(glm::dvec3, upInPicture);
        const LookAt before{WorldPoint(1.0, 8.0, 11.0), WorldPoint(1.0, 2.0, 3.0), {0.0, 1.0, 0.0}}; // 10 away
        const LookAt camera = seenFrom(before, static_cast<StandardView>(side));
        QVERIFY(isNear(camera.center.coordinates(), {1.0, 2.0, 3.0}, 0.0));
        QVERIFY(isNear(camera.eye.coordinates(), eye, kRounding));
        const Result<EyeFrame> frame = eyeFrame(camera);
        QVERIFY(frame.hasValue());
        QVERIFY(isNear(frame->side.coordinates(), rightInPicture, kRounding));
        QVERIFY(isNear(frame->upward.coordinates(), upInPicture, kRounding));
    }

    void worldPerLogicalPixelMovesByOnePixel_data() { addProjections(); }

    void worldPerLogicalPixelMovesByOnePixel()
    {
        QFETCH(Setup, geometry);
        geometry.surface.devicePixelRatio = 1.5;
        const EyeFrame frame = *eyeFrame(geometry.camera());
        for (const WorldPoint &anchor : {WorldPoint(1.0, 2.0, 3.0), WorldPoint(-2.0, 1.0, -4.0)}) {
            const double scale = worldPerLogicalPixel(geometry, anchor);
            const Setup after =
                withCamera(geometry, moved(geometry.camera(), -(frame.side * 30.0 - frame.upward * 20.0) * scale));
            const glm::dvec2 step = placeOf(after, anchor) - placeOf(geometry, anchor);
            QVERIFY(isNear(step.x, 45.0, kRoundingPixels));
            QVERIFY(isNear(step.y, -30.0, kRoundingPixels));
        }
    }

    void zoomKeepsTheAnchorsPlace_data() { addProjections(); }

    void zoomKeepsTheAnchorsPlace()
    {
        QFETCH(Setup, geometry);
        for (const WorldPoint &anchor :
             {WorldPoint(1.0, 2.0, 3.0), WorldPoint(0.0, 3.0, 1.0), WorldPoint(2.0, 0.5, 4.0)}) {
            for (const double factor : {0.5, 1.0, 1.2, 8.0}) {
                const Setup after = zoomed(geometry, anchor, factor);
                QVERIFY(check(after).hasValue());
                QVERIFY(hasSamePlace(geometry, after, anchor));
                QVERIFY(isNear(forwardOf(after.camera()), forwardOf(geometry.camera()), kRounding));
                // Closer by the factor: something near the anchor, at its depth, appears that much
                // farther from it.
                const EyeFrame frame = *eyeFrame(geometry.camera());
                const WorldPoint beside = anchor + 0.1 * frame.side + 0.2 * frame.upward;
                const glm::dvec2 was = placeOf(geometry, beside) - placeOf(geometry, anchor);
                const glm::dvec2 is = placeOf(after, beside) - placeOf(after, anchor);
                QVERIFY(isNear(is.x, was.x * factor, kRoundingPixels * 10.0));
                QVERIFY(isNear(is.y, was.y * factor, kRoundingPixels * 10.0));
                if (isPerspective(geometry.projection())) {
                    const double depth = -eyeFromWorld(*eyeFrame(after.camera()), anchor).z;
                    QVERIFY(isNear(distanceOf(after.camera()), depth, kRounding * 100.0));
                }
            }
        }
    }

    void recenteredBringsThePointToTheMiddle_data() { addProjections(); }

    void recenteredBringsThePointToTheMiddle()
    {
        QFETCH(Setup, geometry);
        for (const WorldPoint &point :
             {WorldPoint(1.0, 2.0, 3.0), WorldPoint(0.0, 3.0, 1.0), WorldPoint(-7.0, 0.5, -4.0)}) {
            const Setup after = withCamera(geometry, recentered(geometry, point));
            const glm::dvec2 place = placeOf(after, point);
            QVERIFY(isNear(place.x, geometry.viewport.x + geometry.viewport.width / 2.0, kRoundingPixels));
            QVERIFY(isNear(place.y, geometry.viewport.y + geometry.viewport.height / 2.0, kRoundingPixels));
            // Sideways only: the point's depth stays, and the centre is at that depth.
            const double before = -eyeFromWorld(*eyeFrame(geometry.camera()), point).z;
            QVERIFY(isNear(-eyeFromWorld(*eyeFrame(after.camera()), point).z, before, kRounding * 100.0));
            QVERIFY(isNear(distanceOf(after.camera()), before, kRounding * 100.0));
        }
    }

    void fittedClipDistancesHoldTheBox_data() { addProjections(); }

    void fittedClipDistancesHoldTheBox()
    {
        QFETCH(Setup, geometry);
        const Box bounds = someBounds();
        Box ground;
        ground.add(glm::dvec3(-20.0, 0.5, -20.0));
        ground.add(glm::dvec3(20.0, 0.5, 5.0));
        const ProjectionWindow tight = projectionWindow(withFittedClipDistances(geometry, bounds, {}));
        const ProjectionWindow wide = projectionWindow(withFittedClipDistances(geometry, bounds, ground));
        const EyeFrame frame = *eyeFrame(geometry.camera());
        double nearest = 1e9, farthest = -1e9, farthestGround = -1e9;
        for (const WorldPoint &corner : cornersOf(bounds)) {
            nearest = std::min(nearest, -eyeFromWorld(frame, corner).z);
            farthest = std::max(farthest, -eyeFromWorld(frame, corner).z);
        }
        for (const WorldPoint &corner : cornersOf(ground))
            farthestGround = std::max(farthestGround, -eyeFromWorld(frame, corner).z);
        QVERIFY(tight.nearDistance < nearest);
        QVERIFY(tight.farDistance > farthest);
        // Tightly: at most a tenth of the box is wasted on each side.
        const double slack = bounds.diagonal() * 0.1;
        QVERIFY(tight.nearDistance > nearest - slack);
        QVERIFY(tight.farDistance < farthest + slack);
        // Things that are only drawn move the far plane, not the near one.
        QCOMPARE(wide.nearDistance, tight.nearDistance);
        QVERIFY(wide.farDistance > farthestGround);

        // The picture stays: each corner keeps its place, and its depth lies in the range.
        Setup after = geometry;
        after.projection() = withFittedClipDistances(geometry, bounds, ground);
        for (const WorldPoint &corner : cornersOf(bounds)) {
            QVERIFY(hasSamePlace(geometry, after, corner));
            const Result<WindowPoint> window = windowFromWorld(after, corner);
            QVERIFY(window->z > 0.0 && window->z < 1.0);
        }
    }

    void clipDistancesOfAnEmptyBoxStay_data() { addProjections(); }

    void clipDistancesOfAnEmptyBoxStay()
    {
        QFETCH(Setup, geometry);
        QVERIFY(withFittedClipDistances(geometry, {}, someBounds()) == geometry.projection());
    }

    void anEyeInsideTheBoxKeepsAValidFrustum()
    {
        Setup g = geometryWith(Frustum{-0.6, 0.6, -0.4, 0.4, 1.0, 100.0});
        g.camera() = {WorldPoint(1.0, 1.5, 3.5), WorldPoint(1.0, 1.5, 2.5), {0.0, 1.0, 0.0}};
        const ProjectionWindow w = projectionWindow(withFittedClipDistances(g, someBounds(), {}));
        QVERIFY(isNear(w.nearDistance, 0.01, kRounding)); // 1% of the centre's distance
        QVERIFY(w.farDistance > 1.5);
        // All of the box behind the eye: still a valid frustum.
        g.camera() = {WorldPoint(1.0, 1.5, -10.0), WorldPoint(1.0, 1.5, -11.0), {0.0, 1.0, 0.0}};
        QVERIFY(check(withFittedClipDistances(g, someBounds(), {})).hasValue());
    }

    void theSwitchedProjectionKeepsThePictureAtTheCenter_data() { addProjections(); }

    void theSwitchedProjectionKeepsThePictureAtTheCenter()
    {
        QFETCH(Setup, geometry);
        const EyeFrame frame = *eyeFrame(geometry.camera());
        const double distance = distanceOf(geometry.camera());
        for (const ProjectionKind kind : {ProjectionKind::Frustum, ProjectionKind::Ortho, ProjectionKind::Oblique}) {
            Setup other = geometry;
            other.projection() = converted(geometry.projection(), kind, distance);
            QVERIFY(kindOf(other.projection()) == kind);
            QVERIFY(check(other).hasValue());
            Setup back = geometry;
            back.projection() = converted(
                other.projection(),
                isPerspective(geometry.projection()) ? ProjectionKind::Frustum : ProjectionKind::Ortho, distance);
            QVERIFY(check(back).hasValue());
            for (const double x : {-2.0, 0.0, 1.5}) {
                for (const double y : {-1.0, 0.0, 2.5}) {
                    const WorldPoint point = geometry.camera().center + x * frame.side + y * frame.upward;
                    QVERIFY(hasSamePlace(geometry, other, point));
                    QVERIFY(hasSamePlace(geometry, back, point));
                }
            }
        }
    }
};

UNPROJECTOR_TEST(TestCameraMotion)
#include "test_camera_motion.moc"
