// Coarse models that are drawn while the view moves.

#include "tests/support/test.h"

#include "core/examples/solids.h"
#include "core/geometry/numbers.h"
#include "core/mesh/stand_in.h"
#include "tests/support/mesh_model.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::mesh;

namespace {

constexpr double kRadius = 2.0;

/// 327,680 triangles.
Mesh ball()
{
    return examples::sphereMesh(kRadius, 7);
}

Mesh pointsOf(const Mesh &mesh)
{
    Mesh points;
    points.kind = Mesh::Kind::Points;
    points.positions = mesh.positions;
    return points;
}

} // namespace

class TestStandIn : public QObject {
    Q_OBJECT

private slots:
    void itIsCoarseAndLooksAlike_data()
    {
        addColumn<bool>("isSoup");
        addColumn<int>("most");
        newRow("indexed") << false << 20000;
        newRow("as the vertices come") << true << 20000;
        newRow("very coarse") << false << 500;
    }

    void itIsCoarseAndLooksAlike()
    {
        QFETCH(bool, isSoup);
        QFETCH(int, most);
        const Model model = *modelOf(isSoup ? soupOf(ball()) : ball());
        const Model standIn = standInFor(model, static_cast<std::size_t>(most));
        QCOMPARE(standIn.meshes.size(), std::size_t(1));
        const Mesh &mesh = standIn.meshes.front();
        QVERIFY2(mesh.triangleCount() < 1.3 * most && mesh.triangleCount() > 0.4 * most,
                 qPrintable(QString::number(mesh.triangleCount())));
        QCOMPARE(mesh.normals.size(), mesh.positions.size());
        // A cell is about this wide; the mean of its vertices lies at most half of it inside.
        const double cell = std::sqrt(3.0 * 4.0 * kPi * kRadius * kRadius / most);
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const double distance = glm::length(glm::dvec3(mesh.positions[v]));
            QVERIFY(distance <= kRadius + 1e-6 && distance > kRadius - 0.5 * cell);
            QVERIFY(glm::dot(glm::dvec3(mesh.normals[v]), glm::dvec3(mesh.positions[v])) > 0.9 * distance);
        }
        std::set<std::array<std::uint32_t, 3>> seen;
        double area = 0.0, turnedOver = 0.0;
        for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
            std::array<std::uint32_t, 3> corners{mesh.indices[3 * t], mesh.indices[3 * t + 1], mesh.indices[3 * t + 2]};
            const glm::dvec3 a(mesh.positions[corners[0]]), b(mesh.positions[corners[1]]),
                c(mesh.positions[corners[2]]);
            const glm::dvec3 normal = glm::cross(b - a, c - a);
            (glm::dot(normal, a + b + c) < 0.0 ? turnedOver : area) += glm::length(normal) / 2.0;
            std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
            QVERIFY2(seen.insert(corners).second, "a triangle is there twice");
        }
        QVERIFY2(area > 0.8 * 4.0 * kPi * kRadius * kRadius, "the surface has holes");
        QVERIFY2(turnedOver < 0.05 * area, "it is folded");
    }

    void whatIsClosedStaysSo_data()
    {
        addColumn<std::vector<Mesh>>("pieces");
        addColumn<bool>("isClosed");
        Mesh holed = ball(), insideOut = ball(), smallInsideOut = examples::sphereMesh(kRadius / 4.0, 5);
        holed.indices.resize(holed.indices.size() * 9 / 10);
        for (Mesh *mesh : {&insideOut, &smallInsideOut}) {
            for (std::size_t i = 0; i < mesh->indices.size(); i += 3)
                std::swap(mesh->indices[i], mesh->indices[i + 1]);
        }
        Mesh beside = ball(), halfTurned = ball();
        for (glm::vec3 &position : beside.positions)
            position.x += 5.0f;
        for (std::size_t i = 0; i < halfTurned.indices.size() / 2; i += 3)
            std::swap(halfTurned.indices[i], halfTurned.indices[i + 1]);
        newRow("a ball") << std::vector{ball()} << true;
        newRow("a ball as a soup") << std::vector{soupOf(ball())} << true;
        newRow("two balls") << std::vector{ball(), beside} << true;
        newRow("a ball with a hole") << std::vector{holed} << false;
        newRow("two balls, one with a hole") << std::vector{beside, holed} << false;
        newRow("a ball inside out") << std::vector{insideOut} << false;
        newRow("a hollow ball") << std::vector{ball(), smallInsideOut} << false;
        newRow("a ball of which half is turned over") << std::vector{halfTurned} << false;
        newRow("points") << std::vector{pointsOf(ball())} << false;
    }

    void whatIsClosedStaysSo()
    {
        QFETCH(std::vector<Mesh>, pieces);
        QFETCH(bool, isClosed);
        Mesh mesh = pieces[0];
        for (std::size_t i = 1; i < pieces.size(); ++i) {
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            mesh.positions.insert(mesh.positions.end(), pieces[i].positions.begin(), pieces[i].positions.end());
            for (const std::uint32_t index : pieces[i].indices)
                mesh.indices.push_back(first + index);
        }
        const Model standIn = standInFor(*modelOf(mesh), 20000);
        QCOMPARE(standIn.meshes.front().isClosed, isClosed);
    }

    void pointsAreThinnedOut()
    {
        const Model model = *modelOf(pointsOf(ball()));
        const Model standIn = standInFor(model, 5000);
        QCOMPARE(standIn.meshes.size(), std::size_t(1));
        QCOMPARE(standIn.triangleCount(), std::size_t(0));
        QVERIFY(standIn.pointCount() < 5000 && standIn.pointCount() > 500);
    }

    void itKeepsWhatTheMeshLooksLike()
    {
        Mesh mesh = ball();
        mesh.origin = {1e6, 0.0, 0.0};
        mesh.baseColor = {1.0f, 0.0f, 0.0f, 1.0f};
        mesh.colors.assign(mesh.positions.size(), glm::u8vec4(1, 2, 3, 255));
        mesh.texture = 0;
        mesh.texcoords.assign(mesh.positions.size(), glm::vec2(0.25f));
        Model model = *modelOf(std::move(mesh));
        model.textures.emplace_back();
        const Model standIn = standInFor(model, 1000);
        const Mesh &coarse = standIn.meshes.front();
        QVERIFY(coarse.origin == glm::dvec3(1e6, 0.0, 0.0));
        QVERIFY(coarse.baseColor == glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
        QCOMPARE(coarse.texture, 0);
        QCOMPARE(standIn.textures.size(), std::size_t(1));
        QCOMPARE(coarse.colors, std::vector<glm::u8vec4>(coarse.positions.size(), glm::u8vec4(1, 2, 3, 255)));
        QCOMPARE(coarse.texcoords, std::vector<glm::vec2>(coarse.positions.size(), glm::vec2(0.25f)));
    }

    void itCanBeEnded()
    {
        double last = 0.0;
        int calls = 0;
        const Model standIn = standInFor(*modelOf(soupOf(ball())), 1000, [&](double share) {
            last = share;
            ++calls;
            return false;
        });
        QVERIFY(standIn.meshes.empty());
        QCOMPARE(calls, 1);
        QVERIFY(last > 0.0 && last <= 1.0);
    }

    void nothingComesOfNothing()
    {
        QVERIFY(standInFor(Model(), 1000).meshes.empty());
        Mesh flat;
        flat.positions.assign(3, glm::vec3(1.0f));
        QVERIFY2(standInFor(*modelOf(flat), 1000).meshes.empty(), "a triangle without area is not seen");
    }
};

UNPROJECTOR_TEST(TestStandIn)
#include "test_stand_in.moc"
