// The uncertainty of a click's point: every source of error by itself, then all of them against
// rasterisers. The rasterisers are computed here in single precision, with every depth format, with
// corners on a grid and without.

#include "tests/support/test.h"

#include "core/geometry/proportions.h"
#include "tests/support/inside_share.h"
#include "tests/support/is_near.h"
#include "tests/support/unprojecting.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <random>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::unproject;

namespace {

using Triangle = std::array<glm::dvec3, 3>;

/// 800 x 600 device pixels, looked at from (4, 3, 7).
Setup setupOf(const Projection &projection, const DepthRange &range)
{
    return {{800, 600, 1.0},
            {0.0, 0.0, 800.0, 600.0},
            range,
            projection,
            LookAt{WorldPoint(4.0, 3.0, 7.0), WorldPoint(0.3, 0.2, 0.1), {0.1, 1.0, 0.2}}};
}

const Projection kFrustum = Frustum{-0.8, 0.8, -0.6, 0.6, 1.0, 20.0};
const Projection kOffCenter = Frustum{-0.2, 1.4, -0.9, 0.3, 1.0, 20.0};
const Projection kBox = Ortho{-4.0, 4.0, -3.0, 3.0, 1.0, 20.0};
const Projection kOblique =
    Oblique{{-4.0, 4.0, -3.0, 3.0, 1.0, 20.0}, radiansFromDegrees(50.0), radiansFromDegrees(110.0)};

/// A model of how a GPU might draw.
struct Rasteriser {
    DepthFormat format;
    bool isOnGrid = false;      ///< corners are moved to 1/256 of a pixel before depths are interpolated
    bool isBarycentric = false; ///< as graphics cards do; else by a plane through the framebuffer's corner

    struct Drawn {
        double depth;
        bool covers; ///< the pixel's centre
    };

    /// The depth at a position of a triangle whose vertices the matrix transforms in single
    /// precision.
    Drawn depthAt(const Setup &setup, const glm::mat4 &clipFromVertices, const Triangle &vertices,
                  const glm::dvec2 &place) const
    {
        const auto &[atNear, atFar] = setup.depthRange;
        const float halfWidth = float(setup.viewport.width / 2.0), halfHeight = float(setup.viewport.height / 2.0);
        const float halfRange = float(atFar - atNear) / 2.0f, middle = float(atNear + atFar) / 2.0f;
        std::array<glm::vec3, 3> w;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec4 clip = clipFromVertices * glm::vec4(glm::vec3(vertices[k]), 1.0f);
            const glm::vec3 ndc = glm::vec3(clip) * (1.0f / clip.w);
            w[k] = {ndc.x * halfWidth + halfWidth, ndc.y * halfHeight + halfHeight, ndc.z * halfRange + middle};
            if (isOnGrid) {
                w[k].x = std::round(w[k].x * 256.0f) / 256.0f;
                w[k].y = std::round(w[k].y * 256.0f) / 256.0f;
            }
        }
        const auto twiceArea = [](const glm::dvec2 &a, const glm::dvec2 &b, const glm::dvec2 &c) {
            return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        };
        const glm::dvec2 a(w[0]), b(w[1]), c(w[2]);
        const double area = twiceArea(a, b, c);
        const glm::dvec3 weights =
            glm::dvec3(twiceArea(place, b, c), twiceArea(a, place, c), twiceArea(a, b, place)) / area;
        Drawn drawn{0.0, weights.x >= 0.0 && weights.y >= 0.0 && weights.z >= 0.0};
        float depth;
        if (isBarycentric) {
            depth = float(weights.x) * w[0].z + float(weights.y) * w[1].z + float(weights.z) * w[2].z;
        } else {
            const glm::vec3 e = w[0] - w[1], f = w[2] - w[0];
            const float one = 1.0f / (e.x * f.y - f.x * e.y);
            const float slopeX = e.z * (f.y * one) - f.z * (e.y * one), slopeY = f.z * (e.x * one) - e.z * (f.x * one);
            const float atCorner = w[0].z - (slopeX * w[0].x + slopeY * w[0].y);
            depth = atCorner + slopeX * float(place.x) + slopeY * float(place.y);
        }
        const double steps = std::ldexp(1.0, format.bits) - 1.0;
        drawn.depth = format.isFloat ? double(depth) : std::round(double(depth) * steps) / steps;
        return drawn;
    }
};

/// The intersection of a ray and a plane, in double.
glm::dvec3 onPlane(const Pick &pick, const Triangle &world)
{
    const glm::dvec3 from = pick.rayNear.world[Method::Formula]->coordinates();
    const glm::dvec3 along = pick.rayFar.world[Method::Formula]->coordinates() - from;
    const glm::dvec3 normal = glm::cross(world[1] - world[0], world[2] - world[0]);
    return from + along * (glm::dot(world[0] - from, normal) / glm::dot(along, normal));
}

/// Triangles of all sizes in the frame, inclined in every way, around visible positions.
class Clicks {
public:
    Clicks(const Setup &setup, const glm::dvec3 &origin) : m_setup(setup), m_origin(origin) {}

    struct Click {
        DevicePixel pixel;
        Triangle vertices; ///< floats about the origin
        Triangle world;
    };
    /// @param thinness  of the triangle's height to its length
    Click next(double thinness)
    {
        const auto share = [this](double from, double to) { return from + (to - from) * m_share(m_engine); };
        const auto turned = [&] {
            return glm::normalize(glm::dvec3(m_normal(m_engine), m_normal(m_engine), m_normal(m_engine)));
        };
        Click click;
        click.pixel = {int(share(0.0, 800.0)), int(share(0.0, 600.0))};
        const WidgetPoint widget(click.pixel.i, click.pixel.j);
        const DepthRange &range = m_setup.depthRange;
        const double depth = range.atNear + (range.atFar - range.atNear) * share(0.02, 0.98);
        const Pick pick = pickAt(m_setup, widget, {depth, 0}).value();
        const glm::dvec3 place = pick.point.world[Method::Formula]->coordinates();
        const double size = pick.certainty.footprintWidth * std::pow(10.0, share(-0.3, 2.0));
        const glm::dvec3 a = size * turned(), b = size * thinness * turned();
        // The place lies somewhere in it.
        const double u = share(0.05, 0.9), v = share(0.05, 0.95 - u);
        const Triangle corners{place - u * a - v * b, place + (1.0 - u) * a - v * b, place - u * a + (1.0 - v) * b};
        for (std::size_t k = 0; k < 3; ++k) {
            click.vertices[k] = glm::dvec3(glm::vec3(corners[k] - m_origin));
            click.world[k] = m_origin + click.vertices[k];
        }
        return click;
    }

private:
    Setup m_setup;
    glm::dvec3 m_origin;
    std::mt19937_64 m_engine{5};
    std::uniform_real_distribution<double> m_share;
    std::normal_distribution<double> m_normal;
};

/// The middle of the picture, where the footprint of a pixel is the same to the right and upward.
DepthError errorOf(const DepthSample &sample, const DrawnSurface &surface = {}, const Projection &projection = kBox)
{
    const Pick pick = pickAt(setupOf(projection, {}), WidgetPoint(400.0, 300.0), sample).value();
    return depthErrorAt(pick.setup, pick.window, *pick.point.world[Method::Formula], sample, surface);
}

} // namespace

namespace {

/// Clicks on triangles as a rasteriser draws them. Half of the clicks on thin triangles are
/// useless: these cover no pixel.
InsideShare clicked(const Setup &setup, const glm::dvec3 &origin, const Rasteriser &rasteriser, double thinness,
                    int count)
{
    Clicks clicks(setup, origin);
    glm::dmat4 worldFromVertices(1.0);
    worldFromVertices[3] = glm::dvec4(origin, 1.0);
    const glm::mat4 clipFromVertices(clipFromWorld(setup).value() * worldFromVertices);
    const Unprojector unprojector = Unprojector::of(setup).value();
    InsideShare inside;
    for (int i = 0; i < count; ++i) {
        const Clicks::Click click = clicks.next(thinness);
        const WindowPoint centre = windowFromDevice(setup.surface, pixelCenter(click.pixel), 0.5);
        const Rasteriser::Drawn drawn =
            rasteriser.depthAt(setup, clipFromVertices, click.vertices, {centre.x, centre.y});
        const auto [lowest, highest] = std::minmax(setup.depthRange.atNear, setup.depthRange.atFar);
        if (!drawn.covers || !(drawn.depth >= lowest && drawn.depth <= highest))
            continue;
        const DepthSample sample{drawn.depth, 0, rasteriser.format, {}, rasteriser.isOnGrid ? kCornerShiftPixels : 0.0};
        const Pick pick = refined(unproject::pickAt(unprojector, {{}, click.pixel, sample}).value(),
                                  {worldFromVertices, click.vertices});
        const glm::dvec3 off = onPlane(pick, click.world) - pick.point.world[Method::Formula]->coordinates();
        // The error of the plane's own arithmetic in double.
        constexpr double kArithmetic = 1e-14;
        const glm::dvec3 box = pick.uncertainty.world.coordinates() + kArithmetic * (20.0 + glm::length(origin));
        inside.add(InsideShare::shareOf(off, box));
    }
    return inside;
}

} // namespace

class TestCertainty : public QObject {
    Q_OBJECT

private slots:
    void aDepthBufferKeepsDepthsInSteps_data()
    {
        addColumn<int>("bits"); // 0: floating point
        addColumn<double>("depth");
        addColumn<double>("halfStep");
        newRow("16 bits") << 16 << 0.3 << 0.5 / 65535.0;
        newRow("24 bits") << 24 << 0.9 << 0.5 / 16777215.0;
        newRow("32 bits") << 32 << 0.9 << 0.5 / 4294967295.0;
        newRow("float, upper half") << 0 << 0.75 << 0x1p-25;
        newRow("float, 1") << 0 << 1.0 << 0x1p-24;
        newRow("float, small") << 0 << 0.001 << 0x1p-34;
        newRow("float, 0") << 0 << 0.0 << 0x1p-150;
    }

    void aDepthBufferKeepsDepthsInSteps()
    {
        QFETCH(int, bits);
        QFETCH(double, depth);
        QFETCH(double, halfStep);
        const DepthFormat format = bits ? DepthFormat(bits) : DepthFormat::floatingPoint();
        QCOMPARE(format.halfStep(depth), halfStep);
    }

    void eachSourceOfErrorIsAdded()
    {
        DepthSample sample{0.5, 0, 24, DepthSlope{0.0, 0.0}, 0.0};
        const DepthError flat = errorOf(sample);
        QCOMPARE(flat.rounding, 0.5 / 16777215.0);
        QVERIFY(flat.drawing >= 2.0 * 0x1p-24 * 0.5 && flat.drawing < 20.0 * 0x1p-24);
        // Corners on a grid, times the slope.
        sample.slope = {2e-3, 1e-3};
        const DepthError inclined = errorOf(sample);
        QVERIFY(inclined.drawing > flat.drawing);
        sample.cornerShiftPixels = kCornerShiftPixels;
        QVERIFY(isRelativelyNear(errorOf(sample).drawing - inclined.drawing, 3e-3 / 512.0, 1e-9));
        // No slope is given: assume steep. The box is 8 / 800 a pixel and 19 deep; tan 80 degrees is
        // 5.67.
        sample.slope.reset();
        QVERIFY(isRelativelyNear(errorOf(sample).drawing, 2.0 * 0.01 / 19.0 * 5.671281819617709 / 512.0, 0.2));
        // Vertices that lie a thousand times as far from their origin as the picture is wide lose as
        // much.
        DrawnSurface away;
        away.worldFromVertices[3] = glm::dvec4(5000.0, 0.0, 0.0, 1.0);
        sample.slope = {2e-3, 1e-3};
        QVERIFY(errorOf(sample, away).drawing > 100.0 * flat.drawing);
    }

    void aTriangleTellsItsSlope_data()
    {
        addColumn<Projection>("projection");
        newRow("frustum") << kFrustum;
        newRow("off-centre frustum") << kOffCenter;
        newRow("box") << kBox;
        newRow("oblique") << kOblique;
    }

    /// The triangle is three unprojected window points, whose slope is known. A corner behind the eye
    /// changes nothing.
    void aTriangleTellsItsSlope()
    {
        QFETCH(Projection, projection);
        const Setup setup = setupOf(projection, {0.2, 0.9});
        const Unprojector unprojector = Unprojector::of(setup).value();
        const glm::dvec2 slope(3e-4, -5e-4);
        const WindowPoint middle(400.5, 299.5, 0.55);
        const auto at = [&](double x, double y) {
            const WindowPoint window(middle.x + x, middle.y + y, middle.z + slope.x * x + slope.y * y);
            return unprojector.worldAt(Method::Formula, window).value().coordinates();
        };
        const Triangle small{at(-31.0, -22.0), at(40.0, -3.0), at(2.0, 35.0)};
        const glm::dvec3 long1 = small[1] - small[0], long2 = small[2] - small[0];
        const Triangle large{small[0] - 300.0 * (long1 + long2), small[1] + 300.0 * long1, small[2] + 300.0 * long2};
        for (const Triangle &triangle : {small, large}) {
            DepthSample sample{middle.z, 0, 24, DepthSlope{1.0, 1.0}, 0.0}; // the triangle counts, not the neighbours
            const auto drawing = [&](double cornerShift) {
                sample.cornerShiftPixels = cornerShift;
                return depthErrorAt(setup, middle, WorldPoint(at(0.0, 0.0)), sample, {glm::dmat4(1.0), triangle})
                    .drawing;
            };
            QVERIFY(isRelativelyNear(drawing(1.0) - drawing(0.0), std::abs(slope.x) + std::abs(slope.y), 1e-6));
        }
    }

    void anErrorOfDepthIsOneOfDistance_data()
    {
        addColumn<Projection>("projection");
        addColumn<DepthRange>("range");
        for (const auto &[rangeName, range] :
             {std::pair{"", DepthRange{}}, std::pair{", reversed", DepthRange{1.0, 0.0}},
              std::pair{", partial", DepthRange{0.2, 0.9}}}) {
            addRow("frustum%s", rangeName) << kFrustum << range;
            addRow("box%s", rangeName) << kBox << range;
            addRow("oblique%s", rangeName) << kOblique << range;
        }
    }

    /// The bound holds for any error of depth, up to one that leaves nothing but the view volume.
    void anErrorOfDepthIsOneOfDistance()
    {
        QFETCH(Projection, projection);
        QFETCH(DepthRange, range);
        const Setup setup = setupOf(projection, range);
        const Unprojector unprojector = Unprojector::of(setup).value();
        const auto distance = [&](double depth) {
            return -unprojector.eyeAt(Method::Formula, WindowPoint(200.5, 100.5, depth)).value().z;
        };
        const double extent = std::abs(range.atFar - range.atNear);
        const auto [lowest, highest] = std::minmax(range.atNear, range.atFar);
        for (const double share : {0.1, 0.5, 0.97}) {
            const double depth = range.atNear + share * (range.atFar - range.atNear), here = distance(depth);
            for (const double part : {1e-9, 1e-4, 0.02, 0.6}) {
                const double error = part * extent;
                const Certainty certainty = Certainties(setup).at(here, {error / 4.0, error * 0.75});
                double farthest = 0.0;
                for (const double end : {depth - error, depth + error})
                    farthest = std::max(farthest, std::abs(distance(std::clamp(end, lowest, highest)) - here));
                QVERIFY(certainty.distance >= farthest * (1.0 - 1e-6));
                const bool isCut = depth + error > highest || depth - error < lowest;
                QVERIFY(isCut || isRelativelyNear(certainty.distance, farthest, 1e-6));
                QVERIFY(certainty.distance <= 19.0);
                QVERIFY(part > 1e-4 || isRelativelyNear(certainty.halfDepthStep, certainty.distance / 4.0, 0.05));
            }
        }
    }

    void theSurfaceLiesInTheBox_data()
    {
        addColumn<Projection>("projection");
        addColumn<DepthRange>("range");
        addColumn<Rasteriser>("rasteriser");
        addColumn<bool>("isFarAway");
        const auto rows = [](const char *name, const Rasteriser &rasteriser) {
            addRow("frustum, %s", name) << kFrustum << DepthRange{} << rasteriser << false;
            addRow("off-centre frustum, reversed range, %s", name)
                << kOffCenter << DepthRange{1.0, 0.0} << rasteriser << false;
            addRow("frustum far from the origin, %s", name) << kFrustum << DepthRange{} << rasteriser << true;
            addRow("box, %s", name) << kBox << DepthRange{} << rasteriser << false;
            addRow("box, partial range, %s", name) << kBox << DepthRange{0.2, 0.9} << rasteriser << false;
            addRow("oblique, %s", name) << kOblique << DepthRange{} << rasteriser << false;
        };
        rows("24 bits", {24});
        rows("24 bits, on the grid", {24, true, true});
        rows("16 bits", {16});
        rows("16 bits, on the grid", {16, true, true});
        rows("float", {DepthFormat::floatingPoint()});
        rows("float, on the grid", {DepthFormat::floatingPoint(), true, true});
    }

    void theSurfaceLiesInTheBox()
    {
        QFETCH(Projection, projection);
        QFETCH(DepthRange, range);
        QFETCH(Rasteriser, rasteriser);
        QFETCH(bool, isFarAway);
        Setup setup = setupOf(projection, range);
        glm::dvec3 origin(0.0);
        if (isFarAway) {
            origin = {4.5e5, 5.4e6, 300.0};
            setup.camera().eye = WorldPoint(setup.camera().eye.coordinates() + origin);
            setup.camera().center = WorldPoint(setup.camera().center.coordinates() + origin);
        }
        const InsideShare inside = clicked(setup, origin, rasteriser, 1.0, 4'000);
        qInfo("%zu clicks, %.3f %% inside, needed scale %.2f", inside.count(), 100.0 * inside.inside(),
              inside.neededScale());
        QVERIFY(inside.count() > 3000);
        QVERIFY(inside.inside() >= 0.999);
        QVERIFY(inside.neededScale() >= 0.5);
    }

    void aThinTriangleLiesInTheBox_data()
    {
        addColumn<double>("thinness");
        newRow("20 times as long as high") << 0.05;
        newRow("1000 times") << 0.001;
    }

    void aThinTriangleLiesInTheBox()
    {
        QFETCH(double, thinness);
        const InsideShare inside = clicked(setupOf(kFrustum, {}), glm::dvec3(0.0), Rasteriser{24}, thinness, 10'000);
        qInfo("%zu clicks, %.3f %% inside, needed scale %.2f", inside.count(), 100.0 * inside.inside(),
              inside.neededScale());
        QVERIFY(inside.count() > 1000);
        QVERIFY(inside.inside() >= 0.999);
    }

    void aPointOfACloudLiesInItsPixel()
    {
        const Setup setup = setupOf(kFrustum, {});
        const Unprojector unprojector = Unprojector::of(setup).value();
        DrawnSurface cloud;
        cloud.isPoint = true;
        const DepthSample sample{0.8, 0};
        const Pick pick = refined(unproject::pickAt(unprojector, {{}, {123, 456}, sample}).value(), cloud);
        for (const double x : {-0.5, 0.5}) {
            for (const double y : {-0.5, 0.5}) {
                const WindowPoint corner(pick.window.x + x, pick.window.y + y, pick.window.z);
                const WorldVector off =
                    *unprojector.worldAt(Method::Formula, corner) - *pick.point.world[Method::Formula];
                for (int axis = 0; axis < 3; ++axis)
                    QVERIFY(std::abs(off[axis]) <= pick.uncertainty.world[axis]);
            }
        }
        // The world point on a surface is the one at the pixel's centre.
        const Pick surface = unproject::pickAt(unprojector, {{}, {123, 456}, sample}).value();
        QVERIFY(length(surface.uncertainty.world) < 0.1 * length(pick.uncertainty.world));
    }

    void moreKnownOfTheSurfaceChangesOnlyTheCertainty()
    {
        const Unprojector unprojector = Unprojector::of(setupOf(kFrustum, {})).value();
        const DepthSample sample{0.8, 0};
        DrawnSurface surface;
        surface.triangle = Triangle{glm::dvec3(-1.0, 0.0, 0.0), glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.5)};
        const Pick before = unproject::pickAt(unprojector, {{}, {123, 456}, sample}).value();
        WorldPoint asked(0.0, 0.0, 0.0);
        const SurfaceAt surfaceAt = [&](const WorldPoint &world) {
            asked = world;
            return surface;
        };
        const Pick at = unproject::pickAt(unprojector, {{}, {123, 456}, sample}, surfaceAt).value();
        QVERIFY(asked == *at.point.world[Method::Formula]);
        const Pick later = refined(before, surface);
        QVERIFY(later.point.world[Method::Formula]->coordinates()
                == before.point.world[Method::Formula]->coordinates());
        QVERIFY(later.uncertainty.world != before.uncertainty.world);
        QVERIFY(later.uncertainty.world == at.uncertainty.world);
        QCOMPARE(later.certainty.distance, at.certainty.distance);
        // Background stays background.
        const Pick background = unproject::pickAt(unprojector, {{}, {123, 456}, {1.0, {}}}).value();
        QCOMPARE(refined(background, surface).certainty.distance, 0.0);
    }
};

UNPROJECTOR_TEST(TestCertainty)
#include "test_certainty.moc"
