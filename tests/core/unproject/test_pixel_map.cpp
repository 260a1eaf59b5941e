// Maps: a number for each pixel, which equals the one of a click there.
#include "tests/support/test.h"

#include "core/geometry/numbers.h"
#include "core/maps/pixel_map.h"
#include "core/ray/drawn_surface.h"
#include "core/unproject/pick.h"
#include "tests/support/cube_sphere.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::maps;
using namespace unprojector::ray;
using namespace unprojector::unproject;
using namespace unprojector::scene;

namespace {

const LookAt kCamera{WorldPoint(1.0, 2.0, 4.0), WorldPoint(0.1, -0.2, 0.3), {0.0, 1.0, 0.1}};
const Lens kPerspective = Projection(Perspective{radiansFromDegrees(45.0), 4.0 / 3.0, 1.0, 20.0});

/// The viewport leaves a rim of the window free.
Setup pictureWith(const Lens &lens, const DepthRange &range = {})
{
    const Surface surface{64, 48, 1.0};
    return {surface, {8, 6, 48, 36}, range, lens, kCamera};
}

/// A ball that fills a part of the picture.
struct Shown {
    Setup setup = pictureWith(kPerspective);
    std::vector<SceneObject> objects{{"ball", {}, cubeSphere(20), {Translate{{0.2, 0.1, 0.0}}}}};
    Unprojector unprojector = *Unprojector::of(setup);
    SceneRays rays = raysOf();
    SurfaceImage surfaces = *surfacesMet(rays, *PixelRays::of(rays.rays()), {}, {});

    Shown() = default;
    explicit Shown(const Setup &other) : setup(other) {}

    SceneRays raysOf() const
    {
        std::vector<std::shared_ptr<const RayCaster>> casters{RayCaster::build(objects[0].model, {})};
        return SceneRays(unprojector, objects, casters, {});
    }
    PixelMap map(const Question &question) const
    {
        const auto made = pixelMap(question, unprojector, surfaces, objects, {});
        return made && *made ? **made : PixelMap{};
    }
    template <class Each> // (pixel, place)
    void forEachPixel(const Each &each) const
    {
        for (int j = 0; j < surfaces.heightPixels; ++j) {
            for (int i = 0; i < surfaces.widthPixels; ++i)
                each(DevicePixel{i, j}, surfaces.indexOf(i, j));
        }
    }
    WindowPoint window(const DevicePixel &pixel) const
    {
        return windowFromDevice(setup.surface, pixelCenter(pixel), surfaces.depths[surfaces.indexOf(pixel.i, pixel.j)]);
    }
};

bool isClose(float value, double expected, double relative)
{
    return std::abs(static_cast<double>(value) - expected) <= relative * std::abs(expected);
}

} // namespace

Q_DECLARE_METATYPE(unprojector::geometry::Setup)
Q_DECLARE_METATYPE(unprojector::maps::Question)

class TestPixelMap : public QObject {
    Q_OBJECT

private slots:
    void surfacesAreWhatRaysMeet_data()
    {
        addColumn<Setup>("picture");
        newRow("perspective") << pictureWith(kPerspective);
        newRow("reversed") << pictureWith(kPerspective, {1.0, 0.0});
        newRow("partial range") << pictureWith(kPerspective, {0.2, 0.3});
        newRow("ortho") << pictureWith(Projection(Ortho{-2, 2, -1.5, 1.5, -3, 12}));
        newRow("oblique") << pictureWith(Projection(Oblique{{-2, 2, -1.5, 1.5, -3, 12}, 1.2, 1.3}));
        glm::dmat4 infinite(0.0);
        infinite[0][0] = 1.8;
        infinite[1][1] = 2.4;
        infinite[2][3] = -1.0;
        infinite[3][2] = 0.5;
        newRow("reversed, far at infinity") << pictureWith(MatrixProjection{infinite, NdcDepth::ZeroToOne});
    }

    void surfacesAreWhatRaysMeet()
    {
        QFETCH(Setup, picture);
        const Shown shown(picture);
        const DepthFormat format;
        int met = 0, missed = 0;
        shown.forEachPixel([&](const DevicePixel &pixel, std::size_t index) {
            const std::optional<SceneHit> hit = *shown.rays.at(pixelCenter(pixel));
            QCOMPARE(std::isnan(shown.surfaces.depths[index]), !hit.has_value());
            (hit ? met : missed) += 1;
            if (!hit)
                return;
            QCOMPARE(shown.surfaces.triangles[index], hit->triangle->triangle);
            QVERIFY(std::abs(shown.surfaces.ts[index] - hit->t) <= 1e-12 * hit->t);
            const double depth = windowFromWorld(picture, hit->world).value().z;
            QVERIFY(std::abs(shown.surfaces.depths[index] - depth) <= format.halfStep(depth) * 1.000001);
            QCOMPARE(shown.surfaces.depths[index], format.kept(shown.surfaces.depths[index]));
        });
        QVERIFY(met > 100 && missed > 1000);
    }

    void differencesAreThoseOfClicks()
    {
        const Shown shown;
        const PixelMap world = shown.map({Quantity::FormulaMatrix, Unit::World, {}});
        const PixelMap ulps = shown.map({Quantity::FormulaMatrix, Unit::Ulps, {}});
        const PixelMap formulaRay = shown.map({Quantity::FormulaRay, Unit::World, {}});
        const PixelMap matrixRay = shown.map({Quantity::MatrixRay, Unit::World, {}});
        bool isAnyOff = false;
        shown.forEachPixel([&](const DevicePixel &pixel, std::size_t index) {
            QCOMPARE(std::isnan(world.at(pixel)), std::isnan(shown.surfaces.depths[index]));
            if (std::isnan(world.at(pixel)))
                return;
            const Unprojected click = shown.unprojector.at(shown.window(pixel));
            const double off = length(click.world.difference());
            QCOMPARE(world.at(pixel), static_cast<float>(off));
            QCOMPARE(ulps.at(pixel), static_cast<float>(off / ulpOfLargest(*click.world[Method::Formula])));
            isAnyOff = isAnyOff || off > 0.0;
            const WorldPoint met = shown.rays.at(pixelCenter(pixel)).value()->world;
            constexpr double kRayOff = 1e-13; // the row's rays in plain double
            QVERIFY(std::abs(double(formulaRay.at(pixel)) - distance(*click.world[Method::Formula], met))
                    < kRayOff + 1e-7 * double(formulaRay.at(pixel)));
            QVERIFY(std::abs(double(matrixRay.at(pixel)) - distance(*click.world[Method::Matrix], met))
                    < kRayOff + 1e-7 * double(matrixRay.at(pixel)));
        });
        QVERIFY(isAnyOff);
    }

    void theRayIsWithinTheRoundingOfTheDepth()
    {
        const Shown shown;
        const PixelMap map = shown.map({Quantity::FormulaRay, Unit::World, {}});
        const Certainties certainties(shown.setup);
        float greatest = 0.0F;
        shown.forEachPixel([&](const DevicePixel &pixel, std::size_t) {
            if (std::isnan(map.at(pixel)))
                return;
            greatest = std::max(greatest, map.at(pixel));
            const EyePoint eye = *shown.unprojector.eyeAt(Method::Formula, shown.window(pixel));
            const double alongView = certainties.at(-eye.z, {DepthFormat().halfStep(0.5), 0.0}).halfDepthStep;
            const double alongRay = alongView * glm::length(eye.coordinates()) / -eye.z;
            QVERIFY(static_cast<double>(map.at(pixel)) <= 1.001 * alongRay);
        });
        QVERIFY(greatest > 0.0F);
    }

    void theUncertaintyIsThatOfAClick()
    {
        const Shown shown;
        const PixelMap map = shown.map({Quantity::Uncertainty, Unit::World, {}});
        int compared = 0;
        shown.forEachPixel([&](const DevicePixel &pixel, std::size_t index) {
            QCOMPARE(std::isnan(map.at(pixel)), std::isnan(shown.surfaces.depths[index]));
            if (std::isnan(map.at(pixel)))
                return;
            const std::vector<double> &depths = shown.surfaces.depths;
            const auto width = static_cast<std::size_t>(shown.surfaces.widthPixels);
            DepthSample sample{depths[index], 0};
            const auto steeper = [&](std::size_t step) {
                return std::max(std::abs(depths[index - step] - depths[index]),
                                std::abs(depths[index + step] - depths[index]));
            };
            sample.slope = DepthSlope{steeper(1), steeper(width)};
            if (std::isnan(sample.slope->perPixelX + sample.slope->perPixelY))
                return; // at the ball's rim
            const SceneHit hit = **shown.rays.at(pixelCenter(pixel));
            const Pick pick =
                refined(*pickAt(shown.unprojector, {{}, pixel, sample}), drawnSurface(shown.objects[0], hit));
            QVERIFY(isClose(map.at(pixel), length(pick.uncertainty.world), 1e-6));
            ++compared;
        });
        QVERIFY(compared > 100);
    }

    void programsReadTheRowThatTheyRead()
    {
        Shown shown;
        shown.surfaces = surfacesAt(shown.setup, 0.5, allRows(shown.setup));
        // Two columns: in row 20 the depth is another one, in row 30 there is nothing.
        for (const int column : {20, 21}) {
            shown.surfaces.depths[shown.surfaces.indexOf(column, 20)] = 0.6;
            shown.surfaces.depths[shown.surfaces.indexOf(column, 30)] = std::numeric_limits<double>::quiet_NaN();
        }
        const auto answer = [&](const DevicePoint &position, double depth) {
            return *shown.unprojector.worldAt(Method::Matrix, windowFromDevice(shown.setup.surface, position, depth));
        };
        for (const auto &[program, above] :
             {std::pair(OtherProgram::Open3D, false), std::pair(OtherProgram::MeshLab, true)}) {
            const PixelMap map = shown.map({Quantity::Displacement, Unit::World, program});
            for (const int row : {20, 21, 31}) {
                const WorldPoint right = *shown.unprojector.worldAt(Method::Formula, shown.window({20, row}));
                const double read = above ? (row == 20 ? 0.5 : row == 21 ? 0.6 : 1.0) : (row == 20 ? 0.6 : 0.5);
                QVERIFY(isClose(map.at({20, row}), distance(right, answer(DevicePoint(20, row), read)), 1e-6));
            }
        }
        // Reads above the window are undefined. The viewport begins below its edge, so this test sets
        // one that begins there.
        Setup whole = shown.setup;
        whole.viewport = wholeSurface(whole.surface);
        shown.setup = whole;
        shown.unprojector = *Unprojector::of(whole);
        shown.surfaces = surfacesAt(whole, 0.5, allRows(whole));
        const PixelMap map = shown.map({Quantity::Displacement, Unit::World, OtherProgram::Polyscope});
        QVERIFY(std::isnan(map.at({5, 0})));
        QVERIFY(!std::isnan(map.at({5, 1})));
    }

    void mistakes()
    {
        const Shown shown;
        const PixelMap none = shown.map({Quantity::Displacement, Unit::World, MistakeMade{}});
        const PixelMap methods = shown.map({Quantity::FormulaMatrix, Unit::World, {}});
        const PixelMap corner =
            shown.map({Quantity::Displacement, Unit::World, conventionNamed("pixel-corner")->other});
        const PixelMap open3d = shown.map({Quantity::Displacement, Unit::World, conventionNamed("open3d")->other});
        const PixelMap left = shown.map({Quantity::Displacement, Unit::World, conventionNamed("model-left-in")->other});
        int compared = 0;
        shown.forEachPixel([&](const DevicePixel &pixel, std::size_t index) {
            if (std::isnan(shown.surfaces.depths[index]))
                return;
            ++compared;
            QCOMPARE(none.at(pixel), methods.at(pixel));
            QVERIFY(isClose(corner.at(pixel), double(open3d.at(pixel)), 1e-6));
            QVERIFY(std::abs(double(left.at(pixel)) - std::hypot(0.2, 0.1)) < 1e-6); // the ball's own translation
        });
        QVERIFY(compared > 100);
        for (const NamedConvention &convention : namedConventions())
            QCOMPARE(conventionNamed(convention.key), &convention);
        QVERIFY(conventionNamed("blender") == nullptr);
    }

    void mistakesOfThePixel_data()
    {
        addColumn<double>("x");
        addColumn<double>("y");
        // Device pixel (20, 11) of 64 x 48, two to a logical one: logical pixel (10, 5) of 32 x 24; the
        // viewport's height is 36.
        newRow("y-not-flipped") << 20.5 << 11.5;
        newRow("flipped-with-viewport-height") << 20.5 << 24.5;
        newRow("row-above") << 20.5 << 37.5;
        newRow("pixel-corner") << 20.0 << 37.0;
        newRow("ratio-logical-in-device") << 10.5 << 42.5;
        newRow("ratio-logical-both") << 10.5 << 18.5;
    }

    /// The other program's position in the window.
    void mistakesOfThePixel()
    {
        QFETCH(double, x);
        QFETCH(double, y);
        Setup setup = pictureWith(kPerspective);
        setup.surface.devicePixelRatio = 2.0;
        const Unprojector unprojector = Unprojector::of(setup).value();
        const Other other = conventionNamed(QTest::currentDataTag())->other;
        const auto map = pixelMap({Quantity::Displacement, Unit::World, other}, unprojector,
                                  surfacesAt(setup, 0.5, allRows(setup)), {}, {});
        const WorldPoint right =
            *unprojector.worldAt(Method::Formula, windowFromDevice(setup.surface, pixelCenter({20, 11}), 0.5));
        const WorldPoint wrong = *unprojector.worldAt(Method::Matrix, WindowPoint(x, y, 0.5));
        QVERIFY(map && *map);
        QVERIFY(isClose((*map)->at({20, 11}), distance(right, wrong), 1e-6));
    }

    void singlePrecisionAndAngles()
    {
        const Shown shown;
        const PixelMap floats =
            shown.map({Quantity::Displacement, Unit::World, conventionNamed("single-precision")->other});
        const Shown frustum(pictureWith(Projection(Frustum{-0.5, 0.5, -0.4, 0.4, 1.0, 20.0})));
        const PixelMap angle =
            frustum.map({Quantity::Displacement, Unit::World, conventionNamed("fov-horizontal")->other});
        shown.forEachPixel([&](const DevicePixel &pixel, std::size_t) {
            if (!std::isnan(floats.at(pixel))) {
                const Unprojected click = shown.unprojector.at(shown.window(pixel));
                const double off = distance(*click.world[Method::Formula], *click.world[Method::MatrixInFloat]);
                QVERIFY(isClose(floats.at(pixel), off, 1e-6));
            }
            QVERIFY(!(angle.at(pixel) > 0.0F)); // a frustum has none that could be misread
        });
    }

    void aDepthEverywhere()
    {
        const Setup setup = pictureWith(kPerspective);
        const SurfaceImage surfaces = surfacesAt(setup, 0.25, allRows(setup));
        QVERIFY(!surfaces.isMet());
        int inside = 0;
        for (const double depth : surfaces.depths)
            inside += depth == 0.25 ? 1 : 0;
        QCOMPARE(inside, 48 * 36);
        QVERIFY(std::isnan(surfaces.depths[surfaces.indexOf(7, 20)]));
        QCOMPARE(surfaces.depths[surfaces.indexOf(8, 6)], 0.25);
        const auto map = pixelMap({Quantity::Displacement, Unit::World, conventionNamed("model-left-in")->other},
                                  *Unprojector::of(setup), surfaces, {}, {});
        QVERIFY(map && map.value()->at({8, 6}) < 1e-10F); // no object, no model matrix
    }

    void bandsGiveTheWhole_data()
    {
        addColumn<Question>("question");
        for (const Quantity quantity : kQuantities) {
            if (quantity != Quantity::Displacement)
                newRow(std::string(keyOf(quantity)).c_str()) << Question{quantity, Unit::World, {}};
        }
        for (const NamedConvention &convention : namedConventions())
            newRow(std::string(convention.key).c_str())
                << Question{Quantity::Displacement, Unit::Ulps, convention.other};
    }

    /// The rows are so wide that a band has few, and the viewport is lower than the window:
    /// screen2world then reads rows far away.
    void bandsGiveTheWhole()
    {
        QFETCH(Question, question);
        Setup setup = pictureWith(kPerspective);
        setup.surface = {60000, 24, 1.0};
        setup.viewport = {8, 4, 640, 16};
        static const Shown shown(setup);
        std::size_t most = 0;
        const SurfaceSource source{true, [&](const Rows &rows, const Progress &progress) {
                                       most = std::max(most, rows.size());
                                       return surfacesMet(shown.rays, *PixelRays::of(shown.rays.rays()), {}, rows,
                                                          progress);
                                   }};
        double told = 0.0;
        const auto banded = pixelMap(question, shown.unprojector, source, shown.objects, [&told](double share) {
            const bool rises = share >= told;
            told = share;
            return rises;
        });
        QVERIFY(banded && *banded);
        QVERIFY(told > 0.5 && told <= 1.0);
        QVERIFY(most < 20);
        const PixelMap whole = shown.map(question);
        const PixelMap &map = **banded;
        QVERIFY(map.widthPixels == whole.widthPixels && map.heightPixels == whole.heightPixels);
        QVERIFY(map.values.size() == whole.values.size());
        QVERIFY(std::memcmp(map.values.data(), whole.values.data(), sizeof(float) * map.values.size()) == 0);
        QVERIFY(statisticsOf(whole).count > 500);
    }

    void statistics()
    {
        const float none = std::numeric_limits<float>::quiet_NaN();
        const MapStatistics empty = statisticsOf({2, 1, {none, none}});
        QCOMPARE(empty.count, std::size_t{0});
        PixelMap map{101, 1, {none}};
        for (int k = 99; k >= 0; --k)
            map.values.push_back(static_cast<float>(k));
        const MapStatistics statistics = statisticsOf(map);
        QCOMPARE(statistics.count, std::size_t{100});
        QCOMPARE(statistics.least, 0.0);
        QCOMPARE(statistics.leastAboveZero, 1.0);
        QCOMPARE(statistics.percentile1, 0.0);
        QCOMPARE(statistics.median, 49.0);
        QCOMPARE(statistics.percentile99, 98.0);
        QCOMPARE(statistics.greatest, 99.0);
    }

    void portableFloatMaps()
    {
        const std::string text = pfmText({2, 2, {1.0F, 2.0F, 3.0F, std::numeric_limits<float>::quiet_NaN()}});
        const std::string header = "Pf\n2 2\n-1.0\n";
        QCOMPARE(QByteArray::fromStdString(text.substr(0, header.size())), QByteArray::fromStdString(header));
        QCOMPARE(text.size(), header.size() + 16);
        // The bottom row first, the low byte first: 3 is 0x40400000, 1 is 0x3f800000.
        QCOMPARE(QByteArray::fromStdString(text.substr(header.size(), 4)), QByteArray("\x00\x00\x40\x40", 4));
        QCOMPARE(QByteArray::fromStdString(text.substr(header.size() + 8, 4)), QByteArray("\x00\x00\x80\x3f", 4));
    }

    void workIsStopped()
    {
        const Shown shown;
        const auto stop = [](double) { return false; };
        QVERIFY(!surfacesMet(shown.rays, *PixelRays::of(shown.rays.rays()), {}, stop));
        const auto map = pixelMap({}, shown.unprojector, shown.surfaces, shown.objects, stop);
        QVERIFY(map);
        QVERIFY(!*map);
        double told = 0.0;
        QVERIFY(surfacesMet(shown.rays, *PixelRays::of(shown.rays.rays()), {}, [&told](double share) {
            told = share;
            return true;
        }));
        QVERIFY(told > 0.0 && told <= 1.0);
    }
};

UNPROJECTOR_TEST(TestPixelMap)
#include "test_pixel_map.moc"
