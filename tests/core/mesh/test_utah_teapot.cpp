// The bundled teapot: its patches are the published ones, and its mesh is made of them.

#include "tests/support/test.h"

#include "core/examples/solids.h"

#include "tests/core/mesh/mesh_measures.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

using namespace mesh_measures;
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::mesh;

namespace {

bool hasVertexAt(const Mesh &mesh, const glm::dvec3 &point)
{
    return std::any_of(mesh.positions.begin(), mesh.positions.end(),
                       [&](const glm::vec3 &position) { return isNear(glm::dvec3(position), point); });
}

} // namespace

Q_DECLARE_METATYPE(glm::dvec3)

class TestUtahTeapot : public QObject {
    Q_OBJECT

private slots:
    void teapotHas32PatchesOf290DifferentPoints()
    {
        std::set<Place> points;
        Box box;
        const std::vector<examples::BezierPatch> patches = examples::utahTeapotPatches();
        for (const examples::BezierPatch &patch : patches) {
            for (const auto &row : patch) {
                for (const glm::dvec3 &point : row) {
                    points.insert(place(point));
                    box.add(point);
                }
            }
        }
        QCOMPARE(patches.size(), std::size_t(32));
        QCOMPARE(points.size(), std::size_t(290)); // 306 in the published list, which repeats 16
        QVERIFY(isNear(box.lowest, {-3.0, 0.0, -2.0}));
        QVERIFY(isNear(box.highest, {3.525, 3.15, 2.0}));
    }

    void teapotControlPointsAreThePublishedOnes_data()
    {
        addColumn<int>("patchNumber"); // as published, from 1
        addColumn<int>("row");
        addColumn<int>("column");
        addColumn<glm::dvec3>("published"); // z up

        newRow("rim") << 1 << 1 << 1 << glm::dvec3(1.3375, -0.749, 2.53125);
        newRow("rim, second quarter") << 2 << 2 << 2 << glm::dvec3(-1.4375, -0.805, 2.53125);
        newRow("upper body, third quarter") << 7 << 1 << 1 << glm::dvec3(-1.75, 0.98, 1.875);
        newRow("lower body, fourth quarter") << 12 << 2 << 1 << glm::dvec3(0.84, 1.5, 0.225);
        newRow("handle, front") << 13 << 1 << 2 << glm::dvec3(-2.5, -0.3, 2.25);
        newRow("handle, back") << 16 << 2 << 1 << glm::dvec3(-2.65, 0.3, 0.9375);
        newRow("spout, front") << 17 << 1 << 2 << glm::dvec3(3.1, -0.66, 0.825);
        newRow("spout, back") << 20 << 1 << 0 << glm::dvec3(3.525, 0.0, 2.49375);
        newRow("knob's top") << 22 << 0 << 3 << glm::dvec3(0.0, 0.0, 3.15);
        newRow("knob") << 21 << 1 << 1 << glm::dvec3(0.8, -0.45, 3.15);
        newRow("lid") << 28 << 1 << 2 << glm::dvec3(0.4, 0.224, 2.55);
        newRow("bottom") << 29 << 1 << 1 << glm::dvec3(1.425, 0.798, 0.0);
        newRow("bottom, second quarter") << 30 << 2 << 3 << glm::dvec3(-1.5, 0.0, 0.075);
    }

    void teapotControlPointsAreThePublishedOnes()
    {
        QFETCH(int, patchNumber);
        QFETCH(int, row);
        QFETCH(int, column);
        QFETCH(glm::dvec3, published);
        const glm::dvec3 point = examples::utahTeapotPatches().at(patchNumber - 1).at(row).at(column);
        QCOMPARE(point, glm::dvec3(published.x, published.z, -published.y)); // no arithmetic, no rounding
    }

    void teapotPassesThrough_data()
    {
        // A cubic at its middle is (P0 + 3 P1 + 3 P2 + P3) / 8, worked out by hand from the published
        // points.
        addColumn<glm::dvec3>("point");
        newRow("upper body") << glm::dvec3(1.84375, 1.621875, 0.0);
        newRow("upper body, to the front") << glm::dvec3(0.0, 1.621875, 1.84375);
        newRow("upper body, to the back") << glm::dvec3(0.0, 1.621875, -1.84375);
        newRow("spout, upper edge") << glm::dvec3(2.3875, 1.8, 0.0);
        newRow("handle, outer edge") << glm::dvec3(-2.625, 2.19375, 0.0);
        newRow("handle, front") << glm::dvec3(-2.51875, 2.0953125, 0.225);
        newRow("handle, back") << glm::dvec3(-2.51875, 2.0953125, -0.225);
        newRow("knob") << glm::dvec3(0.325, 2.98125, 0.0);
        newRow("bottom") << glm::dvec3(-1.284375, 0.046875, 0.0);
    }

    void teapotPassesThrough()
    {
        QFETCH(glm::dvec3, point);
        QVERIFY(hasVertexAt(examples::utahTeapotMesh(kTeapotDivisions), point));
    }

    void teapotReachesAsFarAsPublished()
    {
        const Box box = boundsOf({examples::utahTeapotMesh(kTeapotDivisions)});
        QVERIFY(isNear(box.lowest, {-3.0, 0.0, -2.0}));
        // The spout's lip stays short of its control points, 3.525: its cubic at 4/10.
        QVERIFY(isNear(box.highest, {3.434, 3.15, 2.0}));
    }

    void teapotTriangleCount_data()
    {
        addColumn<int>("divisions");
        addColumn<std::size_t>("triangles");
        newRow("two") << 2 << std::size_t(240);
        newRow("ten") << 10 << std::size_t(6320);
    }

    void teapotTriangleCount()
    {
        QFETCH(int, divisions);
        QFETCH(std::size_t, triangles);
        QCOMPARE(examples::utahTeapotMesh(divisions).triangleCount(), triangles);
    }

    void teapotPointsUpAtTheKnobAndDownAtTheBottom()
    {
        const Mesh mesh = examples::utahTeapotMesh(kTeapotDivisions);
        int tops = 0;
        int bottoms = 0;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            if (isNear(glm::dvec3(mesh.positions[i]), {0.0, 3.15, 0.0})) {
                ++tops;
                QVERIFY(isNear(glm::dvec3(mesh.normals[i]), {0.0, 1.0, 0.0}));
            } else if (isNear(glm::dvec3(mesh.positions[i]), {0.0, 0.0, 0.0})) {
                ++bottoms;
                QVERIFY(isNear(glm::dvec3(mesh.normals[i]), {0.0, -1.0, 0.0}));
            }
        }
        QCOMPARE(tops, 4 * (kTeapotDivisions + 1));
        QCOMPARE(bottoms, 4 * (kTeapotDivisions + 1));
    }

    void teapotIsOpenOnlyWhereItWasIn1975()
    {
        const auto edges = directedEdges(examples::utahTeapotMesh(kTeapotDivisions));
        int slit = 0;
        int handleEnds = 0;
        int spoutEnds = 0;
        int elsewhere = 0;
        for (const auto &[edge, count] : edges) {
            if (edges.contains({edge.second, edge.first}))
                continue;
            const auto [x, y, z] = edge.first;
            const double radius = std::hypot(double(x), double(z));
            if (std::abs(y - 2.4) < 1e-6 && radius < 1.45)
                ++slit;
            else if (x < -1.4 && std::abs(z) < 0.3)
                ++handleEnds;
            else if (x > 1.6 && std::abs(z) < 0.6)
                ++spoutEnds;
            else
                ++elsewhere;
        }
        QCOMPARE(slit, 2 * 4 * kTeapotDivisions); // rim and lid, four quarters each
        QCOMPARE(handleEnds, 2 * 2 * kTeapotDivisions);
        QCOMPARE(spoutEnds, 2 * 2 * kTeapotDivisions);
        QCOMPARE(elsewhere, 0);
    }

    void teapotNormalsPointAwayFromTheAxis()
    {
        const Mesh mesh = examples::utahTeapotMesh(kTeapotDivisions);
        const std::size_t perPatch = std::size_t(kTeapotDivisions + 1) * (kTeapotDivisions + 1);
        for (std::size_t i = 4 * perPatch; i < 12 * perPatch; ++i) { // the body's eight patches
            const glm::dvec3 p(mesh.positions[i]);
            QVERIFY(glm::dot(glm::dvec3(mesh.normals[i]), glm::dvec3(p.x, 0.0, p.z)) > 0.0);
        }
        QVERIFY(signedVolume(mesh) > 0.0);
    }
};

UNPROJECTOR_TEST(TestUtahTeapot)
#include "test_utah_teapot.moc"
