// Paths on surfaces with known shortest ones: surfaces that unroll flat, a sphere, and surfaces
// with a rim.

#include "tests/support/test.h"

#include "core/curves/curve_line.h"
#include "core/examples/examples.h"
#include "core/ray/closest_place.h"
#include "tests/core/ray/ray_meshes.h"
#include "tests/support/cube_sphere.h"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace unprojector;
using namespace unprojector::curves;
using namespace unprojector::geometry;
using namespace unprojector::landmarks;
using namespace unprojector::mesh;
using ray_meshes::kTurn;
using ray_meshes::modelOf;

const glm::dmat4 kAsItIs(1.0);

std::shared_ptr<const SurfaceMesh> surfaceOf(const Model &model)
{
    return SurfaceMesh::build(model, {});
}

/// The side length is 1; each side is two triangles, and each triangle has corners of its own as in
/// an STL file.
std::shared_ptr<Model> cubeOfTwelve()
{
    std::vector<glm::vec3> soup;
    soup.reserve(36);
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
            const auto corner = [&](int u, int v) {
                glm::vec3 p(0.0f);
                p[axis] = float(side);
                p[(axis + 1) % 3] = float(u);
                p[(axis + 2) % 3] = float(v);
                return p;
            };
            for (const auto &[u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
                soup.push_back(corner(u, v));
        }
    }
    return modelOf(soup);
}

/// A grid over [0, 1] x [0, 1] put anywhere; the rims do not meet.
std::shared_ptr<Model> sheet(std::uint32_t columns, std::uint32_t rows,
                             const std::function<glm::dvec3(double, double)> &at)
{
    Mesh mesh;
    for (std::uint32_t j = 0; j <= rows; ++j) {
        for (std::uint32_t i = 0; i <= columns; ++i)
            mesh.positions.emplace_back(at(double(i) / columns, double(j) / rows));
    }
    for (std::uint32_t j = 0; j < rows; ++j) {
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t a = j * (columns + 1) + i, b = a + 1, d = a + columns + 1, c = d + 1;
            mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
        }
    }
    return modelOf(std::move(mesh));
}

/// A flat sheet without its middle, [0.3, 0.7] x [0.3, 0.7].
std::shared_ptr<Model> sheetWithAHole()
{
    auto model = sheet(30, 30, [](double u, double v) { return glm::dvec3(u, v, 0.0); });
    Mesh &mesh = model->meshes.front();
    std::vector<std::uint32_t> left;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 middle =
            (mesh.position(mesh.indices[i]) + mesh.position(mesh.indices[i + 1]) + mesh.position(mesh.indices[i + 2]))
            / 3.0;
        if (std::max(std::abs(middle.x - 0.5), std::abs(middle.y - 0.5)) > 0.2)
            left.insert(left.end(), mesh.indices.begin() + std::ptrdiff_t(i),
                        mesh.indices.begin() + std::ptrdiff_t(i) + 3);
    }
    mesh.indices = left;
    return model;
}

/// A prism of so many sides, of radius 1 and height 4 along z, without lids: developable to the
/// last digit.
std::shared_ptr<Model> prism(std::uint32_t sides, std::uint32_t rows)
{
    return sheet(sides, rows, [](double u, double v) {
        return u == 1.0 ? glm::dvec3(1.0, 0.0, 4.0 * v) : glm::dvec3(std::cos(kTurn * u), std::sin(kTurn * u), 4.0 * v);
    });
}

/// An octahedron whose triangles are divided in four, again and again, onto the unit sphere.
std::shared_ptr<Model> ball(int times)
{
    using Triangle = std::array<glm::dvec3, 3>;
    std::vector<Triangle> triangles;
    for (int i = 0; i < 8; ++i)
        triangles.push_back(
            {glm::dvec3(i & 1 ? -1 : 1, 0, 0), glm::dvec3(0, i & 2 ? -1 : 1, 0), glm::dvec3(0, 0, i & 4 ? -1 : 1)});
    for (; times > 0; --times) {
        std::vector<Triangle> finer;
        for (const auto &[a, b, c] : triangles) {
            const glm::dvec3 ab = glm::normalize(a + b), bc = glm::normalize(b + c), ca = glm::normalize(c + a);
            for (const Triangle &t :
                 {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}})
                finer.push_back(t);
        }
        triangles = std::move(finer);
    }
    std::vector<glm::vec3> soup;
    for (const Triangle &t : triangles)
        soup.insert(soup.end(), t.begin(), t.end());
    return modelOf(soup);
}

/// The place of a surface nearest to a point, by testing all triangles.
SurfacePlace nearestTo(const Model &model, const glm::dvec3 &point)
{
    SurfacePlace best;
    double least = 1e300;
    const Mesh &mesh = model.meshes.front();
    for (std::uint32_t i = 0; i < mesh.triangleCount(); ++i) {
        std::array<glm::dvec3, 3> corners = ray::cornersOf(mesh, i);
        for (glm::dvec3 &corner : corners)
            corner -= point;
        const glm::dvec3 b = ray::closestToOrigin(corners);
        const double away = glm::length(b[0] * corners[0] + b[1] * corners[1] + b[2] * corners[2]);
        if (away < least) {
            least = away;
            best = {i, b};
        }
    }
    return best;
}

double summed(const std::vector<WorldPoint> &places)
{
    double sum = 0.0;
    for (std::size_t i = 1; i < places.size(); ++i)
        sum += glm::distance(places[i - 1].coordinates(), places[i].coordinates());
    return sum;
}

double lengthBetween(const Model &model, const glm::dvec3 &from, const glm::dvec3 &to)
{
    const auto path = geodesic(*surfaceOf(model), nearestTo(model, from), nearestTo(model, to), kAsItIs, {});
    if (!path || std::abs(summed(path->places) - path->length) > 1e-12 * path->length)
        return std::nan("");
    return path->length;
}

Landmark landmarkAt(const Model &model, const glm::dvec3 &at, std::optional<WorldVector> uncertainty = std::nullopt)
{
    const SurfacePlace place = nearestTo(model, at);
    Landmark landmark;
    landmark.anchor = OnTriangle{place.triangle, place.barycentric};
    landmark.world = WorldPoint(at);
    landmark.uncertainty = uncertainty;
    return landmark;
}

} // namespace

class TestSurfacePaths : public QObject {
    Q_OBJECT

private slots:
    void aCubeUnfolds_data()
    {
        addColumn<glm::dvec3>("from");
        addColumn<glm::dvec3>("to");
        addColumn<double>("length");

        newRow("one-triangle") << glm::dvec3(0.2, 0.1, 1) << glm::dvec3(0.9, 0.3, 1) << std::hypot(0.7, 0.2);
        newRow("one-side") << glm::dvec3(0.1, 0.9, 1) << glm::dvec3(0.9, 0.2, 1) << std::hypot(0.8, 0.7);
        newRow("around-an-edge") << glm::dvec3(0.5, 0.2, 1) << glm::dvec3(1, 0.7, 0.5) << std::hypot(1.0, 0.5);
        newRow("opposite-corners") << glm::dvec3(0, 0, 0) << glm::dvec3(1, 1, 1) << std::sqrt(5.0);
        newRow("opposite-sides") << glm::dvec3(0.5, 0.5, 0) << glm::dvec3(0.5, 0.5, 1) << 2.0;
        // Top to front to right beats top to right: the unfolded one turns by the corner.
        newRow("by-a-corner") << glm::dvec3(0.9, 0.95, 1) << glm::dvec3(0.95, 1, 0.2) << std::hypot(0.05, 0.85);
        newRow("along-an-edge") << glm::dvec3(0, 0, 0.25) << glm::dvec3(0, 0, 0.75) << 0.5;
        newRow("one-place") << glm::dvec3(0.3, 0.3, 1) << glm::dvec3(0.3, 0.3, 1) << 0.0;
    }

    void aCubeUnfolds()
    {
        QFETCH(glm::dvec3, from);
        QFETCH(glm::dvec3, to);
        QFETCH(double, length);
        const auto cube = cubeOfTwelve();
        const double there = lengthBetween(*cube, from, to), back = lengthBetween(*cube, to, from);
        QVERIFY2(std::abs(there - length) < 1e-12, qPrintable(QString::number(there, 'g', 17)));
        QVERIFY2(std::abs(back - length) < 1e-12, qPrintable(QString::number(back, 'g', 17)));
    }

    void aPrismUnrolls_data()
    {
        addColumn<int>("sides");
        addColumn<int>("rows");
        addColumn<double>("turn"); // share of a turn, between two corners of the prism
        addColumn<double>("rise");
        for (const auto &[sides, rows] : {std::pair(8, 1), {64, 1}, {64, 40}, {64, 200}}) {
            for (const auto &[turn, rise] :
                 {std::pair(0.25, 1.0), {0.375, 3.0}, {0.125, 0.0}, {0.375, 0.1}, {0.0, 2.0}})
                addRow("%d-sides-%d-rows-%g-%g", sides, rows, turn, rise) << sides << rows << turn << rise;
        }
    }

    void aPrismUnrolls()
    {
        QFETCH(int, sides);
        QFETCH(int, rows);
        QFETCH(double, turn);
        QFETCH(double, rise);
        const auto model = prism(std::uint32_t(sides), std::uint32_t(rows));
        const double around = sides * turn * 2.0 * std::sin(kPi / sides);
        const double expected = std::hypot(around, rise);
        const double got = lengthBetween(*model, glm::dvec3(1.0, 0.0, 0.5),
                                         glm::dvec3(std::cos(kTurn * turn), std::sin(kTurn * turn), 0.5 + rise));
        // The vertices are floats.
        QVERIFY2(std::abs(got - expected) < 1e-6,
                 qPrintable(QString("%1 and not %2").arg(got, 0, 'g', 10).arg(expected, 0, 'g', 10)));
    }

    void aSphereHasGreatCircles_data()
    {
        addColumn<int>("times");
        addColumn<double>("most"); // relative: a polyhedron of such triangles is that much smaller than the sphere
        newRow("512") << 3 << 0.02;
        newRow("8192") << 5 << 0.0015;
        newRow("131072") << 7 << 0.0001;
    }

    void aSphereHasGreatCircles()
    {
        QFETCH(int, times);
        QFETCH(double, most);
        const auto model = ball(times);
        ray_meshes::Aim aim(19);
        for (int i = 0; i < tests::rounds(20); ++i) {
            const glm::dvec3 a = aim.direction(), b = aim.direction();
            const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
            if (angle > 2.8)
                continue; // on the other side many ways are nearly as short
            const double got = lengthBetween(*model, a, b);
            QVERIFY2(std::abs(got / angle - 1.0) < most, qPrintable(QString("%1 of %2").arg(got).arg(angle)));
        }
    }

    /// A sheet with a square cut out of it: the shortest way touches two of its corners.
    void aHoleIsGoneAround()
    {
        const auto model = sheetWithAHole();
        const double got = lengthBetween(*model, glm::dvec3(0.1, 0.55, 0.0), glm::dvec3(0.9, 0.55, 0.0));
        QVERIFY2(std::abs(got - (2.0 * std::hypot(0.2, 0.15) + 0.4)) < 1e-6, qPrintable(QString::number(got, 'g', 12)));
    }

    void verticesAndEdgesHoldEnds()
    {
        const auto model = cubeOfTwelve();
        const auto surface = surfaceOf(*model);
        QCOMPARE(surface->cornerCount(), std::size_t(8));
        const Mesh &mesh = model->meshes.front();
        const auto vertexAt = [&](const glm::vec3 &at) {
            return std::uint32_t(std::find(mesh.positions.begin(), mesh.positions.end(), at) - mesh.positions.begin());
        };
        const auto from = placeOf(AtVertex{vertexAt({0, 0, 0})}, *surface);
        const auto to = placeOf(OnEdge{{vertexAt({1, 1, 1}), vertexAt({1, 0, 1})}, 0.5}, *surface);
        QVERIFY(from && to);
        const auto path = geodesic(*surface, *from, *to, kAsItIs, {});
        QVERIFY(path);
        QVERIFY(std::abs(path->length - std::hypot(2.0, 0.5)) > 0.01); // not by the top
        QVERIFY2(std::abs(path->length - std::hypot(1.0, 1.5)) < 1e-12,
                 qPrintable(QString::number(path->length, 'g', 17)));
        QVERIFY(!placeOf(Free{}, *surface));
        QVERIFY(!placeOf(AtVertex{99}, *surface));
        QVERIFY(!placeOf(OnTriangle{12, {1, 0, 0}}, *surface));
    }

    void thePathStaysOnTheSurface()
    {
        const auto model = ray_meshes::torus(60);
        const auto surface = surfaceOf(*model);
        ray_meshes::Aim aim(5);
        for (int i = 0; i < tests::rounds(50); ++i) {
            const SurfacePlace a{std::uint32_t(aim.below(surface->triangleCount())), {0.2, 0.3, 0.5}};
            const SurfacePlace b{std::uint32_t(aim.below(surface->triangleCount())), {0.6, 0.3, 0.1}};
            const auto path = geodesic(*surface, a, b, kAsItIs, {});
            QVERIFY(path);
            for (const WorldPoint &place : path->places) {
                const SurfacePlace closest = nearestTo(*model, place.coordinates());
                const auto corners = ray::cornersOf(model->meshes.front(), closest.triangle);
                const glm::dvec3 foot = closest.barycentric[0] * corners[0] + closest.barycentric[1] * corners[1]
                                        + closest.barycentric[2] * corners[2];
                QVERIFY(glm::distance(foot, place.coordinates()) < 1e-12);
            }
            const auto back = geodesic(*surface, b, a, kAsItIs, {});
            QVERIFY(back && std::abs(back->length - path->length) < 0.05 * path->length);
        }
    }

    void stretchedObjectsAreMeasuredInTheWorld()
    {
        const auto model = cubeOfTwelve();
        const glm::dmat4 placed =
            glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(1e6, 0, 0)), glm::dvec3(2, 1, 1));
        const auto path = geodesic(*surfaceOf(*model), nearestTo(*model, {0.5, 0.5, 1}),
                                   nearestTo(*model, {1, 0.5, 0.5}), placed, {});
        QVERIFY(path && std::abs(path->length - 1.5) < 1e-9);
        QCOMPARE(path->places.front(), WorldPoint(1e6 + 1.0, 0.5, 1.0));
    }

    void piecesThatDoNotTouchHaveNoPath()
    {
        auto model = cubeOfTwelve();
        std::vector<glm::vec3> &positions = model->meshes.front().positions;
        const std::size_t count = positions.size();
        for (std::size_t i = 0; i < count; ++i)
            positions.push_back(positions[i] + glm::vec3(3, 0, 0));
        const auto path = geodesic(*surfaceOf(*model), nearestTo(*model, {0.5, 0.5, 1}),
                                   nearestTo(*model, {3.5, 0.5, 1}), kAsItIs, {});
        QVERIFY(!path);
    }

    void longWaysAreAsShortAsByTheWholeSearch_data()
    {
        addColumn<std::shared_ptr<const Model>>("model");
        addColumn<int>("longer"); ///< of 25 ways, by more than 10 parts per million

        newRow("head") << examples::bundledModels().at("Head") << 0;
        newRow("hills") << std::shared_ptr<const Model>(cubeSphere(40)) << 1;
        newRow("torus") << std::shared_ptr<const Model>(ray_meshes::torus(100)) << 1;
        newRow("sheet with a hole") << std::shared_ptr<const Model>(sheetWithAHole()) << 0;
    }

    void longWaysAreAsShortAsByTheWholeSearch()
    {
        QFETCH(std::shared_ptr<const Model>, model);
        QFETCH(int, longer);
        const auto mesh = surfaceOf(*model);
        std::mt19937 random(3);
        int count = 0;
        double most = 0.0;
        for (int i = 0; i < tests::rounds(25); ++i) {
            const SurfacePlace from{static_cast<std::uint32_t>(random() % mesh->triangleCount()), {0.2, 0.3, 0.5}},
                to{static_cast<std::uint32_t>(random() % mesh->triangleCount()), {0.5, 0.3, 0.2}};
            const auto whole = geodesic(*mesh, from, to, kAsItIs, {}, std::numeric_limits<std::size_t>::max());
            const auto byWave = geodesic(*mesh, from, to, kAsItIs, {}, 0);
            QVERIFY(whole && byWave);
            QVERIFY(std::abs(summed(byWave->places) - byWave->length) < 1e-12 * byWave->length);
            const double ratio = whole->length > 0.0 ? byWave->length / whole->length : 1.0;
            count += ratio > 1.00001 ? 1 : 0;
            most = std::max(most, ratio);
        }
        const QString told = QStringLiteral("%1 longer, the most by a factor of %2").arg(count).arg(most, 0, 'g', 8);
        QVERIFY2(count <= longer && most < 1.01, qPrintable(told));
    }

    void sheetsThatTouchAtACornerHaveNoLongPath()
    {
        // The wave passes from sheet to sheet by the common corner; a path needs a common edge.
        const auto model = modelOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {0, 1, 2, 0, 3, 4});
        const auto mesh = surfaceOf(*model);
        const SurfacePlace from{0, glm::dvec3(0.2, 0.3, 0.5)}, to{1, glm::dvec3(0.2, 0.3, 0.5)};
        for (const std::size_t most : {std::size_t{0}, kMostEdges}) {
            QVERIFY(!geodesic(*mesh, from, to, kAsItIs, {}, most));
        }
    }

    void progressNeverDecreases_data()
    {
        addColumn<qulonglong>("mostEdges");
        newRow("short") << qulonglong(kMostEdges);
        newRow("long") << qulonglong(100);
    }

    void progressNeverDecreases()
    {
        QFETCH(qulonglong, mostEdges);
        const auto model = ball(6);
        const auto mesh = surfaceOf(*model);
        const SurfacePlace from = nearestTo(*model, {0, 0, 1}), to = nearestTo(*model, {0.3, 0.1, -0.9});
        std::vector<double> shares;
        const auto record = [&shares](double share) {
            shares.push_back(share);
            return true;
        };
        QVERIFY(geodesic(*mesh, from, to, kAsItIs, record, mostEdges));
        QVERIFY(shares.size() > 5);
        QVERIFY(std::is_sorted(shares.begin(), shares.end()));
        QVERIFY(shares.front() >= 0.0 && shares.back() <= 1.0);
        QVERIFY(std::any_of(shares.begin(), shares.end(), [](double share) { return share > 0.05 && share < 0.7; }));
        // Each call can stop the work.
        for (const std::size_t stop : {std::size_t{1}, shares.size() / 2, shares.size()}) {
            std::size_t calls = 0;
            QVERIFY_THROWS_EXCEPTION(base::Stopped,
                                     geodesic(
                                         *mesh, from, to, kAsItIs, [&](double) { return ++calls < stop; }, mostEdges));
            QCOMPARE(calls, stop);
        }
    }

    void workIsEndedWhenAsked()
    {
        const auto model = ball(4);
        QVERIFY(!SurfaceMesh::build(*model, [](double) { return false; }));
        const auto stop = [](double) { return false; };
        QVERIFY_THROWS_EXCEPTION(base::Stopped, geodesic(*surfaceOf(*model), nearestTo(*model, {0, 0, 1}),
                                                         nearestTo(*model, {0, 1, 0}), kAsItIs, stop));
    }

    void planesCutSpheresInCircles()
    {
        const auto model = ball(6);
        const glm::dvec3 a = glm::normalize(glm::dvec3(1, 0.2, 0.1)), b = glm::normalize(glm::dvec3(0.1, 1, 0.3));
        const auto path = planeSection(*surfaceOf(*model), nearestTo(*model, a), nearestTo(*model, b), kAsItIs, {});
        QVERIFY(path);
        const double angle = std::acos(glm::dot(a, b));
        QVERIFY2(std::abs(path->length / angle - 1.0) < 1e-3, qPrintable(QString::number(path->length)));
        QVERIFY(std::abs(summed(path->places) - path->length) < 1e-12);
        // All of it lies in one plane.
        const glm::dvec3 p = path->places.front().coordinates(), q = path->places.back().coordinates();
        const glm::dvec3 r = path->places[path->places.size() / 2].coordinates();
        const glm::dvec3 normal = glm::normalize(glm::cross(q - p, r - p));
        for (const WorldPoint &place : path->places)
            QVERIFY(std::abs(glm::dot(normal, place.coordinates() - p)) < 1e-9);
    }

    void thereIsNoPlaneAlongTheNormal()
    {
        const auto model = cubeOfTwelve();
        const auto path = planeSection(*surfaceOf(*model), nearestTo(*model, {0.4, 0.3, 0}),
                                       nearestTo(*model, {0.4, 0.3, 1}), kAsItIs, {});
        QVERIFY(!path);
    }

    void linesGoThroughAllTheirPoints()
    {
        const auto model = cubeOfTwelve();
        const Landmark a = landmarkAt(*model, {0.2, 0.5, 1}), b = landmarkAt(*model, {0.8, 0.5, 1}),
                       c = landmarkAt(*model, {1, 0.5, 0.5});
        const std::array points{&a, &b, &c};
        for (const CurveKind kind : {CurveKind::Geodesic, CurveKind::PlaneSection}) {
            const auto line = lineThrough(*surfaceOf(*model), points, kind, kAsItIs, {});
            QVERIFY(line);
            QVERIFY2(std::abs(line->length.value - 1.3) < 1e-7,
                     qPrintable(QString::number(line->length.value, 'g', 12)));
            QVERIFY(std::abs(summed(line->path) - line->length.value) < 1e-12);
            const auto passes = [&](const Landmark &landmark) {
                return std::any_of(line->path.begin(), line->path.end(), [&](const WorldPoint &place) {
                    return glm::distance(place.coordinates(), landmark.world->coordinates()) < 1e-7;
                });
            };
            QVERIFY(passes(a) && passes(b) && passes(c));
            QVERIFY(!line->length.error);
        }
    }

    void lengthsErrByTheirEnds()
    {
        const auto model = cubeOfTwelve();
        const WorldVector off(0.01, 0.02, 0.03);
        const Landmark a = landmarkAt(*model, {0.2, 0.5, 1}, off), b = landmarkAt(*model, {0.8, 0.5, 1}, off),
                       c = landmarkAt(*model, {1, 0.5, 0.5}, off);
        const std::array points{&a, &b, &c};
        const auto line = lineThrough(*surfaceOf(*model), points, CurveKind::Geodesic, kAsItIs, {});
        // a along x; b is passed straight on and adds nothing; c comes down along z.
        QVERIFY(line && line->length.error);
        QVERIFY2(std::abs(*line->length.error - 0.04) < 1e-6, qPrintable(QString::number(*line->length.error)));
    }

    void linesSayWhatIsWrong()
    {
        const auto model = cubeOfTwelve();
        const auto surface = surfaceOf(*model);
        const Landmark a = landmarkAt(*model, {0.2, 0.5, 1});
        Landmark free = a;
        free.anchor = Free{};
        const Landmark missing;
        const auto errorOf = [&](std::vector<const Landmark *> points) {
            const auto line = lineThrough(*surface, points, CurveKind::Geodesic, kAsItIs, {});
            return line ? std::pair(-1, std::size_t(0)) : std::pair(int(line.error().code), line.error().point);
        };
        QCOMPARE(errorOf({&a}).first, int(CurveError::Code::TooFew));
        QCOMPARE(errorOf({&a, &free}), std::pair(int(CurveError::Code::NotOnSurface), std::size_t(1)));
        QCOMPARE(errorOf({&a, &a, &missing}), std::pair(int(CurveError::Code::Missing), std::size_t(2)));
        // Weights as files may have them: no corner has one, or their sum is no usable number.
        for (const glm::dvec3 &weights : {glm::dvec3(0.0), glm::dvec3(-1.0, 0.0, -0.5), glm::dvec3(1e308)}) {
            Landmark unheld = a;
            unheld.anchor = OnTriangle{0, weights};
            QCOMPARE(errorOf({&a, &unheld}), std::pair(int(CurveError::Code::NotOnSurface), std::size_t(1)));
        }
    }

    void stepsAreEqual()
    {
        const std::vector<WorldPoint> corner{WorldPoint(0, 0, 0), WorldPoint(1, 0, 0), WorldPoint(1, 2, 0)};
        const std::vector<WorldPoint> four = resampled(corner, 4);
        QCOMPARE(four, (std::vector<WorldPoint>{WorldPoint(0, 0, 0), WorldPoint(1, 0, 0), WorldPoint(1, 1, 0),
                                                WorldPoint(1, 2, 0)}));
        QCOMPARE(resampled(corner, 2), (std::vector<WorldPoint>{corner.front(), corner.back()}));
        const auto model = ray_meshes::torus(60);
        const auto path = geodesic(*surfaceOf(*model), {0, {0.2, 0.3, 0.5}}, {2500, {0.2, 0.3, 0.5}}, kAsItIs, {});
        QVERIFY(path);
        const std::vector<WorldPoint> places = resampled(path->places, 12);
        QCOMPARE(places.size(), std::size_t(12));
        QCOMPARE(places.front(), path->places.front());
        QCOMPARE(places.back(), path->places.back());
        // Along the path, all steps are the same: cut there, the pieces are as long.
        double reached = 0.0;
        std::size_t at = 1;
        for (std::size_t i = 0; i + 1 < path->places.size() && at + 1 < places.size(); ++i) {
            const glm::dvec3 p = path->places[i].coordinates(), q = path->places[i + 1].coordinates();
            const double piece = glm::distance(p, q);
            while (at + 1 < places.size()
                   && glm::distance(p, places[at].coordinates()) + glm::distance(places[at].coordinates(), q) - piece
                          < 1e-13) {
                const double along = reached + glm::distance(p, places[at].coordinates());
                QVERIFY(std::abs(along - path->length * double(at) / 11.0) < 1e-9);
                ++at;
            }
            reached += piece;
        }
        QCOMPARE(at, std::size_t(11));
    }

    void aPathWithoutALengthIsResampled()
    {
        const WorldPoint p(1, 2, 3);
        QCOMPARE(resampled(std::vector{p}, 3), (std::vector{p, p, p}));
        QCOMPARE(resampled(std::vector{p, p}, 3), (std::vector{p, p, p}));
    }
};

UNPROJECTOR_TEST(TestSurfacePaths)
#include "test_surface_paths.moc"
