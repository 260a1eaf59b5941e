// The place of a model closest to a point: it equals the result of testing all triangles, and no
// other place of the surface is closer.

#include "tests/support/test.h"

#include "core/ray/closest_place.h"
#include "tests/core/ray/ray_meshes.h"

#include <cmath>
#include <limits>

namespace {

using namespace ray_meshes;
using namespace unprojector::landmarks;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace unprojector::ray;

/// The least distance to all triangles and points, each tested. It is computed in long double and
/// differently: the foot on the plane by Gram's equations, else the edges.
double leastDistance(const Model &model, const glm::dvec3 &p)
{
    using Real = long double;
    using Vec = glm::vec<3, Real>;
    Real least = std::numeric_limits<Real>::infinity();
    const auto onSegment = [](const Vec &a, const Vec &b) {
        const Vec d = b - a;
        const Real dd = glm::dot(d, d), t = dd > 0 ? std::min<Real>(1, std::max<Real>(0, -glm::dot(a, d) / dd)) : 0;
        return glm::length(a + t * d);
    };
    for (const Mesh &mesh : model.meshes) {
        for (std::size_t i = 0; i < mesh.pointCount(); ++i)
            least = std::min(least, glm::length(Vec(mesh.position(mesh.vertexAt(i))) - Vec(p)));
        for (std::size_t i = 0; i < mesh.triangleCount(); ++i) {
            Vec c[3];
            for (std::size_t k = 0; k < 3; ++k)
                c[k] = Vec(mesh.origin) + Vec(mesh.fromOrigin(mesh.vertexAt(3 * i + k))) - Vec(p);
            for (int k = 0; k < 3; ++k)
                least = std::min(least, onSegment(c[k], c[(k + 1) % 3]));
            const Vec u = c[1] - c[0], v = c[2] - c[0];
            const Real uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), det = uu * vv - uv * uv;
            if (!(det > 0))
                continue;
            const Real s = (-glm::dot(c[0], u) * vv + glm::dot(c[0], v) * uv) / det;
            const Real t = (-glm::dot(c[0], v) * uu + glm::dot(c[0], u) * uv) / det;
            if (s >= 0 && t >= 0 && s + t <= 1)
                least = std::min(least, glm::length(c[0] + s * u + t * v));
        }
    }
    return double(least);
}

} // namespace

class TestClosestPlace : public QObject {
    Q_OBJECT

private slots:
    void asCloseAsTestingAll_data()
    {
        addColumn<std::shared_ptr<const Model>>("model");
        addColumn<double>("size");
        addColumn<double>("distance");
        const auto scaled = [](const std::shared_ptr<Model> &model, float factor, const glm::dvec3 &origin) {
            for (Mesh &mesh : model->meshes) {
                mesh.origin = origin;
                for (glm::vec3 &position : mesh.positions)
                    position *= factor;
            }
            model->bounds = boundsOf(model->meshes);
            return std::shared_ptr<const Model>(model);
        };
        const std::shared_ptr<const Model> ring = torus(24), any = soup(3000, 5);
        newRow("torus, about it") << ring << 1.0 << 1.5;
        newRow("torus, far away") << ring << 1.0 << 1e6;
        newRow("torus, very far away") << ring << 1.0 << 1e12;
        newRow("torus, farther than doubles tell") << ring << 1.0 << 1e18;
        newRow("any triangles, some without an area") << any << 1.0 << 1.0;
        newRow("tiny") << scaled(torus(24), 1e-12f, glm::dvec3(0.0)) << 1e-12 << 1e-12;
        newRow("huge") << scaled(torus(24), 1e12f, glm::dvec3(0.0)) << 1e12 << 1e12;
        newRow("a map's coordinates") << scaled(torus(24), 1.0f, {4.5e6, -5.5e6, 300}) << 1.0 << 1.5;
        newRow("no size") << std::shared_ptr<const Model>(modelOf({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}})) << 1.0 << 5.0;
    }

    void asCloseAsTestingAll()
    {
        QFETCH(std::shared_ptr<const Model>, model);
        QFETCH(double, size);
        QFETCH(double, distance);
        const auto places = ClosestPlaces::build(model, {});
        QVERIFY(places);
        Aim aim(7);
        const glm::dvec3 center = model->bounds.center();
        for (int i = 0; i < 300; ++i) {
            const glm::dvec3 point = center + distance * aim.share() * aim.direction();
            const auto place = places->to(ObjectPoint(point));
            QVERIFY(place);
            const double least = leastDistance(*model, point);
            // The rounding of double for coordinates of this size.
            const double rounding = 8e-16 * (size + distance + glm::length(center));
            QVERIFY2(std::abs(place->distance - least) <= rounding,
                     qPrintable(QString::number(place->distance - least)));
            QVERIFY(std::abs(glm::length(place->point.coordinates() - point) - least) <= 4.0 * rounding);
            const auto &hold = std::get<OnTriangle>(place->anchor);
            QVERIFY(hold.barycentric.x >= 0.0 && hold.barycentric.y >= 0.0 && hold.barycentric.z >= 0.0);
            QVERIFY(std::abs(hold.barycentric.x + hold.barycentric.y + hold.barycentric.z - 1.0) <= 4e-16);
            QVERIFY(*placeOf(place->anchor, *model) == place->point);
        }
    }

    void aPointOfTheSurfaceIsItsOwn()
    {
        const std::shared_ptr<const Model> model = torus(50);
        const auto places = ClosestPlaces::build(model, {});
        Aim aim(8);
        for (int i = 0; i < 2000; ++i) {
            glm::dvec3 b(aim.share(), aim.share(), aim.share());
            b /= b.x + b.y + b.z;
            const auto triangle = static_cast<std::uint32_t>(aim.below(model->triangleCount()));
            const ObjectPoint point = *placeOf(OnTriangle{triangle, b}, *model);
            const auto place = places->to(point);
            QVERIFY(place && place->distance <= 1e-15);
            QVERIFY(glm::length((place->point - point).coordinates()) <= 1e-15);
        }
    }

    void cornersAreExact()
    {
        const auto model = modelOf({{0.1f, 0.2f, 0.3f}, {1.1f, 0.25f, 0.3f}, {0.3f, 1.7f, 0.9f}});
        const auto places = ClosestPlaces::build(model, {});
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 corner(model->meshes[0].positions[i]);
            const glm::dvec3 away = corner
                                    - (glm::dvec3(model->meshes[0].positions[(i + 1) % 3])
                                       + glm::dvec3(model->meshes[0].positions[(i + 2) % 3]))
                                          / 2.0;
            for (const double step : {0.0, 1e-9, 3.0}) {
                const auto place = places->to(ObjectPoint(corner + step * away));
                QVERIFY(place && place->point == ObjectPoint(corner));
                QVERIFY(std::get<OnTriangle>(place->anchor).barycentric[int(i)] == 1.0);
            }
        }
    }

    void ofTwoAtOnePlaceTheFirst()
    {
        std::vector<glm::vec3> positions;
        for (int i = 0; i < 100; ++i)
            positions.insert(positions.end(), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
        const auto places = ClosestPlaces::build(modelOf(positions), {});
        const auto place = places->to(ObjectPoint(0.25, 0.25, 4.0));
        QVERIFY(place);
        QCOMPARE(std::get<OnTriangle>(place->anchor).triangle, 0u);
        QCOMPARE(place->distance, 4.0);
        QVERIFY(place->point == ObjectPoint(0.25, 0.25, 0.0));
    }

    void pointsOfACloud()
    {
        Mesh cloud;
        cloud.kind = Mesh::Kind::Points;
        cloud.origin = {100, 0, 0};
        for (int i = 0; i < 1000; ++i)
            cloud.positions.emplace_back(float(i % 10), float(i / 10 % 10), float(i / 100));
        const auto model = modelOf(cloud);
        const auto places = ClosestPlaces::build(model, {});
        const auto place = places->to(ObjectPoint(104.25, 7.5 + 1e-9, 2.0));
        QVERIFY(place);
        QCOMPARE(std::get<AtVertex>(place->anchor).vertex, 284u);
        QVERIFY(place->point == ObjectPoint(104, 8, 2));
    }

    void severalMeshesAreCountedThrough()
    {
        auto model = std::make_shared<Model>();
        for (int i = 0; i < 5; ++i) {
            Mesh mesh;
            mesh.kind = i == 2 ? Mesh::Kind::Points : Mesh::Kind::Triangles;
            mesh.origin = {10.0 * i, 0, 0};
            mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
            model->meshes.push_back(mesh);
        }
        model->bounds = boundsOf(model->meshes);
        const auto places = ClosestPlaces::build(model, {});
        QCOMPARE(std::get<OnTriangle>(places->to(ObjectPoint(30.9, 0.9, 1))->anchor).triangle, 5u);
        QCOMPARE(std::get<AtVertex>(places->to(ObjectPoint(21, 1.5, 0))->anchor).vertex, 16u);
    }

    void holdsSayWhereTheyAre()
    {
        const auto model = modelOf({{0, 0, 0}, {4, 0, 0}, {0, 8, 0}});
        QVERIFY(!placeOf(Free{}, *model));
        QVERIFY(*placeOf(AtVertex{2}, *model) == ObjectPoint(0, 8, 0));
        QVERIFY(*placeOf(OnEdge{{1, 0}, 0.25}, *model) == ObjectPoint(3, 0, 0));
        QVERIFY(*placeOf(OnTriangle{0, {0.5, 0.25, 0.25}}, *model) == ObjectPoint(1, 2, 0));
        QVERIFY(!placeOf(AtVertex{3}, *model) && !placeOf(OnEdge{{0, 3}, 0.5}, *model)
                && !placeOf(OnTriangle{1, {}}, *model));
    }

    void nothingToBeCloseTo()
    {
        const auto places = ClosestPlaces::build(torus(8), {});
        QVERIFY(!places->to(ObjectPoint(std::nan(""), 0, 0)));
        QVERIFY(!places->to(ObjectPoint(std::numeric_limits<double>::infinity(), 0, 0)));
        QVERIFY(!ClosestPlaces::build(std::make_shared<Model>(), {})->to(ObjectPoint(0, 0, 0)));
        QVERIFY(!ClosestPlaces::build(soup(100000, 3), [](double) { return false; }));
    }
};

UNPROJECTOR_TEST(TestClosestPlace)
#include "test_closest_place.moc"
