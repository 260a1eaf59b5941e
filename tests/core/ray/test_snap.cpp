// The snapping of clicks, and points of point clouds.

#include "tests/support/test.h"

#include "core/ray/scene_rays.h"
#include "core/scene/point_size.h"
#include "tests/core/ray/ray_meshes.h"

#include "tests/support/cube_sphere.h"

#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace {

using namespace ray_meshes;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace unprojector::ray;
using namespace unprojector::scene;
using namespace unprojector::unproject;
using unprojector::scene::SceneObject;

/// Looks down -z from z = 5: the plane z = 0 is 10 wide and 7.5 high, 64 pixels a unit.
Setup straightPicture()
{
    const Surface surface{640, 480, 1.0};
    return {surface,
            wholeSurface(surface),
            {},
            Frustum{-1.0, 1.0, -0.75, 0.75, 1.0, 11.0},
            LookAt{WorldPoint(0.0, 0.0, 5.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}}};
}

SceneRays raysOf(const std::vector<std::shared_ptr<Model>> &models, const std::vector<glm::dvec4> &planes = {},
                 const Setup &setup = straightPicture())
{
    std::vector<SceneObject> objects;
    std::vector<std::shared_ptr<const RayCaster>> casters;
    for (const auto &model : models) {
        objects.push_back({"object", {}, model, {}});
        casters.push_back(RayCaster::build(model, {}));
    }
    return SceneRays(*Unprojector::of(setup), objects, casters, planes);
}

/// The device position of a point of the plane z = 0, moved by so many pixels.
DevicePoint seen(double x, double y, double right = 0.0, double down = 0.0)
{
    return DevicePoint(320.0 + 64.0 * x + right, 240.0 - 64.0 * y + down);
}

std::shared_ptr<Model> triangle(float z = 0.0f)
{
    return modelOf({{-1, -1, z}, {1, -1, z}, {-1, 1, z}});
}

std::shared_ptr<Model> pointsAt(const std::vector<glm::vec3> &positions)
{
    Mesh mesh;
    mesh.kind = Mesh::Kind::Points;
    mesh.positions = positions;
    return modelOf(std::move(mesh));
}

using Tree = RayCaster::Tree;

} // namespace

Q_DECLARE_METATYPE(Tree)

class TestSnap : public QObject {
    Q_OBJECT

private slots:
    void verticesSnapWithinEightPixels_data()
    {
        addColumn<DevicePoint>("click");
        addColumn<int>("vertex"); // -1: none
        newRow("on it") << seen(1.0, -1.0) << 1;
        newRow("inside the triangle") << seen(-1.0, -1.0, 3.0, -3.0) << 0;
        newRow("beside the triangle") << seen(-1.0, -1.0, -5.0, 5.0) << 0;
        newRow("7.9 pixels away") << seen(-1.0, -1.0, 0.0, -7.9) << 0;
        newRow("8.1 pixels away, on the triangle") << seen(-1.0, -1.0, 0.1, -8.1) << -1;
        newRow("far away") << seen(3.0, 3.0) << -1;
    }

    void verticesSnapWithinEightPixels()
    {
        QFETCH(DevicePoint, click);
        QFETCH(int, vertex);
        const auto hit = *raysOf({triangle()}).at(click, Snap::Vertex);
        QCOMPARE(hit ? int(hit->vertex.id) : -1, vertex);
        if (!hit)
            return;
        QCOMPARE(hit->vertex.distance, 0.0);
        const std::array<WorldPoint, 3> corners{WorldPoint(-1, -1, 0), WorldPoint(1, -1, 0), WorldPoint(-1, 1, 0)};
        QCOMPARE(hit->world, corners[std::size_t(vertex)]);
        QCOMPARE(hit->objectPoint.coordinates(), corners[std::size_t(vertex)].coordinates());
        QCOMPARE(hit->triangle->barycentric[vertex], 1.0);
    }

    void edgesSnapWithinEightPixels_data()
    {
        addColumn<DevicePoint>("click");
        addColumn<bool>("isTaken");
        addColumn<WorldPoint>("world");
        newRow("below the lower edge") << seen(0.25, -1.0, 0.0, 5.0) << true << WorldPoint(0.25, -1.0, 0.0);
        newRow("above it") << seen(-0.5, -1.0, 0.0, -7.5) << true << WorldPoint(-0.5, -1.0, 0.0);
        newRow("beside the slanted one") << seen(0.25, -0.25, 3.0, -3.0) << true << WorldPoint(0.25, -0.25, 0.0);
        newRow("beyond a corner") << seen(1.0, -1.0, 4.0, 4.0) << true << WorldPoint(1.0, -1.0, 0.0);
        newRow("in the middle") << seen(-0.4, -0.4) << false << WorldPoint();
        newRow("9 pixels beside") << seen(0.0, -1.0, 0.0, 9.0) << false << WorldPoint();
    }

    void edgesSnapWithinEightPixels()
    {
        QFETCH(DevicePoint, click);
        QFETCH(bool, isTaken);
        QFETCH(WorldPoint, world);
        const auto hit = *raysOf({triangle()}).at(click, Snap::Edge);
        QCOMPARE(hit.has_value(), isTaken);
        if (hit) {
            QVERIFY2(distance(hit->world, world) < 1e-12, qPrintable(QString::number(distance(hit->world, world))));
            QVERIFY(hit->triangle->edge.distance < 1e-12);
        }
    }

    /// An edge that runs away from the eye, and behind it.
    void edgesSeenInPerspective()
    {
        const auto model = modelOf({{-1, -1, 9}, {-1, -1, -5}, {-9, -1, -5}});
        const SceneRays rays = raysOf({model});
        // The picture is 8 wide at z = 1, 80 pixels a unit.
        const DevicePoint click(320.0 - 80.0 + 2.0, 240.0 + 80.0 - 2.0);
        const auto hit = *rays.at(click, Snap::Edge);
        QVERIFY(hit.has_value());
        QVERIFY(std::abs(hit->world.x + 1.0) < 1e-12 && std::abs(hit->world.y + 1.0) < 1e-12);
        const DevicePoint at =
            deviceFromWindow(straightPicture().surface, *windowFromWorld(straightPicture(), hit->world));
        // The edge is drawn towards the picture's middle, and the nearest point of that line is the
        // corner of a right angle.
        QVERIFY(std::abs((at.x - click.x) * 1.0 + (at.y - click.y) * -1.0) < 1e-6);
    }

    void facesSnapFromBeside()
    {
        const SceneRays rays = raysOf({triangle()});
        QVERIFY(!*rays.at(seen(0.0, -1.0, 0.0, 5.0), Snap::Surface));
        const auto hit = *rays.at(seen(0.0, -1.0, 0.0, 5.0), Snap::Face);
        QVERIFY(hit.has_value() && hit->world.y >= -1.0 && hit->world.y < -0.9);
        QVERIFY(!*rays.at(seen(0.0, -1.0, 0.0, 9.5), Snap::Face));
        const auto own = *rays.at(seen(-0.3, -0.2), Snap::Face);
        QVERIFY(distance(own->world, WorldPoint(-0.3, -0.2, 0.0)) < 1e-12);
    }

    void hiddenAndClippedCornersAreNotTaken()
    {
        const auto vertexOf = [](const SceneRays &rays, const DevicePoint &click) {
            const auto hit = *rays.at(click, Snap::Vertex);
            return hit ? std::pair(int(hit->object), int(hit->vertex.id)) : std::pair(-1, -1);
        };
        // The wall in front covers the triangle's lower left corner, and ends 4 pixels right of it.
        const float rim = -1.0f * 0.8f + 4.0f / 80.0f;
        const auto wall = modelOf({{-3, -3, 1}, {rim, -3, 1}, {rim, 3, 1}, {-3, 3, 1}}, {0, 1, 2, 0, 2, 3});
        const DevicePoint beside = seen(-1.0, -1.0, 6.0, -2.0);
        QCOMPARE(vertexOf(raysOf({triangle()}), beside), std::pair(0, 0));
        QCOMPARE(vertexOf(raysOf({triangle(), wall}), beside), std::pair(-1, -1));
        QCOMPARE(vertexOf(raysOf({triangle()}, {{1.0, 0.0, 0.0, 0.95}}), beside), std::pair(-1, -1));
        QCOMPARE(vertexOf(raysOf({triangle()}, {{1.0, 0.0, 0.0, 1.05}}), beside), std::pair(0, 0));
    }

    /// Any snap is a vertex, or lies on an edge, and is visible within reach.
    void everySnapIsExactOnAMesh()
    {
        const auto model = cubeSphere(12);
        const Setup setup = straightPicture();
        const SceneRays rays = raysOf({model});
        Aim aim(1);
        int vertices = 0, edges = 0;
        for (int i = 0; i < tests::rounds(60); ++i) {
            const DevicePoint click = seen(2.4 * aim.share() - 1.2, 2.4 * aim.share() - 1.2);
            const auto pixels = [&](const SceneHit &hit) {
                return distance(deviceFromWindow(setup.surface, *windowFromWorld(setup, hit.world)), click);
            };
            const auto vertex = *rays.at(click, Snap::Vertex), edge = *rays.at(click, Snap::Edge);
            if (vertex) {
                ++vertices;
                const glm::dvec3 place(model->meshes[0].positions[vertex->vertex.id]);
                QVERIFY(vertex->world.coordinates() == place && vertex->vertex.distance == 0.0);
                QVERIFY(pixels(*vertex) <= kSnapPixels + 1e-9);
                QVERIFY(edge && pixels(*edge) <= pixels(*vertex) + 1e-6); // a vertex is on edges
            }
            if (edge) {
                ++edges;
                QVERIFY(edge->triangle->edge.distance < 1e-12 && pixels(*edge) <= kSnapPixels + 1e-9);
            }
        }
        QVERIFY2(vertices > tests::rounds(10) && edges > tests::rounds(20),
                 qPrintable(QStringLiteral("%1 %2").arg(vertices).arg(edges)));
    }

    void sliversSnapAsTestingAll_data()
    {
        addColumn<Lens>("lens");
        addColumn<Tree>("tree");
        for (const auto &[name, tree] : {std::pair("fastest", Tree::Fastest), std::pair("plain", Tree::Plain)}) {
            addRow("perspective, %s", name) << Lens(Frustum{-1.0, 1.0, -0.75, 0.75, 1.0, 11.0}) << tree;
            addRow("deep, %s", name) << Lens(Frustum{-0.001, 0.001, -0.00075, 0.00075, 0.001, 1e5}) << tree;
            addRow("ortho, %s", name) << Lens(Ortho{-2.0, 2.0, -1.5, 1.5, 1.0, 11.0}) << tree;
            addRow("oblique, %s", name) << Lens(Oblique{Ortho{-2.0, 2.0, -1.5, 1.5, 1.0, 11.0}, 1.3, 1.8}) << tree;
        }
    }

    /// Triangles a hundredth of a pixel wide, which rays a pixel apart miss, with larger ones that hide
    /// some of them.
    void sliversSnapAsTestingAll()
    {
        QFETCH(Lens, lens);
        QFETCH(Tree, tree);
        Setup setup = straightPicture();
        setup.lens = lens;
        Aim aim(5);
        std::vector<glm::vec3> corners;
        for (int i = 0; i < tests::rounds(1500); ++i) {
            const glm::dvec3 from = 2.0 * aim.share() * aim.direction(), way = 0.4 * aim.share() * aim.direction();
            const double width = i % 20 == 0 ? 0.3 : 0.0002;
            corners.insert(corners.end(), {glm::vec3(from), glm::vec3(from + way),
                                           glm::vec3(from + way * aim.share() + width * aim.direction())});
        }
        const auto model = modelOf(corners);
        const std::vector<SceneObject> objects{
            {"object", {}, model, {Translate{{0.1, -0.2, 0.0}}, Scale{glm::dvec3(1.1)}}}};
        const std::vector<std::shared_ptr<const RayCaster>> casters{RayCaster::build(model, {}, tree)};
        const SceneRays rays(*Unprojector::of(setup), objects, casters, {});
        const glm::dmat4 matrix = worldFromObject(objects[0].transform);
        struct Seen {
            WorldPoint world;
            DevicePoint at;
        };
        std::vector<Seen> all;
        for (const glm::vec3 &corner : corners) {
            const WorldPoint world(glm::dvec3(matrix * glm::dvec4(glm::dvec3(corner), 1.0)));
            all.push_back({world, deviceFromWindow(setup.surface, *windowFromWorld(setup, world))});
        }
        const auto isHidden = [&](const Seen &seen) {
            if (!rays.rays().isInPicture(seen.at))
                return true;
            const auto first = *rays.at(seen.at);
            return first && distance(first->world, seen.world) > 1e-6 && first->world.z > seen.world.z;
        };
        int hits = 0;
        for (int i = 0; i < 300; ++i) {
            const DevicePoint click(640.0 * aim.share(), 480.0 * aim.share());
            std::vector<Seen> candidates;
            std::copy_if(all.begin(), all.end(), std::back_inserter(candidates),
                         [&](const Seen &seen) { return distance(seen.at, click) <= kSnapPixels; });
            std::stable_sort(candidates.begin(), candidates.end(), [&](const Seen &a, const Seen &b) {
                return distance(a.at, click) < distance(b.at, click);
            });
            const auto nearest =
                std::find_if(candidates.begin(), candidates.end(), [&](const Seen &seen) { return !isHidden(seen); });
            const auto hit = *rays.at(click, Snap::Vertex);
            QCOMPARE(hit.has_value(), nearest != candidates.end());
            if (!hit)
                continue;
            ++hits;
            QVERIFY(distance(hit->world, nearest->world) < 1e-9);
            const auto edge = *rays.at(click, Snap::Edge);
            QVERIFY(edge);
            const DevicePoint at = deviceFromWindow(setup.surface, *windowFromWorld(setup, edge->world));
            QVERIFY(distance(at, click) <= distance(nearest->at, click) + 1e-6);
        }
        QVERIFY2(hits > tests::rounds(60), qPrintable(QString::number(hits)));
    }

    /// Seen straight, the corners behind are at the same position, but for a rounding.
    void aCornerBehindAnotherIsNotTaken()
    {
        Aim aim(9);
        for (int i = 0; i < tests::rounds(300); ++i) {
            const glm::dvec3 z = aim.direction(), x = glm::normalize(glm::cross(z, aim.direction())),
                             y = glm::cross(z, x);
            std::array<glm::dvec3, 8> places;
            for (std::size_t corner = 0; corner < places.size(); ++corner)
                places[corner] =
                    ((corner & 1) != 0 ? x : -x) + ((corner & 2) != 0 ? y : -y) + ((corner & 4) != 0 ? z : -z);
            Mesh mesh;
            setPositions(mesh, glm::dvec3(0.0), places);
            mesh.indices = {4, 5, 7, 4, 7, 6, 0, 3, 1, 0, 2, 3, 0, 1, 5, 0, 5, 4,
                            2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
            Setup setup = straightPicture();
            setup.lens = Ortho{-2.0, 2.0, -1.5, 1.5, 1.0, 11.0};
            setup.camera() = LookAt{WorldPoint(5.0 * z), WorldPoint(0.0, 0.0, 0.0), WorldVector(y)};
            const SceneRays rays = raysOf({modelOf(std::move(mesh))}, {}, setup);
            const DevicePoint corner = deviceFromWindow(setup.surface, *windowFromWorld(setup, WorldPoint(places[7])));
            for (const glm::dvec2 &off : {glm::dvec2(3.0, -2.0), glm::dvec2(-3.0, 2.0), glm::dvec2(0.0)}) {
                const DevicePoint click(corner.x + off.x, corner.y + off.y);
                const auto vertex = *rays.at(click, Snap::Vertex), edge = *rays.at(click, Snap::Edge);
                QVERIFY(vertex && edge);
                QVERIFY2(vertex->world.coordinates() == places[7], qPrintable(QString::number(vertex->vertex.id)));
                QVERIFY(glm::dot(edge->world.coordinates(), z) > 0.9);
            }
        }
    }

    void whatIsTakenIsAsSureAsItsVertices()
    {
        Aim aim(3);
        int vertices = 0, edges = 0;
        for (int i = 0; i < tests::rounds(300); ++i) {
            std::array<glm::dvec3, 3> file;
            for (glm::dvec3 &corner : file)
                corner = aim.direction();
            Mesh mesh;
            setPositions(mesh, glm::dvec3(0.0), file);
            const Setup setup = straightPicture();
            const SceneRays rays = raysOf({modelOf(std::move(mesh))}, {}, setup);
            const DevicePoint corner = deviceFromWindow(setup.surface, *windowFromWorld(setup, WorldPoint(file[0])));
            if (const auto hit = *rays.at(corner, Snap::Vertex)) {
                ++vertices;
                const glm::dvec3 stated = hit->uncertainty.coordinates();
                QVERIFY(hit->world.coordinates() == file[hit->vertex.id]);
                QVERIFY(glm::all(glm::lessThan(stated, glm::dvec3(1e-15)))); // rounding in double
            }
            const WorldPoint middle(0.5 * (file[0] + file[1]));
            const DevicePoint between = deviceFromWindow(setup.surface, *windowFromWorld(setup, middle));
            if (const auto hit = *rays.at(between, Snap::Edge)) {
                ++edges;
                const auto &[from, to] = hit->triangle->edge.ids;
                const glm::dvec3 w = hit->triangle->barycentric;
                const glm::dvec3 place = w.x * file[0] + w.y * file[1] + w.z * file[2];
                QVERIFY(w[static_cast<int>(3 - from - to)] == 0.0);
                QVERIFY(glm::all(
                    glm::lessThanEqual(glm::abs(place - hit->world.coordinates()), hit->uncertainty.coordinates())));
            }
        }
        QVERIFY(vertices > tests::rounds(100) && edges > tests::rounds(100));
    }

    void theFrontPointNearestToTheClickIsTaken_data()
    {
        addColumn<std::vector<glm::vec3>>("points");
        addColumn<int>("taken"); // -1: none
        const auto row = [](const char *name, const std::vector<glm::vec3> &points, int taken) {
            newRow(name) << points << taken;
        };
        // The click is at the middle of the picture, 64 pixels a unit at z = 0.
        row("nothing", {}, -1);
        row("one within reach", {{0.1f, 0, 0}}, 0);
        row("one 9.6 pixels away", {{0.15f, 0, 0}}, -1);
        row("the nearer to the click of two", {{0.1f, 0, 0.1f}, {0.01f, 0, 0}}, 1);
        row("beside dots the front one, not one seen through the gap", {{0.05f, 0, 2}, {0.06f, 0, -2}}, 0);
        row("on a dot its own point, though another is before it", {{0.05f, 0, 2}, {0, 0, -2}}, 1);
        row("of two dots the front one", {{0.01f, 0, -2}, {0.01f, 0, 2}, {0, 0, 0}}, 1);
        row("none behind the far plane", {{0, 0, -6.5f}}, -1);
        row("none before the near plane", {{0, 0, 4.5f}, {0.05f, 0, 0}}, 1);
    }

    void theFrontPointNearestToTheClickIsTaken()
    {
        QFETCH(std::vector<glm::vec3>, points);
        QFETCH(int, taken);
        for (const Snap snap : {Snap::Surface, Snap::Vertex}) {
            const auto hit = *raysOf({pointsAt(points)}).at(seen(0.0, 0.0), snap);
            QCOMPARE(hit ? int(hit->vertex.id) : -1, taken);
            if (!hit)
                continue;
            QVERIFY(!hit->triangle);
            QCOMPARE(hit->world.coordinates(), glm::dvec3(points[std::size_t(taken)]));
        }
    }

    void pointsBehindASurfaceAreHidden()
    {
        const auto cloud = pointsAt({{-0.3f, -0.3f, 0}});
        const DevicePoint click = seen(-0.3, -0.3, 1.0);
        const auto objectOf = [&](float z) { return (*raysOf({cloud, triangle(z)}).at(click))->object; };
        QCOMPARE(objectOf(-0.5f), std::size_t(0));
        QCOMPARE(objectOf(0.5f), std::size_t(1));
        // A clipping plane that removes the surface shows the point again; one that removes the point
        // shows the surface behind it.
        QCOMPARE((*raysOf({cloud, triangle(0.5f)}, {{0.0, 0.0, -1.0, 0.25}}).at(click))->object, std::size_t(0));
        QCOMPARE((*raysOf({cloud, triangle(-0.5f)}, {{0.0, 0.0, -1.0, -0.25}}).at(click))->object, std::size_t(1));
    }

    void besideADotTheSurfaceIsMet()
    {
        const auto wall = triangle(-0.5f);
        for (const double pixels : {0.0, 1.4, 1.6, 7.0}) {
            const auto hit = *raysOf({wall, pointsAt({{-0.5f, -0.5f, 0}})}).at(seen(-0.5, -0.5, pixels));
            QCOMPARE(hit->object, std::size_t(pixels < 1.5 ? 1 : 0));
        }
    }

    /// A matrix times -1 is the same projection, with w < 0 in front of the eye.
    void turnedSignsSnapToTheSame()
    {
        Setup turned = straightPicture();
        turned.lens = MatrixProjection{-clipFromEye(turned.projection()).value(), std::nullopt};
        for (const bool isKnown : {true, false}) {
            if (!isKnown) { // rolled a little
                auto &matrix = std::get<MatrixProjection>(turned.lens).clipFromEye;
                matrix[1][0] = 1e-13;
                matrix[0][1] = 1e-13;
            }
            const SceneRays plain = raysOf({triangle()}), other = raysOf({triangle()}, {}, turned);
            for (const Snap snap : {Snap::Vertex, Snap::Edge, Snap::Face}) {
                const DevicePoint at = seen(-1.0, -1.0, 3.0, -2.0);
                const auto hit = *plain.at(at, snap), same = *other.at(at, snap);
                QVERIFY(hit && same);
                QVERIFY(distance(hit->world, same->world) < 1e-11);
            }
            const auto dot = *raysOf({pointsAt({{0.5f, 0.25f, 0}})}, {}, turned).at(seen(0.5, 0.25, 2.0));
            QVERIFY(dot && dot->world == WorldPoint(0.5, 0.25, 0.0));
        }
    }

    void pointsAnswerAsTestingAll_data()
    {
        addColumn<Lens>("lens");
        newRow("perspective") << Lens(Frustum{-1.0, 1.0, -0.75, 0.75, 1.0, 11.0});
        newRow("ortho") << Lens(Ortho{-2.0, 2.0, -1.5, 1.5, 1.0, 11.0});
        newRow("oblique") << Lens(Oblique{Ortho{-2.0, 2.0, -1.5, 1.5, 1.0, 11.0}, 1.3, 1.8});
    }

    void pointsAnswerAsTestingAll()
    {
        QFETCH(Lens, lens);
        Setup setup = straightPicture();
        setup.lens = lens;
        Aim aim(2);
        std::vector<glm::vec3> points(3000);
        for (glm::vec3 &point : points)
            point = glm::vec3(2.0 * aim.share() * aim.direction());
        const SceneRays rays = raysOf({pointsAt(points)}, {}, setup);
        const auto placeOf = [&setup](const WorldPoint &point) {
            return deviceFromWindow(setup.surface, *windowFromWorld(setup, point));
        };
        std::vector<DevicePoint> places;
        places.reserve(points.size());
        for (const glm::vec3 &point : points)
            places.push_back(placeOf(WorldPoint(glm::dvec3(point))));
        int hits = 0, dots = 0;
        for (int i = 0; i < tests::rounds(2000); ++i) {
            const DevicePoint click(640.0 * aim.share(), 480.0 * aim.share());
            // The points within reach, by projection; the front ones are those up to a depth that is
            // judged from outside.
            std::optional<std::size_t> front, drawn;
            for (std::size_t k = 0; k < points.size(); ++k) {
                if (distance(places[k], click) > kSnapPixels)
                    continue;
                if (!front || points[k].z > points[*front].z)
                    front = k;
                const double off = std::max(std::abs(places[k].x - click.x), std::abs(places[k].y - click.y));
                if (off <= pointPixels(setup.surface) / 2.0 && (!drawn || points[k].z > points[*drawn].z))
                    drawn = k;
            }
            const auto hit = *rays.at(click);
            QCOMPARE(hit.has_value(), front.has_value());
            if (!hit)
                continue;
            ++hits;
            if (drawn) {
                ++dots;
                QCOMPARE(std::size_t(hit->vertex.id), *drawn);
                continue;
            }
            const glm::dvec3 &world = hit->world.coordinates();
            const double pixel =
                lens.index() == 0 && isPerspective(setup.projection()) ? (5.0 - points[*front].z) / 320.0 : 4.0 / 640.0;
            QVERIFY(points[*front].z - world.z <= 1.001 * 4.0 * 2.0 * kSnapPixels * pixel);
            const double own = distance(placeOf(hit->world), click);
            for (std::size_t k = 0; k < points.size(); ++k) // no other front one is nearer to the click
                QVERIFY(points[k].z < world.z || distance(places[k], click) >= own - 1e-9);
        }
        QVERIFY2(dots > tests::rounds(20) && hits > 2 * dots,
                 qPrintable(QStringLiteral("%1 hits, %2 on dots").arg(hits).arg(dots)));
    }
};

UNPROJECTOR_TEST(TestSnap)
#include "test_snap.moc"
