// Meshes far from their object's origin: the digits that they keep.

#include "tests/support/test.h"

#include "core/mesh/mesh.h"

#include <cmath>
#include <random>
#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::mesh;

Q_DECLARE_METATYPE(glm::dvec3)

class TestMeshOrigin : public QObject {
    Q_OBJECT

private slots:
    void originLiesInAFarBox_data()
    {
        addColumn<glm::dvec3>("lowest");
        addColumn<glm::dvec3>("highest");
        addColumn<glm::dvec3>("expected");

        newRow("about zero") << glm::dvec3(-1.0) << glm::dvec3(1.0) << glm::dvec3(0.0);
        newRow("beside zero") << glm::dvec3(0.0) << glm::dvec3(2.0) << glm::dvec3(0.0);
        newRow("as far as it is wide") << glm::dvec3(0.5) << glm::dvec3(1.5) << glm::dvec3(0.0);
        newRow("far along one axis") << glm::dvec3(999.0, -1.0, 0.0) << glm::dvec3(1001.0, 1.0, 2.0)
                                     << glm::dvec3(1000.0, 0.0, 0.0);
        newRow("a survey's") << glm::dvec3(4e6, 5e5, 300.0) << glm::dvec3(4e6 + 2.0, 5e5 + 4.0, 302.0)
                             << glm::dvec3(4e6 + 1.0, 5e5 + 2.0, 301.0);
        newRow("the middle is no float") << glm::dvec3(4e6 + 0.1) << glm::dvec3(4e6 + 0.1)
                                         << glm::dvec3(static_cast<double>(static_cast<float>(4e6 + 0.1)));
        newRow("a point at zero") << glm::dvec3(0.0) << glm::dvec3(0.0) << glm::dvec3(0.0);
        newRow("empty") << glm::dvec3(1.0) << glm::dvec3(-1.0) << glm::dvec3(0.0);
    }

    void originLiesInAFarBox()
    {
        QFETCH(glm::dvec3, lowest);
        QFETCH(glm::dvec3, highest);
        QFETCH(glm::dvec3, expected);
        const glm::dvec3 origin = originFor({lowest, highest});
        for (int axis = 0; axis < 3; ++axis)
            QCOMPARE(origin[axis], expected[axis]);
    }

    void floatsKeepAllBits()
    {
        std::mt19937_64 random(20261122);
        const auto uniform = [&random](double from, double to) {
            return std::uniform_real_distribution<double>(from, to)(random);
        };
        for (int box = 0; box < 200; ++box) {
            const glm::dvec3 middle(uniform(-1.0, 1.0) * std::exp2(uniform(-10.0, 25.0)), uniform(-5.0, 5.0),
                                    uniform(0.0, 9.0));
            const double width = std::exp2(uniform(-12.0, 12.0));
            std::vector<glm::dvec3> positions;
            Box bounds;
            for (int i = 0; i < 100; ++i) {
                const glm::dvec3 offset(uniform(-0.5, 0.5), uniform(-0.5, 0.5), uniform(-0.5, 0.5));
                positions.emplace_back(glm::vec3(middle + width * offset));
                bounds.add(positions.back());
            }
            Mesh mesh;
            setPositions(mesh, originFor(bounds), positions);
            for (std::size_t v = 0; v < positions.size(); ++v)
                QVERIFY(mesh.position(v) == positions[v]);
        }
    }

    void doublesKeepAllBits()
    {
        std::vector<glm::dvec3> positions;
        Box bounds;
        for (int i = 0; i < 1000; ++i) {
            positions.emplace_back(4e6 + 0.001 * i, 5e5 + 0.0007 * i, 300.0 + 0.0003 * i);
            bounds.add(positions.back());
        }
        Mesh mesh;
        setPositions(mesh, originFor(bounds), positions);
        for (std::size_t v = 0; v < positions.size(); ++v)
            QVERIFY(mesh.position(v) == positions[v]);
    }

    void boundsAreOfTheObject()
    {
        Mesh mesh;
        mesh.origin = {1e6, 0.0, -1e6};
        mesh.positions = {{-1.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 2.0f, 3.0f}, {99.0f, 99.0f, 99.0f}};
        mesh.indices = {0, 1, 2};
        const Box bounds = boundsOf(std::vector{mesh});
        QVERIFY(bounds.lowest == glm::dvec3(1e6 - 1.0, 0.0, -1e6));
        QVERIFY(bounds.highest == glm::dvec3(1e6 + 1.0, 2.0, -1e6 + 3.0));
    }
};

UNPROJECTOR_TEST(TestMeshOrigin)
#include "test_mesh_origin.moc"
