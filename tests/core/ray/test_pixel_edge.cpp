// Occluding edges inside a pixel: surfaces with known edges, and rates by a dense grid of rays.

#include "tests/support/test.h"

#include "core/examples/examples.h"
#include "core/ray/pixel_edge.h"
#include "tests/core/ray/ray_meshes.h"
#include "tests/support/cube_sphere.h"
#include "tests/support/edge_rates.h"

#include <cmath>
#include <vector>

namespace {

using namespace ray_meshes;
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace unprojector::ray;

/// Looks down -z from z = 5: the plane z = 0 is 10 wide and 7.5 high, 64 pixels a unit.
Setup straightView(bool isBox)
{
    const Surface surface{640, 480, 1.0};
    const Projection frustum = Frustum{-1.0, 1.0, -0.75, 0.75, 1.0, 11.0},
                     box = Ortho{-5.0, 5.0, -3.75, 3.75, 1.0, 11.0};
    return {surface,
            wholeSurface(surface),
            {},
            isBox ? box : frustum,
            LookAt{WorldPoint(0.0, 0.0, 5.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}}};
}

SceneRays raysOf(const std::vector<std::shared_ptr<Model>> &models, const std::vector<glm::dvec4> &planes = {},
                 bool isBox = false)
{
    std::vector<scene::SceneObject> objects;
    std::vector<std::shared_ptr<const RayCaster>> casters;
    for (const auto &model : models) {
        objects.push_back({"object", {}, model, {}});
        casters.push_back(RayCaster::build(model, {}));
    }
    return SceneRays(*unproject::Unprojector::of(straightView(isBox)), objects, casters, planes);
}

std::optional<PixelEdge> edgeAt(const SceneRays &rays, const DevicePoint &position, double pixels = 1.0)
{
    return edgeInPixel(rays, position, *rays.at(position), pixels);
}

/// Parallel to the view, from x = `left` on to the right, 9 up and down.
std::shared_ptr<Model> wall(float z, float left = -9.0f)
{
    return modelOf({{left, -9, z}, {9, -9, z}, {9, 9, z}, {left, 9, z}}, {0, 1, 2, 0, 2, 3});
}

constexpr double kMiddleRow = 200.5;

} // namespace

class TestPixelEdge : public QObject {
    Q_OBJECT

private slots:
    void theOtherSurfaceIsTold_data()
    {
        addColumn<bool>("isBox");
        addColumn<double>("x"); ///< of the click; the rim is at 320.25
        addColumn<bool>("hasBack");
        addColumn<bool>("hasEdge");
        addColumn<int>("object"); ///< -1: the background
        addColumn<double>("behind");

        for (const bool isBox : {false, true}) {
            const auto row = [&](const char *name) -> QTestData & {
                return newRow((std::string(isBox ? "box, " : "perspective, ") + name).c_str()) << isBox;
            };
            row("on the front surface") << 320.5 << true << true << 1 << 2.0;
            row("on the back surface") << 320.1 << true << true << 0 << -2.0;
            row("the background beside") << 320.5 << false << true << -1 << 0.0;
            row("on the background") << 320.1 << false << true << 0 << 0.0;
            row("the next pixel") << 321.5 << true << false << -1 << 0.0;
            row("the pixel before") << 319.5 << true << false << -1 << 0.0;
        }
    }

    void theOtherSurfaceIsTold()
    {
        QFETCH(bool, isBox);
        QFETCH(double, x);
        QFETCH(bool, hasBack);
        QFETCH(bool, hasEdge);
        QFETCH(int, object);
        QFETCH(double, behind);
        std::vector<std::shared_ptr<Model>> models{wall(0.0f, 0.25f / 64.0f)};
        if (hasBack)
            models.push_back(wall(-2.0f));
        const SceneRays rays = raysOf(models, {}, isBox);
        const DevicePoint position(x, kMiddleRow);
        const std::optional<PixelEdge> edge = edgeAt(rays, position);
        QCOMPARE(edge.has_value(), hasEdge);
        if (!edge)
            return;
        QCOMPARE(edge->object ? static_cast<int>(*edge->object) : -1, object);
        // The ray is hardly inclined there.
        const auto ray = rays.rays().at(position);
        const double inclined = length(ray->along) / std::abs(ray->along.z);
        QVERIFY2(std::abs(edge->behind - behind * inclined) < 1e-9, qPrintable(QString::number(edge->behind, 'g', 17)));
        QVERIFY(std::abs(edge->reach.z - std::abs(behind)) < 1e-9);
    }

    void onlyItsOwnPixelCounts()
    {
        const SceneRays rays = raysOf({wall(0.0f, 0.25f / 64.0f), wall(-2.0f)});
        QVERIFY(!edgeAt(rays, {320.5, kMiddleRow}, 0.4)); // from 320.3
        QVERIFY(edgeAt(rays, {320.5, kMiddleRow}, 0.6));
        QVERIFY(edgeAt(rays, {325.0, kMiddleRow}, 9.6)); // from 320.2
    }

    void foldsAreEdges()
    {
        // A sheet that turns back at x = 0.25 pixels: its edge is shared by two triangles.
        const float x = 0.25f / 64.0f;
        const auto fold = modelOf({{x, -9, 0}, {x, 9, 0}, {9, 0, 0.5f}, {9, 0, -2}}, {0, 2, 1, 0, 1, 3});
        const std::optional<PixelEdge> edge = edgeAt(raysOf({fold, wall(-3.0f)}), {320.5, kMiddleRow});
        QVERIFY(edge);
        QVERIFY2(std::abs(edge->behind - 3.0) < 0.05, qPrintable(QString::number(edge->behind)));
    }

    void creasesAndRoughnessAreNone()
    {
        // Two triangles that meet along x = 0.25 pixels, one to the left and one to the right.
        const float x = 0.25f / 64.0f;
        const auto crease = modelOf({{x, -9, 0}, {x, 9, 0}, {9, 0, -2}, {-9, 0, -2}}, {0, 2, 1, 0, 1, 3});
        QVERIFY(!edgeAt(raysOf({crease}), {320.5, kMiddleRow}));
        // A step of half a pixel's width, and of two.
        QVERIFY(!edgeAt(raysOf({wall(0.0f, x), wall(-0.5f / 64.0f)}), {320.5, kMiddleRow}));
        QVERIFY(edgeAt(raysOf({wall(0.0f, x), wall(-2.0f / 64.0f)}), {320.5, kMiddleRow}));
    }

    void hiddenEdgesAreNone()
    {
        QVERIFY(!edgeAt(raysOf({wall(1.0f), wall(0.0f, 0.25f / 64.0f), wall(-2.0f)}), {320.5, kMiddleRow}));
    }

    void cutsAreEdges()
    {
        const float x = 0.25f / 64.0f;
        // Keeps x > 0.25 pixels of the front wall, and all of the back wall as it is behind the plane's foot.
        const SceneRays rays = raysOf({wall(0.0f)}, {glm::dvec4(1.0, 0.0, 0.0, -x)});
        for (const double row : {kMiddleRow, 300.5}) { // in one triangle each
            const std::optional<PixelEdge> edge = edgeAt(rays, {320.5, row});
            QVERIFY(edge);
            QVERIFY(!edge->object);
            QVERIFY(!edgeAt(raysOf({wall(0.0f)}), {320.5, row}));
        }
        // A slope that the near plane, at z = 4, cuts at 0.25 pixels; behind it lies a wall.
        const float c = 0.25f / 320.0f;
        const auto slope =
            modelOf({{-9, -9, 13 + c}, {9, -9, -5 + c}, {9, 9, -5 + c}, {-9, 9, 13 + c}}, {0, 1, 2, 0, 2, 3});
        const std::optional<PixelEdge> atNear = edgeAt(raysOf({slope, wall(-2.0f)}), {320.5, kMiddleRow});
        QVERIFY(atNear);
        QCOMPARE(atNear->object, std::optional<std::size_t>(1));
    }

    void theFarthestOtherSurfaceIsTold()
    {
        // Within the pixel, from left to right: the background beyond the last wall's rim, and three walls.
        const auto at = [](double pixel) { return static_cast<float>(pixel / 64.0); };
        const SceneRays rays = raysOf({wall(0.0f, at(0.4)), wall(-1.0f, at(0.3)), wall(-2.0f, at(0.2))}, {}, true);
        const std::optional<PixelEdge> edge = edgeAt(rays, {320.5, kMiddleRow});
        QVERIFY(edge);
        QCOMPARE(edge->object, std::optional<std::size_t>(2));
        QVERIFY(std::abs(edge->behind - 2.0) < 1e-9);
    }

    void edgesAreFoundAsADenseGridOfRaysFindsThem_data()
    {
        addColumn<std::shared_ptr<const Model>>("model");

        newRow("head") << examples::bundledModels().at("Head");
        newRow("teapot") << examples::bundledModels().at("Teapot");
        newRow("sphere") << std::shared_ptr<const Model>(cubeSphere(40, 0.0));
        newRow("hills") << std::shared_ptr<const Model>(cubeSphere(60, 0.1));
        newRow("soup") << std::shared_ptr<const Model>(soup(2'000, 3));
    }

    void edgesAreFoundAsADenseGridOfRaysFindsThem()
    {
        QFETCH(std::shared_ptr<const Model>, model);
        const EdgeRates rates = edgeRates(model, 6, 15, 7, 32);
        const QString told = QStringLiteral("%1 of %2 found, %3 of %4 wrongly, %5 at a wrong distance")
                                 .arg(rates.found)
                                 .arg(rates.withEdge)
                                 .arg(rates.wronglyFound)
                                 .arg(rates.plain)
                                 .arg(rates.wrongDistance);
        QVERIFY2(rates.withEdge >= 10, qPrintable(told));
        QVERIFY2(100 * rates.found >= 99 * rates.withEdge, qPrintable(told));
        QVERIFY2(100 * rates.wronglyFound <= rates.plain, qPrintable(told));
        QVERIFY2(50 * rates.wrongDistance <= rates.found, qPrintable(told));
    }
};

UNPROJECTOR_TEST(TestPixelEdge, unsanitized)
#include "test_pixel_edge.moc"
