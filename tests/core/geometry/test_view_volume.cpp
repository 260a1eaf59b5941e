// The view volume's corners against literals, and the morph between eye space and the canonical
// view volume against its documented properties.

#include "tests/support/test.h"

#include "core/geometry/framing.h"
#include "core/geometry/numbers.h"
#include "core/geometry/observer_camera.h"
#include "core/geometry/view_volume.h"
#include "tests/support/is_near.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

using namespace unprojector;
using namespace unprojector::geometry;

namespace {

/// Numbers of size 1 to 100 after a few roundings.
constexpr double kRounding = 1e-12;

glm::dvec3 divided(const glm::dvec4 &p)
{
    return glm::dvec3(p) / p.w;
}

glm::dvec3 placeOf(const ViewVolumeMorph &morph, double t, const glm::dvec3 &eye)
{
    return divided(morphedFromEye(morph, t) * glm::dvec4(eye, 1.0));
}

ViewVolumeMorph morphOf(const Projection &projection)
{
    const Result<ViewVolumeMorph> morph = viewVolumeMorph(projection);
    if (!morph)
        qFatal("the projection is not valid");
    return *morph;
}

/// A point of the volume by its shares of width, height and depth.
glm::dvec3 inside(const std::array<EyePoint, 8> &c, double x, double y, double z)
{
    const auto mix = [](const glm::dvec3 &a, const glm::dvec3 &b, double s) { return a * (1.0 - s) + b * s; };
    const auto face = [&](std::size_t i) {
        return mix(mix(c[i].coordinates(), c[i + 1].coordinates(), x),
                   mix(c[i + 2].coordinates(), c[i + 3].coordinates(), x), y);
    };
    return mix(face(0), face(4), z);
}

const std::array<double, 9> kTimes{0.0, 1e-6, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0 - 1e-6, 1.0};
const std::array<double, 4> kShares{0.0, 0.3, 0.5, 1.0};

} // namespace

Q_DECLARE_METATYPE(unprojector::geometry::Projection)

class TestViewVolume : public QObject {
    Q_OBJECT

private slots:
    void cornersAreWhereTheArgumentsPutThem_data()
    {
        addColumn<Projection>("projection");
        addColumn<int>("index");
        addColumn<double>("x");
        addColumn<double>("y");
        addColumn<double>("z");
        const Projection frustum = Frustum{-0.25, 1.0, -0.75, 0.5, 2.0, 20.0};
        newRow("frustum, near left bottom") << frustum << 0 << -0.25 << -0.75 << -2.0;
        newRow("frustum, near right bottom") << frustum << 1 << 1.0 << -0.75 << -2.0;
        // x + y / 4 reaches the edges.
        const Projection skewed = Frustum{-1.0, 3.0, -2.0, 1.0, 2.0, 10.0, 0.25};
        newRow("skewed frustum, near left bottom") << skewed << 0 << -0.5 << -2.0 << -2.0;
        newRow("skewed frustum, far right top") << skewed << 7 << 13.75 << 5.0 << -10.0;
        newRow("frustum, far left top") << frustum << 6 << -2.5 << 5.0 << -20.0;
        newRow("frustum, far right top") << frustum << 7 << 10.0 << 5.0 << -20.0;
        const Projection perspective = Perspective{kPi / 2.0, 1.5, 1.0, 10.0};
        newRow("perspective, near right top") << perspective << 3 << 1.5 << 1.0 << -1.0;
        newRow("perspective, far left bottom") << perspective << 4 << -15.0 << -10.0 << -10.0;
        const Ortho box{-4.0, 8.0, -3.0, 5.0, -2.0, 40.0};
        newRow("ortho, near plane behind the eye") << Projection(box) << 2 << -4.0 << 5.0 << 2.0;
        newRow("ortho, far right bottom") << Projection(box) << 5 << 8.0 << -3.0 << -40.0;
        // cot(45 deg) = 1: one to the right for each unit of distance; y is not sheared.
        const Projection oblique = Oblique{box, kPi / 4.0, kPi / 2.0};
        newRow("oblique, near left bottom") << oblique << 0 << -6.0 << -3.0 << 2.0;
        newRow("oblique, far left bottom") << oblique << 4 << 36.0 << -3.0 << -40.0;
    }

    void cornersAreWhereTheArgumentsPutThem()
    {
        QFETCH(Projection, projection);
        QFETCH(int, index);
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, z);
        QVERIFY(isNear(viewVolumeCorners(projection)[static_cast<std::size_t>(index)].coordinates(), {x, y, z}, 1e-13));
    }

    void cornersLandOnTheCube_data() { addProjections(); }

    void cornersLandOnTheCube()
    {
        QFETCH(Projection, projection);
        const std::array<EyePoint, 8> corners = viewVolumeCorners(projection);
        const ViewVolumeMorph morph = morphOf(projection);
        for (std::size_t i = 0; i < 8; ++i) {
            // NDC by definition: right, top and far are +1. It is drawn backwards in z, and mirrored as
            // the window is.
            const glm::dvec3 ndc(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0);
            const ProjectionWindow w = projectionWindow(projection);
            const glm::dvec3 drawn(ndc.x * (w.right > w.left ? 1.0 : -1.0), ndc.y * (w.top > w.bottom ? 1.0 : -1.0),
                                   -ndc.z);
            QVERIFY(isNear(placeOf(morph, 1.0, corners[i].coordinates()), drawn, kRounding));
            QVERIFY(isNear(divided(morph.morphedFromNdc * glm::dvec4(ndc, 1.0)), drawn, 0.0));
        }
    }

    void itBeginsAsASimilarity_data() { addProjections(); }

    void itBeginsAsASimilarity()
    {
        QFETCH(Projection, projection);
        const std::array<EyePoint, 8> corners = viewVolumeCorners(projection);
        const ViewVolumeMorph morph = morphOf(projection);
        glm::dvec3 sum(0.0);
        for (std::size_t i = 0; i < 8; ++i) {
            const glm::dvec3 a = placeOf(morph, 0.0, corners[i].coordinates());
            sum += a;
            for (std::size_t j = 0; j < i; ++j) {
                const glm::dvec3 moved = a - placeOf(morph, 0.0, corners[j].coordinates());
                QVERIFY(isNear(moved, (corners[i].coordinates() - corners[j].coordinates()) * morph.scale, kRounding));
            }
        }
        QVERIFY(morph.scale > 0.0);
        QVERIFY(isNear(sum, glm::dvec3(0.0), 8.0 * kRounding));
    }

    void wStaysAboveZero_data() { addProjections(); }

    void wStaysAboveZero()
    {
        QFETCH(Projection, projection);
        const std::array<EyePoint, 8> corners = viewVolumeCorners(projection);
        const ViewVolumeMorph morph = morphOf(projection);
        for (const double t : kTimes) {
            for (const double x : kShares) {
                for (const double y : kShares) {
                    for (const double z : kShares)
                        QVERIFY((morphedFromEye(morph, t) * glm::dvec4(inside(corners, x, y, z), 1.0)).w > 0.0);
                }
            }
        }
    }

    void nothingTurnsInsideOut_data() { addProjections(); }

    void nothingTurnsInsideOut()
    {
        QFETCH(Projection, projection);
        const ViewVolumeMorph morph = morphOf(projection);
        for (int i = 0; i <= 1000; ++i)
            QVERIFY(glm::determinant(morphedFromEye(morph, i / 1000.0)) > 0.0);
    }

    void straightLinesStayStraight_data() { addProjections(); }

    void straightLinesStayStraight()
    {
        QFETCH(Projection, projection);
        const std::array<EyePoint, 8> corners = viewVolumeCorners(projection);
        const ViewVolumeMorph morph = morphOf(projection);
        for (const double t : kTimes) {
            // Along an edge in depth, a diagonal of the volume, and any line inside.
            for (const auto &[from, to] : {std::pair(corners[1].coordinates(), corners[5].coordinates()),
                                           std::pair(corners[0].coordinates(), corners[7].coordinates()),
                                           std::pair(inside(corners, 0.2, 0.9, 0.1), inside(corners, 0.7, 0.3, 0.8))}) {
                const glm::dvec3 a = placeOf(morph, t, from), b = placeOf(morph, t, to);
                for (const double s : {0.01, 0.3, 0.5, 0.9}) {
                    const glm::dvec3 p = placeOf(morph, t, from * (1.0 - s) + to * s);
                    QVERIFY(glm::length(glm::cross(p - a, b - a)) < kRounding * glm::dot(b - a, b - a) + kRounding);
                }
            }
        }
    }

    void depthKeepsItsOrder_data() { addProjections(); }

    void depthKeepsItsOrder()
    {
        QFETCH(Projection, projection);
        const std::array<EyePoint, 8> corners = viewVolumeCorners(projection);
        const ViewVolumeMorph morph = morphOf(projection);
        for (const double t : kTimes) {
            double before = placeOf(morph, t, inside(corners, 0.5, 0.5, 0.0)).z;
            for (int i = 1; i <= 100; ++i) {
                const double z = placeOf(morph, t, inside(corners, 0.5, 0.5, i / 100.0)).z;
                QVERIFY2(z < before,
                         qPrintable(QStringLiteral("t %1, step %2: %3 after %4").arg(t).arg(i).arg(z).arg(before)));
                before = z;
            }
        }
    }

    void nothingLeavesTheBall_data() { addProjections(); }

    void nothingLeavesTheBall()
    {
        QFETCH(Projection, projection);
        const std::array<EyePoint, 8> corners = viewVolumeCorners(projection);
        const ViewVolumeMorph morph = morphOf(projection);
        for (const double t : kTimes) {
            for (const EyePoint &corner : corners)
                QVERIFY(glm::length(placeOf(morph, t, corner.coordinates())) <= std::sqrt(3.0) + kRounding);
        }
    }

    void thePlanesHoldAllThenTheVolume_data() { addProjections(); }

    void thePlanesHoldAllThenTheVolume()
    {
        QFETCH(Projection, projection);
        const std::array<EyePoint, 8> corners = viewVolumeCorners(projection);
        const ViewVolumeMorph morph = morphOf(projection);
        const auto holds = [&morph](double t, const glm::dvec3 &p, double tolerance) {
            for (const glm::dvec4 &plane : closingPlanes(morph, t)) {
                if (glm::dot(plane, glm::dvec4(p, 1.0)) < -tolerance * morph.weight)
                    return false;
            }
            return true;
        };
        const double size = glm::length(corners[7].coordinates() - corners[0].coordinates());
        for (const double t : kTimes) {
            for (const EyePoint &corner : corners)
                QVERIFY(holds(t, corner.coordinates(), 1e-10));
            // Any point inside can be drawn, wherever it lies.
            for (int i = 0; i < 2000; ++i) {
                const glm::dvec3 p =
                    size * glm::dvec3(std::sin(i * 1.1), std::sin(i * 1.7 + 1.0), std::sin(i * 2.3 + 2.0));
                if (holds(t, p, 0.0))
                    QVERIFY((morphedFromEye(morph, t) * glm::dvec4(p, 1.0)).w > 0.0);
                if (t == 0.0)
                    QVERIFY(holds(t, p, 0.0));
            }
        }
        // A point just outside a face at the end of the morph is outside.
        const std::array<glm::dvec3, 6> beyond{inside(corners, 0.5, 0.5, -1e-7), inside(corners, -0.01, 0.5, 0.5),
                                               inside(corners, 1.01, 0.5, 0.5),  inside(corners, 0.5, -0.01, 0.5),
                                               inside(corners, 0.5, 1.01, 0.5),  inside(corners, 0.5, 0.5, 1.01)};
        for (std::size_t i = 0; i < 6; ++i) {
            const std::array<glm::dvec4, 6> planes = closingPlanes(morph, 1.0);
            for (std::size_t j = 0; j < 6; ++j)
                QCOMPARE(glm::dot(planes[j], glm::dvec4(beyond[i], 1.0)) < 0.0, i == j);
        }
    }

    void aSegmentIsCutAtThePlanes()
    {
        const std::array<glm::dvec4, 2> planes{glm::dvec4(1.0, 0.0, 0.0, 0.0),
                                               glm::dvec4(-1.0, 0.0, 0.0, 2.0)}; // 0 <= x <= 2
        const std::optional<Segment> cut = clipped(Segment{{-1.0, 0.0, 0.0}, {3.0, 4.0, 0.0}}, planes);
        QVERIFY(cut.has_value());
        QVERIFY(isNear(cut->from, {0.0, 1.0, 0.0}, kRounding));
        QVERIFY(isNear(cut->to, {2.0, 3.0, 0.0}, kRounding));
        const std::optional<Segment> whole = clipped(Segment{{0.0, 5.0, 0.0}, {2.0, 5.0, 0.0}}, planes);
        QVERIFY(whole && isNear(whole->from, {0.0, 5.0, 0.0}, 0.0) && isNear(whole->to, {2.0, 5.0, 0.0}, 0.0));
        QVERIFY(!clipped(Segment{{-3.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}}, planes));
        QVERIFY(!clipped(Segment{{3.0, 0.0, 0.0}, {4.0, 0.0, 0.0}}, planes));
    }

    void anInvalidProjectionHasNoMorph()
    {
        const Result<ViewVolumeMorph> morph = viewVolumeMorph(Frustum{-1.0, 1.0, -1.0, 1.0, 0.0, 10.0});
        QVERIFY(!morph);
        QVERIFY(morph.error().code == ErrorCode::NearNotPositive);
    }

    void theUnitBallStandsWhereTheVolumeIs()
    {
        const Projection projection = Frustum{-0.2, 1.0, -0.7, 0.1, 1.0, 100.0};
        const ViewVolumeMorph morph = morphOf(projection);
        const EyeFrame frame = *eyeFrame({WorldPoint(5.0, 6.0, 9.0), WorldPoint(1.0, 2.0, 3.0), {0.0, 1.0, 0.0}});
        const glm::dmat4 drawn = matrixOf(placementOf(frame, morph)) * morphedFromEye(morph, 0.0) * eyeFromWorld(frame);
        const glm::dvec3 point(-3.0, 7.0, 11.0);
        QVERIFY(isNear(divided(drawn * glm::dvec4(point, 1.0)), point, 1e-10));

        const Placement start = placementOf(frame, morph);
        const Placement end{{1.0, 2.0, 3.0}, {1.0, 0.0, 0.0, 0.0}, 4.0 * start.scale};
        QVERIFY(isNear(between(start, end, 0.0).position, start.position, 0.0));
        QVERIFY(isNear(between(start, end, 1.0).position, end.position, 0.0));
        QVERIFY(std::abs(between(start, end, 0.5).scale / start.scale - 2.0) < kRounding);
    }

    void theObserverSeesEverythingItIsToFrame()
    {
        const Projection watched = Frustum{-0.2, 1.0, -0.7, 0.1, 1.0, 100.0};
        for (const LookAt &camera : {LookAt{WorldPoint(5.0, 6.0, 9.0), WorldPoint(1.0, 2.0, 3.0), {0.0, 1.0, 0.0}},
                                     LookAt{WorldPoint(5.0, 6.0, 9.0), WorldPoint(5.0, 2.0, 9.0), {0.0, 0.0, -1.0}},
                                     LookAt{WorldPoint(5.0, 6.0, 9.0), WorldPoint(5.003, 2.0, 9.0), {1.0, 0.0, 0.0}}}) {
            const EyeFrame frame = *eyeFrame(camera);
            std::vector<WorldPoint> points{frame.eye};
            for (const EyePoint &corner : viewVolumeCorners(watched))
                points.push_back(worldFromEye(frame, corner));
            Setup observer{{300, 400, 1.0},
                           {0.0, 0.0, 300.0, 400.0},
                           {},
                           Perspective{0.6, 0.75, 0.1, 1e4},
                           observerOf(frame, frame.eye)};
            Framing framing(observer);
            for (const WorldPoint &point : points)
                framing.add(point);
            observer.camera() = framing.setup().camera();
            QVERIFY(check(observer).hasValue());
            const EyeFrame from = *eyeFrame(observer.camera());
            QVERIFY(std::abs(std::asin(-from.forward.y) * 180.0 / kPi - 35.0) < 1e-9);
            double left = 300.0, right = 0.0, bottom = 400.0, top = 0.0;
            for (const WorldPoint &point : points) {
                const Result<WindowPoint> place = windowFromWorld(observer, point);
                QVERIFY(place && -eyeFromWorld(from, point).z > 0.0);
                left = std::min(left, place->x);
                right = std::max(right, place->x);
                bottom = std::min(bottom, place->y);
                top = std::max(top, place->y);
            }
            QVERIFY(left > 0.0 && right < 300.0 && bottom > 0.0 && top < 400.0);
            QVERIFY(right - left > 300.0 * 0.85 || top - bottom > 400.0 * 0.85);
        }
    }

    void aDraggedPlaneFollowsThePointer_data()
    {
        addColumn<Projection>("projection");
        addColumn<int>("corner");
        addColumn<double>("wanted");
        newRow("frustum, near closer") << Projection(Frustum{-0.2, 1.0, -0.7, 0.1, 2.0, 10.0}) << 3 << 1.5;
        newRow("frustum, near deeper") << Projection(Frustum{-0.2, 1.0, -0.7, 0.1, 2.0, 10.0}) << 0 << 4.0;
        newRow("perspective, far deeper") << Projection(Perspective{0.8, 1.5, 2.0, 10.0}) << 6 << 12.0;
        newRow("ortho, near to behind the eye") << Projection(Ortho{-3.0, 3.0, -2.0, 2.0, 1.0, 10.0}) << 1 << -2.0;
        newRow("oblique, far closer") << Projection(Oblique{{-3.0, 3.0, -2.0, 2.0, 1.0, 10.0}, kPi / 3.0, kPi / 4.0})
                                      << 5 << 8.0;
    }

    void aDraggedPlaneFollowsThePointer()
    {
        QFETCH(Projection, projection);
        QFETCH(int, corner);
        QFETCH(double, wanted);
        const auto index = static_cast<std::size_t>(corner);
        // An observer at the side, at (20, 8, 5) in eye space, whose picture is 1000 pixels a side.
        const EyeFrame from = *eyeFrame({WorldPoint(20.0, 8.0, 5.0), WorldPoint(0.0, 0.0, -5.0), {0.0, 1.0, 0.0}});
        glm::dmat4 pixels(1.0);
        pixels[0][0] = 500.0;
        pixels[1][1] = -500.0;
        pixels[3] = {500.0, 500.0, 0.0, 1.0};
        const glm::dmat4 widgetFromEye = pixels * *clipFromEye(Perspective{0.8, 1.0, 0.1, 1000.0}) * eyeFromWorld(from);
        const auto pixelOf = [&](const EyePoint &p) {
            return glm::dvec2(divided(widgetFromEye * glm::dvec4(p.coordinates(), 1.0)));
        };

        const bool movesFar = corner & 4;
        const ProjectionWindow w = projectionWindow(projection);
        const Projection target =
            withClipDistances(projection, movesFar ? w.nearDistance : wanted, movesFar ? wanted : w.farDistance);
        const EyePoint grabbed = viewVolumeCorners(projection)[index];
        // The drag starts a few pixels beside the corner and keeps that offset.
        const glm::dvec2 beside(3.0, -2.0);
        const ClipPlaneDrag drag(projection, movesFar ? ClipPlane::Far : ClipPlane::Near, grabbed, widgetFromEye,
                                 pixelOf(grabbed) + beside);
        const std::optional<double> distance = drag.distanceAt(pixelOf(viewVolumeCorners(target)[index]) + beside);
        QVERIFY(distance.has_value());
        QVERIFY2(std::abs(*distance - wanted) < 1e-9, qPrintable(QString::number(*distance, 'g', 17)));
        const std::optional<Projection> dragged =
            drag.projectionAt(projection, pixelOf(viewVolumeCorners(target)[index]) + beside);
        QVERIFY(dragged
                && *dragged
                       == withClipDistances(projection, movesFar ? w.nearDistance : *distance,
                                            movesFar ? *distance : w.farDistance));
    }

    void aDraggedPlaneStaysValid()
    {
        const EyeFrame from = *eyeFrame({WorldPoint(20.0, 8.0, 5.0), WorldPoint(0.0, 0.0, -5.0), {0.0, 1.0, 0.0}});
        const glm::dmat4 widgetFromEye = *clipFromEye(Perspective{0.8, 1.0, 0.1, 1000.0}) * eyeFromWorld(from);
        for (const Projection &projection :
             {Projection(Perspective{0.8, 1.5, 2.0, 10.0}), Projection(Ortho{-3.0, 3.0, -2.0, 2.0, 1.0, 10.0})}) {
            const std::array<EyePoint, 8> corners = viewVolumeCorners(projection);
            for (const ClipPlane plane : {ClipPlane::Near, ClipPlane::Far}) {
                const EyePoint grabbed = corners[plane == ClipPlane::Near ? 3 : 7];
                const ClipPlaneDrag drag(projection, plane, grabbed, widgetFromEye, glm::dvec2(0.0));
                int answers = 0;
                for (int i = -200; i <= 200; ++i) {
                    const std::optional<Projection> next =
                        drag.projectionAt(projection, glm::dvec2(i * 0.05, i * 0.03));
                    if (!next)
                        continue;
                    ++answers;
                    QVERIFY(check(*next).hasValue());
                }
                QVERIFY(answers > 50);
            }
        }
    }

private:
    static void addProjections()
    {
        addColumn<Projection>("projection");
        const Ortho box{-4.0, 8.0, -3.0, 5.0, 2.0, 40.0};
        newRow("frustum, off-centre") << Projection(Frustum{-0.2, 1.0, -0.7, 0.1, 1.0, 100.0});
        newRow("frustum, skewed") << Projection(Frustum{-0.2, 1.0, -0.7, 0.1, 1.0, 100.0, 0.3});
        newRow("frustum, mirrored") << Projection(Frustum{0.6, -0.6, 0.4, -0.4, 1.0, 100.0});
        newRow("frustum, window beside the axis") << Projection(Frustum{0.5, 1.0, 0.5, 1.0, 1.0, 20.0});
        newRow("perspective") << Projection(Perspective{kPi / 4.0, 1.5, 5.0, 25.0});
        newRow("perspective, near at the eye") << Projection(Perspective{kPi / 3.0, 1.5, 0.001, 1000.0});
        newRow("ortho") << Projection(box);
        newRow("ortho, begins behind the eye") << Projection(Ortho{-1.0, 1.0, -1.0, 1.0, -10.0, 10.0});
        newRow("oblique") << Projection(Oblique{box, kPi / 3.0, 2.0 * kPi / 3.0});
    }
};

UNPROJECTOR_TEST(TestViewVolume)
#include "test_view_volume.moc"
