// The mean curvature that shades a surface, on surfaces whose curvature is known.

#include "tests/support/test.h"

#include "core/examples/solids.h"
#include "core/mesh/curvature.h"
#include "tests/support/mesh_model.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

using namespace unprojector;
using namespace unprojector::mesh;

Q_DECLARE_METATYPE(std::shared_ptr<unprojector::mesh::Model>)

namespace {

/// A surface over a square of n × n steps, u and v in [-1, 1].
Mesh sheet(std::uint32_t n, const std::function<glm::dvec3(double, double)> &at)
{
    Mesh mesh;
    for (std::uint32_t j = 0; j <= n; ++j) {
        for (std::uint32_t i = 0; i <= n; ++i)
            mesh.positions.emplace_back(at(2.0 * i / n - 1.0, 2.0 * j / n - 1.0));
    }
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
            mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
        }
    }
    return mesh;
}

constexpr double kTurn = 6.283185307179586;

/// Half a tube about the z axis; its rim is open.
Mesh tube(double radius)
{
    return sheet(200, [radius](double u, double v) {
        return glm::dvec3(radius * std::cos(kTurn / 4.0 * u), radius * std::sin(kTurn / 4.0 * u), radius * v);
    });
}

Mesh saddle()
{
    return sheet(200, [](double u, double v) { return glm::dvec3(u, v, 0.5 * (u * u - v * v)); });
}

Mesh turnedOver(Mesh mesh)
{
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        std::swap(mesh.indices[i], mesh.indices[i + 1]);
    return mesh;
}

/// Each vertex moved by noise in all directions.
Mesh noisy(Mesh mesh, double deviation)
{
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, deviation);
    for (glm::vec3 &position : mesh.positions)
        position += glm::vec3(noise(random), noise(random), noise(random));
    return mesh;
}

/// The root of the mean squared difference from a value, of the vertices with |x|, |y|, |z| within
/// a limit.
double errorOf(const Model &model, const Curvature &curvature, double expected, double limit)
{
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < curvature.meshes.size(); ++i) {
        for (std::size_t vertex = 0; vertex < curvature.meshes[i].size(); ++vertex) {
            const glm::dvec3 at = model.meshes[i].position(vertex);
            if (std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}) > limit)
                continue;
            const double difference = static_cast<double>(curvature.meshes[i][vertex]) - expected;
            sum += difference * difference;
            ++count;
        }
    }
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : std::numeric_limits<double>::infinity();
}

} // namespace

class TestCurvature : public QObject {
    Q_OBJECT

private slots:
    void knownSurfacesHaveTheirCurvature_data()
    {
        addColumn<std::shared_ptr<Model>>("model");
        addColumn<double>("expected");
        addColumn<double>("limit"); // of the coordinates: beyond it is a rim
        addColumn<double>("error"); // most root mean square of the difference
        constexpr double kEverywhere = 1e9;
        const auto row = [](const char *name, Mesh mesh, double expected, double limit, double error) {
            newRow(name) << modelOf(std::move(mesh)) << expected << limit << error;
        };
        row("sphere", examples::sphereMesh(2.0, 6), 0.5, kEverywhere, 0.005);
        row("small sphere", examples::sphereMesh(0.1, 6), 10.0, kEverywhere, 0.1);
        row("coarse sphere", examples::sphereMesh(1.0, 3), 1.0, kEverywhere, 0.05);
        row("sphere from within", turnedOver(examples::sphereMesh(2.0, 6)), -0.5, kEverywhere, 0.005);
        row("tube", tube(2.0), 0.25, kEverywhere, 0.02);
        row("saddle", saddle(), 0.0, 0.3, 0.03); // by its formula at most 0.014 there
        row("plane", sheet(50, [](double u, double v) { return glm::dvec3(u, v, 0.3 * u); }), 0.0, kEverywhere, 1e-4);
        // Without smoothing, the error would be about four times the noise by the squared distance of
        // vertices: 13, 20 and 8.
        row("noisy sphere", noisy(examples::sphereMesh(1.0, 6), 0.001), 1.0, kEverywhere, 0.25);
        row("noisy tube", noisy(tube(2.0), 0.002), 0.25, kEverywhere, 0.25);
        row("noisy saddle", noisy(saddle(), 0.0002), 0.0, 0.3, 0.25);
    }

    void knownSurfacesHaveTheirCurvature()
    {
        QFETCH(std::shared_ptr<Model>, model);
        QFETCH(double, expected);
        QFETCH(double, limit);
        QFETCH(double, error);
        const Curvature curvature = curvatureOf(*model);
        QCOMPARE(curvature.meshes.size(), model->meshes.size());
        QCOMPARE(curvature.meshes[0].size(), model->meshes[0].positions.size());
        const double is = errorOf(*model, curvature, expected, limit);
        QVERIFY2(is < error, qPrintable(QString::number(is)));
    }

    void ridgesArePositiveAndValleysNegative()
    {
        // A wave along x, seen from above: its crests are at x = ±0.5.
        const auto wave =
            modelOf(sheet(200, [](double u, double v) { return glm::dvec3(u, v, -0.05 * std::cos(kTurn * u)); }));
        const Curvature curvature = curvatureOf(*wave);
        for (std::size_t vertex = 0; vertex < wave->meshes[0].positions.size(); ++vertex) {
            const glm::vec3 at = wave->meshes[0].positions[vertex];
            const double value = static_cast<double>(curvature.meshes[0][vertex]);
            const double top = 0.5 * 0.05 * kTurn * kTurn; // half of the second derivative
            if (std::abs(at.y) < 0.9f && std::abs(std::abs(at.x) - 0.5f) < 1e-3f)
                QVERIFY2(std::abs(value - top) < 0.1 * top, qPrintable(QString::number(value)));
            if (std::abs(at.y) < 0.9f && std::abs(at.x) < 1e-3f)
                QVERIFY2(std::abs(value + top) < 0.1 * top, qPrintable(QString::number(value)));
        }
    }

    void splitVerticesChangeNothing()
    {
        const Mesh shared = examples::torusMesh(1.0, 0.3, 80, 40);
        const Curvature whole = curvatureOf(*modelOf(shared)), split = curvatureOf(*modelOf(soupOf(shared)));
        QCOMPARE(split.meshes[0].size(), shared.indices.size());
        for (std::size_t corner = 0; corner < shared.indices.size(); ++corner) {
            const float a = whole.meshes[0][shared.indices[corner]], b = split.meshes[0][corner];
            QVERIFY2(std::abs(a - b) < 1e-3f, qPrintable(QStringLiteral("%1 for %2").arg(b).arg(a)));
        }
    }

    void meshesOfOneSurfaceBelongTogether()
    {
        // The triangles of a sphere go to two meshes of different materials by turns.
        const Mesh sphere = examples::sphereMesh(1.0, 5);
        auto model = modelOf(sphere);
        model->meshes.push_back(sphere);
        std::array<std::vector<std::uint32_t>, 2> parts;
        for (std::size_t i = 0; i < sphere.indices.size(); i += 3)
            parts[i / 3 % 2].insert(parts[i / 3 % 2].end(), sphere.indices.begin() + static_cast<std::ptrdiff_t>(i),
                                    sphere.indices.begin() + static_cast<std::ptrdiff_t>(i + 3));
        model->meshes[0].indices = parts[0];
        model->meshes[1].indices = parts[1];
        Mesh points = sphere;
        points.kind = Mesh::Kind::Points;
        points.indices.clear();
        model->meshes.insert(model->meshes.begin() + 1, points);
        const Curvature curvature = curvatureOf(*model);
        QCOMPARE(curvature.meshes.size(), std::size_t{3});
        QVERIFY(curvature.meshes[1].empty());
        const double error = errorOf(*model, curvature, 1.0, 2.0);
        QVERIFY2(error < 0.02, qPrintable(QString::number(error)));
    }

    void theOtherSideOfAThinWallCountsForItself()
    {
        // Two spheres, one in the other and turned over, nearer to each other than the smoothing
        // reaches.
        Mesh wall = examples::sphereMesh(1.0, 5);
        const Mesh inside = turnedOver(examples::sphereMesh(0.995, 5));
        const auto first = static_cast<std::uint32_t>(wall.positions.size());
        wall.positions.insert(wall.positions.end(), inside.positions.begin(), inside.positions.end());
        for (const std::uint32_t index : inside.indices)
            wall.indices.push_back(first + index);
        wall.normals.clear();
        const auto model = modelOf(wall);
        const Curvature curvature = curvatureOf(*model);
        QVERIFY(curvature.smoothingDistance > 0.01);
        for (std::size_t vertex = 0; vertex < wall.positions.size(); ++vertex)
            QVERIFY((curvature.meshes[0][vertex] > 0.9f) == (vertex < first));
    }

    void sizeAndPlaceDoNotMatter_data()
    {
        addColumn<double>("size");
        addColumn<double>("place");
        newRow("tiny") << 1e-12 << 0.0;
        newRow("huge") << 1e12 << 0.0;
        newRow("far from the origin") << 1.0 << 4e6;
    }

    void sizeAndPlaceDoNotMatter()
    {
        QFETCH(double, size);
        QFETCH(double, place);
        Mesh mesh = examples::sphereMesh(1.0, 5);
        std::vector<glm::dvec3> positions;
        for (const glm::vec3 &position : mesh.positions)
            positions.push_back(glm::dvec3(place) + size * glm::dvec3(position));
        const auto model = modelOf([&] {
            Mesh moved = mesh;
            setPositions(moved, glm::dvec3(place), positions);
            return moved;
        }());
        const Curvature curvature = curvatureOf(*model);
        const double error = errorOf(*model, curvature, 1.0 / size, 1e300) * size;
        QVERIFY2(error < 0.02, qPrintable(QString::number(error)));
        QVERIFY(std::abs(curvature.usual * size - 1.0) < 0.05);
    }

    void badTrianglesDoNotCount()
    {
        Mesh mesh = examples::sphereMesh(1.0, 5);
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
        mesh.positions.insert(mesh.positions.end(), {{kNan, 0.0f, 0.0f}, {5.0f, 5.0f, 5.0f}});
        mesh.normals.clear();
        mesh.indices.insert(mesh.indices.end(), {0, 1, first, 0, 0, 1, 2, 2, 2});
        const auto model = modelOf(mesh);
        const Curvature curvature = curvatureOf(*model);
        for (std::size_t vertex = 0; vertex < first; ++vertex)
            QVERIFY(std::abs(curvature.meshes[0][vertex] - 1.0f) < 0.1f);
        QVERIFY(std::isfinite(curvature.meshes[0][first]) && std::isfinite(curvature.meshes[0][first + 1]));
    }

    void theUsualValueIgnoresExtremes()
    {
        // A large ball and a small one: a hundredth of the surface is ten times as curved.
        Mesh mesh = examples::sphereMesh(1.0, 5);
        Mesh small = examples::sphereMesh(0.1, 4);
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::vec3 &position : small.positions)
            mesh.positions.push_back(position + glm::vec3(1.5f, 0.0f, 0.0f));
        for (const std::uint32_t index : small.indices)
            mesh.indices.push_back(first + index);
        mesh.normals.clear();
        const Curvature curvature = curvatureOf(*modelOf(mesh));
        QVERIFY(*std::max_element(curvature.meshes[0].begin(), curvature.meshes[0].end()) > 5.0f);
        QVERIFY2(std::abs(curvature.usual - 1.0) < 0.1, qPrintable(QString::number(curvature.usual)));
    }

    void itCanBeCancelled()
    {
        const auto model = modelOf(examples::sphereMesh(1.0, 6));
        std::vector<double> shares;
        const Curvature whole = curvatureOf(*model, [&](double share) {
            shares.push_back(share);
            return true;
        });
        QVERIFY(!whole.meshes.empty());
        QVERIFY(shares.size() > 4 && std::is_sorted(shares.begin(), shares.end()) && shares.back() == 1.0);
        for (const double end : {0.0, 0.3, 0.8})
            QVERIFY(curvatureOf(*model, [end](double share) { return share < end; }).meshes.empty());
    }

    void nothingComesOfNothing()
    {
        QVERIFY(curvatureOf({}).meshes.empty());
        const Curvature empty = curvatureOf(*modelOf(Mesh()));
        QCOMPARE(empty.meshes.size(), std::size_t{1});
        QVERIFY(empty.meshes[0].empty());
        QCOMPARE(empty.usual, 0.0);
        Mesh flat;
        flat.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}; // without an area
        QCOMPARE(curvatureOf(*modelOf(flat)).meshes[0], std::vector<float>(3, 0.0f));
    }
};

UNPROJECTOR_TEST(TestCurvature, threads)
#include "test_curvature.moc"
