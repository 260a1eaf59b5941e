#include "tests/support/test.h"

#include "core/examples/examples.h"
#include "core/examples/solids.h"

#include "tests/core/mesh/mesh_measures.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <string>
#include <tuple>

using namespace mesh_measures;
using namespace unprojector::scene;
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::mesh;

namespace {

// A normal is three rounded floats of size up to 1.
constexpr double kUnitTolerance = 1e-6;
// A volume sums thousands of products of rounded positions; relative.
constexpr double kVolumeTolerance = 1e-5;
// The share of the ideal volume that an inscribed tessellation as fine as the scene's may lack.
constexpr double kTessellationLoss = 0.01;

/// Twice the area, along the side from which the corners run counter-clockwise.
glm::dvec3 areaVector(const std::array<glm::dvec3, 3> &t)
{
    return glm::cross(t[1] - t[0], t[2] - t[0]);
}

/// Returns whether the triangle meets the open segment from start to start + way. Möller and
/// Trumbore 1997.
bool meetsSegment(const std::array<glm::dvec3, 3> &t, const glm::dvec3 &start, const glm::dvec3 &way)
{
    const glm::dvec3 ab = t[1] - t[0];
    const glm::dvec3 ac = t[2] - t[0];
    const glm::dvec3 p = glm::cross(way, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0.0)
        return false;
    const glm::dvec3 fromA = start - t[0];
    const double b = glm::dot(fromA, p) / determinant;
    const glm::dvec3 q = glm::cross(fromA, ab);
    const double c = glm::dot(way, q) / determinant;
    const double share = glm::dot(ac, q) / determinant;
    return b >= 0.0 && c >= 0.0 && b + c <= 1.0 && share > 0.0 && share < 1.0 - 1e-9;
}

glm::dvec3 worldPosition(const SceneObject &object, const glm::vec3 &position)
{
    return glm::dvec3(worldFromObject(object.transform) * glm::dvec4(glm::dvec3(position), 1.0));
}

struct Shape {
    std::function<Mesh()> make;
    std::size_t triangles;
    glm::dvec3 lowest;
    glm::dvec3 highest;
    double volume;      // of the ideal solid
    double allowedLoss; // relative
};

/// The cone's base is a regular polygon, so its volume is known without a loss.
double coneVolume(double radius, double height, int n)
{
    return n / 2.0 * std::sin(2.0 * std::numbers::pi / n) * radius * radius * height / 3.0;
}

void addShapes()
{
    constexpr double kPi = std::numbers::pi;
    addColumn<Shape>("shape");
    newRow("cube") << Shape{
        [] { return examples::cubeMesh(1.5); }, 12, glm::dvec3(-0.75), glm::dvec3(0.75), 3.375, 0.0};
    newRow("torus") << Shape{[] { return examples::torusMesh(2.0, 0.5, 96, 48); },
                             9216,
                             {-2.5, -2.5, -0.5},
                             {2.5, 2.5, 0.5},
                             2.0 * kPi * kPi * 2.0 * 0.25,
                             kTessellationLoss};
    newRow("coarsest-torus") << Shape{[] { return examples::torusMesh(2.0, 0.5, 4, 4); },
                                      32,
                                      {-2.5, -2.5, -0.5},
                                      {2.5, 2.5, 0.5},
                                      2.0 * kPi * kPi * 2.0 * 0.25,
                                      0.7};
    newRow("sphere") << Shape{[] { return examples::sphereMesh(1.25, 4); },
                              5120,
                              glm::dvec3(-1.25),
                              glm::dvec3(1.25),
                              4.0 / 3.0 * kPi * 1.25 * 1.25 * 1.25,
                              kTessellationLoss};
    newRow("cone") << Shape{[] { return examples::coneMesh(1.0, 3.0, 96); },
                            192,
                            {-1.0, -1.5, -1.0},
                            {1.0, 1.5, 1.0},
                            coneVolume(1.0, 3.0, 96),
                            0.0};
    newRow("cone-of-four-sides") << Shape{
        [] { return examples::coneMesh(2.0, 3.0, 4); }, 8, {-2.0, -1.5, -2.0}, {2.0, 1.5, 2.0}, 8.0, 0.0};
}

void addMeshes()
{
    addColumn<Mesh>("mesh");
    newRow("cube") << examples::cubeMesh(1.5);
    newRow("torus") << examples::torusMesh(2.0, 0.5, 96, 48);
    newRow("sphere") << examples::sphereMesh(1.25, 4);
    newRow("icosahedron") << examples::sphereMesh(1.0, 0);
    newRow("cone") << examples::coneMesh(1.0, 3.0, 96);
    newRow("teapot") << examples::utahTeapotMesh(kTeapotDivisions);
    newRow("coarse-teapot") << examples::utahTeapotMesh(8);
    newRow("fine-teapot") << examples::utahTeapotMesh(25);
    for (const SceneObject &object : examples::bundledScene())
        addRow("scene: %s", object.name.c_str()) << object.model->meshes.front();
}

} // namespace

Q_DECLARE_METATYPE(Mesh)
Q_DECLARE_METATYPE(Shape)

namespace {

const glm::dvec3 kEye{6.0, 4.5, 9.0};

glm::dmat4 eyeFromWorld()
{
    return glm::lookAt(kEye, glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(0.0, 1.0, 0.0));
}

} // namespace

class TestBundledScene : public QObject {
    Q_OBJECT

private slots:
    // Every mesh
    void arraysFitTogether_data() { addMeshes(); }

    void arraysFitTogether()
    {
        QFETCH(Mesh, mesh);
        QVERIFY(!mesh.indices.empty());
        QCOMPARE(mesh.indices.size() % 3, std::size_t(0));
        QCOMPARE(mesh.normals.size(), mesh.positions.size());
        QVERIFY(mesh.colors.empty() || mesh.colors.size() == mesh.positions.size());
        QVERIFY(*std::max_element(mesh.indices.begin(), mesh.indices.end()) < mesh.positions.size());
    }

    void everyTriangleHasAnArea_data() { addMeshes(); }

    void everyTriangleHasAnArea()
    {
        QFETCH(Mesh, mesh);
        double smallest = 1.0;
        for (std::size_t number = 0; number < mesh.triangleCount(); ++number)
            smallest = std::min(smallest, glm::length(areaVector(triangle(mesh, number))));
        QVERIFY2(smallest > 1e-6, qPrintable(QString::number(smallest)));
    }

    void normalsAreUnitAndOnTheFrontOfTheirTriangles_data() { addMeshes(); }

    void normalsAreUnitAndOnTheFrontOfTheirTriangles()
    {
        QFETCH(Mesh, mesh);
        for (const glm::vec3 &normal : mesh.normals)
            QVERIFY(std::abs(glm::length(glm::dvec3(normal)) - 1.0) < kUnitTolerance);
        for (std::size_t number = 0; number < mesh.triangleCount(); ++number) {
            const glm::dvec3 front = areaVector(triangle(mesh, number));
            for (std::size_t i = 0; i < 3; ++i) {
                const glm::dvec3 normal(mesh.normals[mesh.indices[3 * number + i]]);
                QVERIFY2(glm::dot(front, normal) > 0.0, qPrintable(QString("triangle %1").arg(number)));
            }
        }
    }

    void neighboursAreWoundAlike_data() { addMeshes(); }

    void neighboursAreWoundAlike()
    {
        QFETCH(Mesh, mesh);
        for (const auto &[edge, count] : directedEdges(mesh))
            QCOMPARE(count, 1); // a second triangle may only run along it the other way
    }

    // Solids
    void aSolidIsClosed_data() { addShapes(); }

    void aSolidIsClosed()
    {
        QFETCH(Shape, shape);
        const auto edges = directedEdges(shape.make());
        for (const auto &[edge, count] : edges) {
            QCOMPARE(count, 1);
            QVERIFY(edges.contains({edge.second, edge.first}));
        }
    }

    void aSolidHasItsExtentsAndTriangles_data() { addShapes(); }

    void aSolidHasItsExtentsAndTriangles()
    {
        QFETCH(Shape, shape);
        const Mesh mesh = shape.make();
        const Box box = boundsOf({mesh});
        QCOMPARE(mesh.triangleCount(), shape.triangles);
        QVERIFY(isNear(box.lowest, shape.lowest));
        QVERIFY(isNear(box.highest, shape.highest));
    }

    void aSolidHoldsItsVolume_data() { addShapes(); }

    void aSolidHoldsItsVolume()
    {
        QFETCH(Shape, shape);
        const double share = signedVolume(shape.make()) / shape.volume;
        QVERIFY2(share < 1.0 + kVolumeTolerance, qPrintable(QString::number(share, 'g', 9)));
        QVERIFY2(share > 1.0 - shape.allowedLoss - kVolumeTolerance, qPrintable(QString::number(share, 'g', 9)));
    }

    void torusVerticesLieOnTheTorus()
    {
        const Mesh mesh = examples::torusMesh(2.0, 0.5, 30, 14);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::dvec3 p(mesh.positions[i]);
            const glm::dvec3 middle = 2.0 * glm::normalize(glm::dvec3(p.x, p.y, 0.0));
            QVERIFY(std::abs(glm::distance(p, middle) - 0.5) < kFloatTolerance);
            QVERIFY(isNear(glm::dvec3(mesh.normals[i]), (p - middle) / 0.5, 4.0 * kUnitTolerance));
        }
    }

    void sphereVerticesLieOnTheSphere()
    {
        const Mesh mesh = examples::sphereMesh(1.25, 3);
        QCOMPARE(mesh.positions.size(), std::size_t(642)); // 10 * 4^3 + 2: each vertex is shared
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            QVERIFY(std::abs(glm::length(glm::dvec3(mesh.positions[i])) - 1.25) < kFloatTolerance);
            QVERIFY(isNear(1.25 * glm::dvec3(mesh.normals[i]), glm::dvec3(mesh.positions[i])));
        }
    }

    void cubeFacesComeInOrderAndAreFlat()
    {
        const Mesh mesh = examples::cubeMesh(2.0);
        const std::array<glm::dvec3, 6> outward{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
        QCOMPARE(mesh.positions.size(), 6 * examples::kVerticesPerCubeFace);
        for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
            const glm::dvec3 normal = outward[vertex / examples::kVerticesPerCubeFace];
            QVERIFY(isNear(glm::dvec3(mesh.normals[vertex]), normal));
            QCOMPARE(glm::dot(glm::dvec3(mesh.positions[vertex]), normal), 1.0);
        }
    }

    // Scene

    void objectsAreNamedApart()
    {
        std::set<std::string> names;
        for (const SceneObject &object : examples::bundledScene()) {
            QVERIFY(!object.name.empty());
            QCOMPARE(object.model->name, object.name);
            names.insert(object.name);
        }
        QCOMPARE(names, (std::set<std::string>{"Teapot", "Cube", "Torus", "Ball", "Cone"}));
    }

    void objectsHaveTheirBounds()
    {
        for (const SceneObject &object : examples::bundledScene()) {
            const Box bounds = boundsOf(object.model->meshes);
            QCOMPARE(object.model->bounds.lowest, bounds.lowest);
            QCOMPARE(object.model->bounds.highest, bounds.highest);
            const double size = bounds.transformed(worldFromObject(object.transform)).diagonal();
            QVERIFY2(size > 1.0 && size < 8.0, qPrintable(QString::number(size)));
        }
    }

    void objectsStandOnTheGround()
    {
        for (const SceneObject &object : examples::bundledScene()) {
            double lowest = 1.0;
            for (const glm::vec3 &position : object.model->meshes.front().positions)
                lowest = std::min(lowest, worldPosition(object, position).y);
            QVERIFY2(std::abs(lowest) < kFloatTolerance, object.name.c_str());
        }
    }

    void objectsAreOnlyTurnedScaledAndMoved()
    {
        for (const SceneObject &object : examples::bundledScene()) {
            const glm::dmat3 linear(worldFromObject(object.transform));
            const double scale = std::cbrt(glm::determinant(linear));
            QVERIFY(scale > 0.0);
            const glm::dmat3 squared = glm::transpose(linear) * linear;
            for (int column = 0; column < 3; ++column) {
                for (int row = 0; row < 3; ++row)
                    QVERIFY(std::abs(squared[column][row] - (row == column ? scale * scale : 0.0)) < 1e-12);
            }
        }
    }

    void coloursAreGivenOnce()
    {
        for (const SceneObject &object : examples::bundledScene()) {
            const Mesh &mesh = object.model->meshes.front();
            QCOMPARE(mesh.texture, -1);
            QCOMPARE(mesh.baseColor == glm::vec4(1.0f), !mesh.colors.empty());
            QCOMPARE(mesh.baseColor.a, 1.0f);
            for (const glm::u8vec4 &color : mesh.colors)
                QCOMPARE(int(color.a), 255);
        }
    }

    void cubeFacesHaveSixColours()
    {
        const std::vector<SceneObject> scene = examples::bundledScene();
        const Mesh &mesh = scene.at(1).model->meshes.front();
        std::set<std::tuple<int, int, int>> colors;
        for (std::size_t vertex = 0; vertex < mesh.colors.size(); ++vertex) {
            const glm::u8vec4 &color = mesh.colors[vertex];
            QVERIFY(color == mesh.colors[vertex / examples::kVerticesPerCubeFace * examples::kVerticesPerCubeFace]);
            colors.insert({color.r, color.g, color.b});
        }
        QCOMPARE(colors.size(), std::size_t(6));
    }

    void depthsDiffer()
    {
        std::vector<double> distances;
        for (const SceneObject &object : examples::bundledScene()) {
            const glm::dvec3 center = object.model->bounds.transformed(worldFromObject(object.transform)).center();
            distances.push_back(-(eyeFromWorld() * glm::dvec4(center, 1.0)).z);
        }
        std::sort(distances.begin(), distances.end());
        for (std::size_t i = 1; i < distances.size(); ++i)
            QVERIFY2(distances[i] - distances[i - 1] > 0.5,
                     qPrintable(QString::number(distances[i] - distances[i - 1])));
    }

    void allIsInViewAndNothingHidesAnother()
    {
        const glm::dmat4 clipFromWorld = glm::perspective(std::numbers::pi / 4.0, 1.3, 0.1, 100.0) * eyeFromWorld();
        const std::vector<SceneObject> scene = examples::bundledScene();
        for (const SceneObject &seen : scene) {
            const std::vector<glm::vec3> &positions = seen.model->meshes.front().positions;
            const std::size_t step = std::max<std::size_t>(1, positions.size() / 150);
            int looked = 0;
            int unhidden = 0;
            for (std::size_t vertex = 0; vertex < positions.size(); vertex += step) {
                const glm::dvec3 target = worldPosition(seen, positions[vertex]);
                const glm::dvec4 clip = clipFromWorld * glm::dvec4(target, 1.0);
                QVERIFY2(std::max(std::abs(clip.x), std::abs(clip.y)) < clip.w, seen.name.c_str());
                bool isHidden = false;
                for (const SceneObject &other : scene) {
                    if (other.name == seen.name)
                        continue;
                    const glm::dmat4 objectFromWorld = glm::inverse(worldFromObject(other.transform));
                    const glm::dvec3 start(objectFromWorld * glm::dvec4(kEye, 1.0));
                    const glm::dvec3 way(objectFromWorld * glm::dvec4(target - kEye, 0.0));
                    const Mesh &mesh = other.model->meshes.front();
                    for (std::size_t t = 0; t < mesh.triangleCount() && !isHidden; ++t)
                        isHidden = meetsSegment(triangle(mesh, t), start, way);
                }
                ++looked;
                unhidden += isHidden ? 0 : 1;
            }
            QVERIFY2(unhidden > 0.6 * looked,
                     qPrintable(QString("%1: %2 of %3").arg(seen.name.c_str()).arg(unhidden).arg(looked)));
        }
    }
};

UNPROJECTOR_TEST(TestBundledScene)
#include "test_bundled_scene.moc"
