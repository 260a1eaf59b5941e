// The bundled head: closed, its two sides alike, and a face in the right position.

#include "tests/support/test.h"

#include "core/examples/solids.h"

#include "tests/core/mesh/mesh_measures.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

using namespace mesh_measures;
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::mesh;

class TestHead : public QObject {
    Q_OBJECT

private slots:
    void isClosedAndSeenFromOutside()
    {
        const Mesh head = examples::headMesh();
        const auto edges = directedEdges(head);
        for (const auto &[edge, count] : edges) {
            QCOMPARE(count, 1);
            QVERIFY(edges.contains({edge.second, edge.first}));
        }
        // The egg alone has 4/3 pi a b c = 3.2.
        const double volume = signedVolume(head);
        QVERIFY2(volume > 2.5 && volume < 3.5, qPrintable(QString::number(volume)));
    }

    void leftMirrorsRight()
    {
        // Rounded to a hundredth of the smallest distance of two vertices, so that the last bits of
        // sines do not count.
        const auto rounded = [](const glm::dvec3 &p) {
            const auto units = [](double value) { return std::lround(value * 1e5); };
            return std::array{units(p.x), units(p.y), units(p.z)};
        };
        const auto isIn = [](const std::set<std::array<long, 3>> &places, std::array<long, 3> place) {
            for (const long x : {-1, 0, 1}) {
                for (const long y : {-1, 0, 1}) {
                    for (const long z : {-1, 0, 1}) {
                        if (places.contains({place[0] + x, place[1] + y, place[2] + z}))
                            return true;
                    }
                }
            }
            return false;
        };
        const Mesh head = examples::headMesh();
        std::set<std::array<long, 3>> places;
        for (std::size_t i = 0; i < head.positions.size(); ++i)
            places.insert(rounded(head.position(i)));
        for (std::size_t i = 0; i < head.positions.size(); ++i)
            QVERIFY(isIn(places, rounded(head.position(i) * glm::dvec3(-1.0, 1.0, 1.0))));
    }

    void isAsLargeAsSaid()
    {
        const Box box = boundsOf({examples::headMesh()});
        const glm::dvec3 size = box.highest - box.lowest;
        QVERIFY2(std::abs(size.x - 1.8) < 0.1, qPrintable(QString::number(size.x)));
        QVERIFY2(std::abs(size.y - 2.05) < 0.1, qPrintable(QString::number(size.y)));
    }

    void noseIsForemostAndEyesLieDeep()
    {
        const Mesh head = examples::headMesh();
        // The depth seen from in front at a position of the face.
        const auto depthAt = [&head](double x, double y) {
            double foremost = -1.0;
            for (std::size_t i = 0; i < head.positions.size(); ++i) {
                const glm::dvec3 p = head.position(i);
                if (std::hypot(p.x - x, p.y - y) < 0.02)
                    foremost = std::max(foremost, p.z);
            }
            return foremost;
        };
        const auto foremost =
            std::max_element(head.positions.begin(), head.positions.end(), [](auto &a, auto &b) { return a.z < b.z; });
        QVERIFY(std::abs(foremost->x) < 0.02f);
        QVERIFY(foremost->y < -0.1f && foremost->y > -0.25f);
        const double tip = depthAt(0.0, -0.18);
        for (const double side : {-1.0, 1.0}) {
            QVERIFY(depthAt(side * 0.34, 0.32) > depthAt(side * 0.34, 0.25)); // the brow stands out over the eye
            QVERIFY(tip > depthAt(side * 0.34, 0.17) + 0.3);
            QVERIFY(depthAt(side * 0.115, -0.2) < tip); // a wing of the nose lies behind its tip
        }
        QVERIFY(depthAt(0.0, -0.42) > depthAt(0.0, -0.475)); // the lips stand out from the line between them
        QVERIFY(depthAt(0.0, -0.8) > depthAt(0.0, -0.65));   // the chin from the fold above it
    }

    void hasNoFoldsInItsFace()
    {
        const Mesh head = examples::headMesh();
        for (std::size_t number = 0; number < head.triangleCount(); ++number) {
            const auto t = triangle(head, number);
            const glm::dvec3 middle = (t[0] + t[1] + t[2]) / 3.0;
            if (middle.z > 0.6)
                QVERIFY(glm::cross(t[1] - t[0], t[2] - t[0]).z > 0.0);
        }
    }
};

UNPROJECTOR_TEST(TestHead)
#include "test_head.moc"
