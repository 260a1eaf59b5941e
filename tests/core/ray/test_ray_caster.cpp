// Rays on a model: the same answers as testing every triangle, with Embree and without.

#include "tests/support/test.h"

#include "core/ray/box_tree.h"
#include "tests/core/ray/ray_meshes.h"

#include "tests/support/cube_sphere.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

namespace {

using namespace ray_meshes;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace unprojector::ray;
using Tree = RayCaster::Tree;

std::shared_ptr<const RayCaster> built(const std::shared_ptr<const Model> &model, Tree tree)
{
    return RayCaster::build(model, {}, tree);
}

void eachTree()
{
    addColumn<Tree>("tree");
    newRow("fastest") << Tree::Fastest;
    newRow("plain") << Tree::Plain;
}

std::array<glm::dvec3, 3> placedCorners(const Model &model, std::uint32_t triangle)
{
    const auto corners = cornersOf(model.meshes[0], triangle);
    const glm::dvec3 &origin = model.meshes[0].origin;
    return {corners[0] + origin, corners[1] + origin, corners[2] + origin};
}

} // namespace

Q_DECLARE_METATYPE(Tree)

/// Under a sanitizer each takes fifty times as long.
#ifdef UNPROJECTOR_IS_SANITIZED
constexpr int kFewer = 10;
#else
constexpr int kFewer = 1;
#endif

class TestRayCaster : public QObject {
    Q_OBJECT

private slots:
    void answersAreThoseOfTestingAll_data() { eachTree(); }

    void answersAreThoseOfTestingAll()
    {
        QFETCH(Tree, tree);
        const auto model = soup(500, 5);
        const auto caster = built(model, tree);
        Aim aim(6);
        int hits = 0;
        for (int i = 0; i < 100'000 / kFewer; ++i) {
            // A tenth of them aimed at corners, where several triangles may be met at once.
            const glm::dvec3 target =
                i % 10 == 0 ? model->meshes[0].position(aim.below(1500)) : aim.share() * aim.direction();
            const Ray<ObjectSpace> ray = aim.at(target, glm::dvec3(0.0), 4.0 * aim.share());
            const auto expected = testingAll(*model, ray);
            hits += expected ? 1 : 0;
            QVERIFY2(isSame(caster->nearestTriangle(ray), expected), qPrintable(QString::number(i)));
        }
        QVERIFY(hits > 10'000 / kFewer && hits < 90'000 / kFewer);
    }

    void severalMeshesAreCountedThrough_data() { eachTree(); }

    void severalMeshesAreCountedThrough()
    {
        QFETCH(Tree, tree);
        auto model = std::make_shared<Model>();
        for (int k = 0; k < 3; ++k) {
            Mesh mesh = soup(300, 7 + std::uint64_t(k))->meshes[0];
            mesh.origin = glm::dvec3(0.7 * k, 1000.0 * (k == 2 ? 1e-3 : 0.0), 0.0);
            model->meshes.push_back(mesh);
        }
        model->meshes.insert(model->meshes.begin() + 1, Mesh{}); // one that holds nothing
        Mesh points;
        points.kind = Mesh::Kind::Points;
        points.positions = {glm::vec3(0.0f), glm::vec3(5.0f)};
        model->meshes.push_back(points);
        model->bounds = boundsOf(model->meshes);
        const auto caster = built(model, tree);
        QCOMPARE(caster->triangleNumbers().count(), 900u);
        QCOMPARE(caster->triangleNumbers().place(600).mesh, 3u);
        Aim aim(8);
        int last = 0;
        for (int i = 0; i < 20'000 / kFewer; ++i) {
            const Ray<ObjectSpace> ray = aim.at(glm::dvec3(1.4 * aim.share(), aim.share(), 0.0), glm::dvec3(0.0), 3.0);
            const auto expected = testingAll(*model, ray);
            last += expected && expected->triangle >= 600 ? 1 : 0;
            QVERIFY(isSame(caster->nearestTriangle(ray), expected));
        }
        QVERIFY(last > 100 / kFewer);
    }

    void meshesOfFloatsBesideMeshesOfDoubles_data() { eachTree(); }

    /// Each mesh has many packets, the last one partly filled, and a ray passes packets of all meshes.
    void meshesOfFloatsBesideMeshesOfDoubles()
    {
        QFETCH(Tree, tree);
        constexpr std::uint32_t kTriangles = 203, kMeshes = 4;
        for (const std::uint32_t firstOfDoubles : {0u, 1u}) {
            auto model = std::make_shared<Model>();
            for (std::uint32_t k = 0; k < kMeshes; ++k) {
                Mesh mesh = soup(kTriangles, 15 + k)->meshes[0];
                QCOMPARE(mesh.remainders.size(), mesh.positions.size());
                if (k % 2 != firstOfDoubles)
                    mesh.remainders.clear();
                model->meshes.push_back(std::move(mesh));
            }
            model->bounds = boundsOf(model->meshes);
            const auto caster = built(model, tree);
            Aim aim(16);
            std::array<int, kMeshes> hits{};
            for (int i = 0; i < 10'000 / kFewer; ++i) {
                // A tenth of them aimed at corners, which the remainders move.
                const glm::dvec3 target = i % 10 == 0
                                              ? model->meshes[aim.below(kMeshes)].position(aim.below(3 * kTriangles))
                                              : aim.share() * aim.direction();
                const Ray<ObjectSpace> ray = aim.at(target, glm::dvec3(0.0), 3.0);
                const auto expected = testingAll(*model, ray);
                if (expected)
                    ++hits[expected->triangle / kTriangles];
                QVERIFY2(isSame(caster->nearestTriangle(ray), expected), qPrintable(QString::number(i)));
            }
            QVERIFY(*std::min_element(hits.begin(), hits.end()) > 500 / kFewer);
        }
    }

    void nothingSlipsThroughAClosedSurface_data()
    {
        addColumn<std::shared_ptr<Model>>("model");
        addColumn<Tree>("tree");
        const auto sphere = cubeSphere(60);
        const auto distant = std::make_shared<Model>(*cubeSphere(60));
        distant->meshes[0].origin = {4e6, 5e5, 300.0};
        distant->bounds = boundsOf(distant->meshes);
        newRow("hilly sphere, fastest") << sphere << Tree::Fastest;
        newRow("hilly sphere, plain") << sphere << Tree::Plain;
        newRow("far from its origin, fastest") << distant << Tree::Fastest;
        newRow("far from its origin, plain") << distant << Tree::Plain;
    }

    /// Rays through points of edges and through vertices, where two and six triangles meet: a ray from
    /// outside to the middle goes in.
    void nothingSlipsThroughAClosedSurface()
    {
        QFETCH(std::shared_ptr<Model>, model);
        QFETCH(Tree, tree);
        const auto caster = built(model, tree);
        const Mesh &mesh = model->meshes[0];
        Aim aim(9);
        int missed = 0;
        for (int i = 0; i < 1'000'000 / kFewer; ++i) {
            const std::size_t first = 3 * aim.below(mesh.triangleCount());
            const glm::dvec3 a = mesh.position(mesh.vertexAt(first)), b = mesh.position(mesh.vertexAt(first + 1));
            const double share = i % 3 == 0 ? 0.0 : i % 3 == 1 ? 0.5 : aim.share();
            const glm::dvec3 target = a + share * (b - a);
            // The ray continues through the middle: whichever side of the edge it passes, it goes in.
            Ray<ObjectSpace> ray{ObjectPoint(target + (3.0 + aim.share()) * (target - mesh.origin)), {}, 0.0, 2.0};
            ray.along = ObjectVector(mesh.origin - ray.from.coordinates());
            const auto hit = caster->nearestTriangle(ray);
            missed += hit && hit->t < 1.0 ? 0 : 1;
        }
        QCOMPARE(missed, 0);
    }

    void hitsLieOnTheRayAndTheTriangle_data()
    {
        addColumn<std::shared_ptr<Model>>("model");
        newRow("sphere") << cubeSphere(200, 0.0);
        newRow("torus") << torus(300);
        newRow("cube") << modelOf(
            {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}},
            {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
             2, 3, 7, 2, 7, 6, 1, 2, 6, 1, 6, 5, 0, 4, 7, 0, 7, 3});
    }

    void hitsLieOnTheRayAndTheTriangle()
    {
        QFETCH(std::shared_ptr<Model>, model);
        const auto caster = built(model, Tree::Fastest);
        Aim aim(10);
        int hits = 0;
        for (int i = 0; i < 20000; ++i) {
            const Ray<ObjectSpace> ray = aim.at(0.9 * aim.direction(), glm::dvec3(0.0), 3.0);
            const auto hit = caster->nearestTriangle(ray);
            if (!hit)
                continue;
            ++hits;
            const auto [a, b, c] = placedCorners(*model, hit->triangle);
            const glm::dvec3 &w = hit->barycentric;
            QVERIFY(w.x >= 0.0 && w.y >= 0.0 && w.z >= 0.0 && std::abs(w.x + w.y + w.z - 1.0) < 1e-15);
            const glm::dvec3 point = w.x * a + w.y * b + w.z * c;
            const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
            QVERIFY(std::abs(glm::dot(point - a, normal)) < 1e-12);
            const glm::dvec3 along = glm::normalize(ray.along.coordinates());
            // A ray that grazes the triangle has its distance known only to the sine of their angle.
            const double slope = std::abs(glm::dot(along, normal));
            const glm::dvec3 off = point - ray.at(hit->t).coordinates();
            QVERIFY(glm::length(off) < 1e-12 / slope);
            QVERIFY(glm::length(glm::cross(point - ray.from.coordinates(), along)) < 1e-12);
        }
        QVERIFY(hits > 15000);
    }

    void ofTwoAtOnePlaceTheFirstIsHit_data() { eachTree(); }

    void ofTwoAtOnePlaceTheFirstIsHit()
    {
        QFETCH(Tree, tree);
        // Four copies of a square of two triangles: numbers 0 to 7.
        std::vector<std::uint32_t> indices;
        for (int copy = 0; copy < 4; ++copy)
            indices.insert(indices.end(), {0, 1, 2, 0, 2, 3});
        const auto model = modelOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, indices);
        const auto caster = built(model, tree);
        const auto hitAt = [&](double x, double y) {
            return caster->nearestTriangle({ObjectPoint(x, y, 1.0), ObjectVector(0.0, 0.0, -1.0), 0.0, 2.0});
        };
        QCOMPARE(hitAt(0.75, 0.25)->triangle, 0u);
        QCOMPARE(hitAt(0.25, 0.75)->triangle, 1u);
        QCOMPARE(hitAt(0.5, 0.5)->triangle, 0u); // on their common edge
        QCOMPARE(hitAt(0.0, 0.0)->triangle, 0u);
        QCOMPARE(hitAt(1.0, 0.5)->triangle, 0u); // on the rim
        QCOMPARE(hitAt(0.5, 0.5)->t, 1.0);
        QVERIFY(!hitAt(1.0 + 1e-15, 0.5));
    }

    void trianglesWithoutAnAreaAreNotHit_data() { eachTree(); }

    void trianglesWithoutAnAreaAreNotHit()
    {
        QFETCH(Tree, tree);
        const auto model = modelOf({{0, 0, 0.5},
                                    {1, 0, 0.5},
                                    {0.5, 0, 0.5}, // a line
                                    {0.5, 0, 0.6},
                                    {0.5, 0, 0.6},
                                    {0.5, 0, 0.6}, // a point
                                    {0.5, 0, 0.9},
                                    {0.5, 0, 0.1},
                                    {0.5, 0.5, 0.4}, // seen edge on
                                    {0, -1, 0},
                                    {1, -1, 0},
                                    {0.5, 1, 0}});
        const auto hit =
            built(model, tree)->nearestTriangle({ObjectPoint(0.5, 0.0, 1.0), ObjectVector(0.0, 0.0, -1.0)});
        QVERIFY(hit.has_value());
        QCOMPARE(hit->triangle, 3u);
    }

    /// The three edges nearly cancel: rounded, they would give any position of the ray between the
    /// corners.
    void trianglesSeenEdgeOnButForARounding()
    {
        Aim aim(13);
        int hits = 0;
        for (int i = 0; i < 20000; ++i) {
            std::array<glm::dvec3, 3> corners;
            for (glm::dvec3 &corner : corners)
                corner = glm::dvec3(glm::vec3(aim.direction()));
            const glm::dvec3 side = corners[1] - corners[0], other = corners[2] - corners[0];
            const glm::dvec3 from = corners[0] + 2.0 * side + (1.0 + aim.share()) * other;
            const glm::dvec3 along = corners[0] + 0.3 * side + 0.4 * other - from;
            const auto crossing = LineCrossing(from, along).with(corners[0], corners[1], corners[2]);
            if (!crossing)
                continue;
            ++hits;
            const glm::dvec3 &w = crossing->barycentric;
            const glm::dvec3 point = w.x * corners[0] + w.y * corners[1] + w.z * corners[2];
            QVERIFY(glm::length(glm::cross(point - from, glm::normalize(along))) < 1e-14);
        }
        QVERIFY(hits > 1000);
    }

    void onlyThePartOfTheRayCounts_data() { eachTree(); }

    void onlyThePartOfTheRayCounts()
    {
        QFETCH(Tree, tree);
        const auto model = modelOf({{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}, {-1, -1, 1}, {3, -1, 1}, {-1, 3, 1}});
        const auto caster = built(model, tree);
        const auto hit = [&](double low, double high) {
            return caster->nearestTriangle({ObjectPoint(0.0, 0.0, 2.0), ObjectVector(0.0, 0.0, -1.0), low, high});
        };
        QCOMPARE(hit(0.0, 5.0)->triangle, 1u);
        QCOMPARE(hit(1.0, 5.0)->triangle, 1u);
        QCOMPARE(hit(1.5, 5.0)->triangle, 0u);
        QCOMPARE(hit(1.5, 2.0)->triangle, 0u);
        QCOMPARE(hit(0.0, std::numeric_limits<double>::infinity())->triangle, 1u);
        QVERIFY(!hit(1.5, 1.9));
        QVERIFY(!hit(-5.0, 0.5));
    }

    void axisParallelRaysInTheSidesOfBoxes_data() { eachTree(); }

    void axisParallelRaysInTheSidesOfBoxes()
    {
        QFETCH(Tree, tree);
        // A flat grid: rays in the planes of its boxes' sides, and through every corner.
        std::vector<glm::vec3> positions;
        for (int j = 0; j < 8; ++j) {
            for (int i = 0; i < 8; ++i) {
                const auto x = float(i), y = float(j);
                positions.insert(
                    positions.end(),
                    {{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}});
            }
        }
        const auto model = modelOf(positions);
        const auto caster = built(model, tree);
        for (int j = 0; j <= 8; ++j) {
            for (int i = 0; i <= 8; ++i) {
                const Ray<ObjectSpace> ray{ObjectPoint(double(i), double(j), 3.0), ObjectVector(0.0, -0.0, -1.0), 0.0,
                                           9.0};
                const auto expected = testingAll(*model, ray);
                QVERIFY(expected.has_value());
                QVERIFY(isSame(caster->nearestTriangle(ray), expected));
                // A ray in the plane itself hits nothing.
                QVERIFY(!caster->nearestTriangle(
                    {ObjectPoint(double(i), -1.0, 0.0), ObjectVector(0.0, 1.0, 0.0), 0.0, 20.0}));
            }
        }
    }

    void anEyeFarAwaySeesTheSame_data() { eachTree(); }

    void anEyeFarAwaySeesTheSame()
    {
        QFETCH(Tree, tree);
        const auto model = cubeSphere(40);
        const auto caster = built(model, tree);
        Aim aim(11);
        for (const double distance : {1e2, 1e5, 1e8, 1e11, 1e13}) {
            for (int i = 0; i < 300 / kFewer; ++i) {
                Ray<ObjectSpace> ray = aim.at(0.95 * aim.direction(), glm::dvec3(0.0), distance);
                const auto expected = testingAll(*model, ray);
                QVERIFY2(isSame(caster->nearestTriangle(ray), expected), qPrintable(QString::number(distance)));
            }
        }
    }

    void aBundleFromFarAwayPassesTheSame_data() { eachTree(); }

    /// A bundle of parallel rays from far away passes what its middle meets.
    void aBundleFromFarAwayPassesTheSame()
    {
        QFETCH(Tree, tree);
        const auto model = cubeSphere(40);
        const auto caster = built(model, tree);
        Aim aim(13);
        for (const double distance : {1e2, 1e5, 1e8, 1e11, 1e13}) {
            for (int i = 0; i < 300 / kFewer; ++i) {
                const Ray<ObjectSpace> ray = aim.at(0.95 * aim.direction(), glm::dvec3(0.0), distance);
                const auto met = caster->nearestTriangle(ray);
                if (!met)
                    continue;
                const ObjectVector side(0.01 * glm::normalize(glm::cross(ray.along.coordinates(), aim.direction())));
                RayBundle bundle{ray, {ray, ray, ray, ray}};
                bundle.corners[0].from = ray.from + side;
                bundle.corners[1].from = ray.from + side * -1.0;
                const std::vector<std::uint32_t> passed = caster->trianglesAbout(bundle);
                QVERIFY2(std::binary_search(passed.begin(), passed.end(), met->triangle),
                         qPrintable(QString::number(distance)));
                QVERIFY(distance > 1e10 || passed.size() < model->triangleCount() / 4);
            }
        }
    }

    /// Only the direction of a ray's `along` counts.
    void longAndShortRaysMeetTheSamePlace()
    {
        const auto model = cubeSphere(10);
        const auto caster = built(model, Tree::Plain);
        Aim aim(14);
        for (int i = 0; i < 100; ++i) {
            Ray<ObjectSpace> ray = aim.at(0.5 * aim.direction(), glm::dvec3(0.0), 4.0);
            const auto met = caster->nearestTriangle(ray);
            QVERIFY(met);
            const glm::dvec3 place = preciseBarycentric(model->meshes[0], met->triangle, ray);
            QVERIFY(glm::all(glm::lessThan(glm::abs(place - met->barycentric), glm::dvec3(1e-12))));
            for (const double factor : {0x1p300, 0x1p-300}) {
                ray.along = ray.along * factor;
                QVERIFY(preciseBarycentric(model->meshes[0], met->triangle, ray) == place);
                ray.along = ray.along * (1.0 / factor);
            }
        }
    }

    void sizesOfAnyMagnitude_data()
    {
        addColumn<double>("size");
        for (const double size : {1e-30, 1e-9, 1e9, 1e30})
            newRow(qPrintable(QString::number(size))) << size;
    }

    void sizesOfAnyMagnitude()
    {
        QFETCH(double, size);
        const auto model = cubeSphere(20);
        for (glm::vec3 &position : model->meshes[0].positions)
            position *= float(size);
        model->bounds = boundsOf(model->meshes);
        for (const Tree tree : {Tree::Fastest, Tree::Plain}) {
            const auto caster = built(model, tree);
            Aim aim(12);
            for (int i = 0; i < 1000; ++i) {
                const Ray<ObjectSpace> ray = aim.at(0.9 * size * aim.direction(), glm::dvec3(0.0), 3.0 * size);
                const auto expected = testingAll(*model, ray);
                QVERIFY(expected.has_value());
                QVERIFY(isSame(caster->nearestTriangle(ray), expected));
            }
        }
    }

    void manyAtOnePlaceMakeNoDeepTree_data() { eachTree(); }

    void manyAtOnePlaceMakeNoDeepTree()
    {
        QFETCH(Tree, tree);
        // 20000 times the same triangle, and places that halve and halve again.
        std::vector<glm::vec3> positions;
        for (int i = 0; i < 20000; ++i)
            positions.insert(positions.end(), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
        for (int i = 0; i < 120; ++i) {
            const float x = std::ldexp(1.0f, -i);
            for (int k = 0; k < 40; ++k)
                positions.insert(positions.end(), {{x, 0, 1}, {x, x, 1}, {x * 1.5f, 0, 1}});
        }
        const auto model = modelOf(positions);
        const auto caster = built(model, tree);
        const auto hit = caster->nearestTriangle({ObjectPoint(0.25, 0.7, 3.0), ObjectVector(0.0, 0.0, -1.0), 0.0, 9.0});
        QVERIFY(hit.has_value());
        QCOMPARE(hit->triangle, 0u);
    }

    void buildingTellsItsProgressAndStops_data() { eachTree(); }

    void buildingTellsItsProgressAndStops()
    {
        QFETCH(Tree, tree);
        const auto model = cubeSphere(150);
        double last = 0.0;
        int calls = 0;
        const auto caster = RayCaster::build(
            model,
            [&](double share) {
                const bool isRising = share >= last && share <= 1.0;
                last = share;
                ++calls;
                return isRising;
            },
            tree);
        QVERIFY(caster != nullptr);
        QVERIFY(calls > 1);
        QVERIFY(RayCaster::build(
                    model, [](double) { return false; }, tree)
                == nullptr);
    }

    void aTreeOfBoxesReportsEachPercentAndItsEnd()
    {
        constexpr std::size_t kBoxes = 1000;
        std::vector<BoxTree::Box> boxes;
        for (std::size_t i = 0; i < kBoxes; ++i)
            boxes.push_back({glm::vec3(float(i), 0.0f, 0.0f), glm::vec3(float(i) + 0.5f, 1.0f, 1.0f)});
        std::vector<double> shares;
        BoxTree::build(boxes, 1, [&shares](double share) {
            shares.push_back(share);
            return true;
        });
        QCOMPARE(shares.size(), 100u);
        QVERIFY(std::is_sorted(shares.begin(), shares.end()));
        QCOMPARE(shares.back(), 1.0);
    }

    void theEndIsReportedWithinAStep()
    {
        std::vector<double> shares;
        const Progress progress = [&shares](double share) {
            shares.push_back(share);
            return true;
        };
        SharedProgress shared(progress, 0.01);
        for (const double share : {0.0, 0.005, 0.5, 0.995, 1.0, 1.0, 1.02})
            shared.report(share);
        QCOMPARE(shares, (std::vector{0.0, 0.5, 0.995, 1.0}));
    }

    void raysThatAreNoneHitNothing_data() { eachTree(); }

    void raysThatAreNoneHitNothing()
    {
        QFETCH(Tree, tree);
        const auto caster = built(cubeSphere(4), tree);
        const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
        QVERIFY(!caster->nearestTriangle({ObjectPoint(0.0, 0.0, 3.0), ObjectVector(0.0, 0.0, 0.0)}));
        QVERIFY(!caster->nearestTriangle({ObjectPoint(nan, 0.0, 3.0), ObjectVector(0.0, 0.0, -6.0)}));
        QVERIFY(!caster->nearestTriangle({ObjectPoint(0.0, 0.0, 3.0), ObjectVector(0.0, nan, -6.0)}));
        QVERIFY(!caster->nearestTriangle({ObjectPoint(0.0, 0.0, infinity), ObjectVector(0.0, 0.0, -6.0)}));
        QVERIFY(!built(modelOf(std::vector<glm::vec3>{}), tree)
                     ->nearestTriangle({ObjectPoint(0.0, 0.0, 3.0), ObjectVector(0.0, 0.0, -6.0)}));
    }
};

UNPROJECTOR_TEST(TestRayCaster)
#include "test_ray_caster.moc"
