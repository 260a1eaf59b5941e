// Polygons cut into triangles: their total area is the polygon's, and each triangle turns the same
// way.

#include "tests/support/test.h"

#include "core/mesh/import/polygon_triangulation.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <vector>

using namespace unprojector::mesh;

using Outline = std::vector<glm::vec3>;
Q_DECLARE_METATYPE(Outline)

/// A band that winds outwards, with a tooth at every corner of its outer edge.
static Outline toothedSpiral(int cornersAlong)
{
    Outline outline;
    const double turns = 5.0;
    const auto at = [&](int i, double width) {
        const double t = double(i) / cornersAlong;
        const double angle = turns * 2.0 * std::numbers::pi * t;
        const double radius = 1.0 + turns * t + width;
        return glm::vec3(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    };
    for (int i = 0; i < cornersAlong; ++i)
        outline.push_back(at(i, i % 2 == 0 ? 0.6 : 0.4));
    for (int i = cornersAlong - 1; i >= 0; --i)
        outline.push_back(at(i, 0.0));
    return outline;
}

static Outline star(int corners)
{
    Outline outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners, radius = i % 2 == 0 ? 2.0 : 1.0;
        outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
    return outline;
}

/// Long teeth from both sides that reach past each other.
static Outline combs(int teeth)
{
    Outline outline;
    for (int i = 0; i < teeth; ++i) {
        outline.emplace_back(i, 0.0, 0.0);
        outline.emplace_back(i + 0.5, 90.0, 0.0);
    }
    outline.emplace_back(teeth, 0.0, 0.0);
    for (int i = teeth; i > 0; --i) {
        outline.emplace_back(i, 100.0, 0.0);
        outline.emplace_back(i - 0.5, 95.0, 0.0);
    }
    outline.emplace_back(0.0, 100.0, 0.0);
    return outline;
}

static double areaOf(const Outline &outline)
{
    glm::dvec3 area(0.0);
    for (std::size_t i = 0; i < outline.size(); ++i)
        area += glm::cross(glm::dvec3(outline[i]), glm::dvec3(outline[(i + 1) % outline.size()])) / 2.0;
    return glm::length(area);
}

class TestPolygonTriangulation : public QObject {
    Q_OBJECT

private slots:
    void coversThePolygonOnce_data()
    {
        addColumn<Outline>("outline");
        const auto turned = [](Outline outline) {
            for (glm::vec3 &corner : outline)
                corner = {corner.z + 7.0f, corner.y, corner.x + 0.5f * corner.y};
            return outline;
        };
        const auto reversed = [](const Outline &outline) { return Outline(outline.rbegin(), outline.rend()); };
        newRow("triangle") << Outline{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        newRow("arrow head") << Outline{{0, 1, 0}, {-1, -1, 0}, {0, 0, 0}, {1, -1, 0}};
        newRow("arrow head from its dent") << Outline{{0, 0, 0}, {1, -1, 0}, {0, 1, 0}, {-1, -1, 0}};
        newRow("corners on an edge") << Outline{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}};
        newRow("star of 40 corners") << star(40);
        newRow("star of 700 corners") << star(700);
        newRow("star of 700 corners, standing") << turned(star(700));
        newRow("star of 700 corners, clockwise") << reversed(star(700));
        newRow("spiral of 48 corners") << toothedSpiral(24);
        newRow("spiral of 640 corners") << toothedSpiral(320);
        newRow("spiral of 640 corners, clockwise, standing") << turned(reversed(toothedSpiral(320)));
        newRow("spiral of 20000 corners") << toothedSpiral(10000);
        newRow("combs of 800 corners") << combs(200);
    }

    void coversThePolygonOnce()
    {
        QFETCH(Outline, outline);
        PolygonTriangulator triangulator;
        std::vector<std::uint32_t> triangles;
        for (int round = 0; round < 2; ++round) { // the second in the memory of the first
            triangles.clear();
            triangulator.triangulate(outline, triangles);
        }
        QCOMPARE(triangles.size(), 3 * (outline.size() - 2));
        glm::dvec3 sum(0.0);
        double area = 0.0;
        for (std::size_t i = 0; i < triangles.size(); i += 3) {
            const glm::dvec3 a(outline[triangles[i]]), b(outline[triangles[i + 1]]), c(outline[triangles[i + 2]]);
            sum += glm::cross(b - a, c - a) / 2.0;
            area += glm::length(glm::cross(b - a, c - a)) / 2.0;
        }
        // Corners in single precision, of size 8 at most.
        const double expected = areaOf(outline);
        QVERIFY(std::abs(glm::length(sum) - expected) < 1e-6 * expected);
        QVERIFY2(std::abs(area - expected) < 1e-6 * expected, "triangles overlap");
    }

    void makesAFanOfWhatIsConvex()
    {
        Outline circle;
        for (int i = 0; i < 600; ++i)
            circle.emplace_back(std::cos(2.0 * std::numbers::pi * i / 600), std::sin(2.0 * std::numbers::pi * i / 600),
                                1.0);
        for (const std::size_t corners : {std::size_t{3}, std::size_t{4}, std::size_t{5}, circle.size()}) {
            std::vector<std::uint32_t> triangles;
            PolygonTriangulator().triangulate(std::span(circle).first(corners), triangles);
            for (std::uint32_t t = 0; t < corners - 2; ++t) {
                QCOMPARE(triangles[3 * t], 0u);
                QCOMPARE(triangles[3 * t + 1], t + 1);
                QCOMPARE(triangles[3 * t + 2], t + 2);
            }
        }
    }

    void keepsAllTrianglesOfWhatCannotBeCut_data()
    {
        addColumn<Outline>("outline");
        newRow("crossing itself") << Outline{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
        newRow("all corners in one place") << Outline(9, glm::vec3(1.0f));
        newRow("all corners on a line") << Outline{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5f, 0, 0}};
        newRow("many corners on a line") << Outline(100, glm::vec3(0.0f, 1.0f, 2.0f));
        newRow("not finite") << Outline{{0, 0, 0}, {1, NAN, 0}, {1, 1, 0}, {0, INFINITY, 0}};
    }

    void keepsAllTrianglesOfWhatCannotBeCut()
    {
        QFETCH(Outline, outline);
        std::vector<std::uint32_t> triangles;
        PolygonTriangulator().triangulate(outline, triangles);
        QCOMPARE(triangles.size(), 3 * (outline.size() - 2));
        for (const std::uint32_t corner : triangles)
            QVERIFY(corner < outline.size());
    }

    void takesLittleTimeForManyCorners_data()
    {
        addColumn<Outline>("outline");
        newRow("star") << star(200000);
        newRow("spiral") << toothedSpiral(100000);
    }

    void takesLittleTimeForManyCorners()
    {
        QFETCH(Outline, outline);
        // Time that grows with the square is longer than all tests together may take.
        std::vector<std::uint32_t> triangles;
        PolygonTriangulator().triangulate(outline, triangles);
        QCOMPARE(triangles.size(), 3 * (outline.size() - 2));
    }
};

UNPROJECTOR_TEST(TestPolygonTriangulation, threads)
#include "test_polygon_triangulation.moc"
