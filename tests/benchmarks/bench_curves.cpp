// Curves on a mesh, compared in the same run with their two ingredients:
// - the surface mesh below them, built once a model;
// - the shortest path along its edges by Dijkstra's algorithm in the plainest form, stopped at the
//   other end.
//   bench_curves [triangles …], 1000000 without any
// Or a long curve on the bundled head, whose triangles are divided into n * n each: from the nose to
// the back of the head. 17 gives 13 million triangles. --whole: by the search of the whole surface.
//   bench_curves --head [--whole] n

#include "core/curves/surface_path.h"
#include "core/examples/solids.h"
#include "tests/support/cube_sphere.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <queue>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace unprojector;
using namespace unprojector::curves;
using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The length of the shortest path along the edges from a corner to another.
double alongEdges(const SurfaceMesh &mesh, std::uint32_t from, std::uint32_t to)
{
    using Reached = std::pair<double, std::uint32_t>;
    std::vector<double> least(mesh.cornerCount(), std::numeric_limits<double>::infinity());
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
    least[from] = 0.0;
    open.emplace(0.0, from);
    while (!open.empty() && open.top().second != to) {
        const auto [way, corner] = open.top();
        open.pop();
        if (way > least[corner])
            continue;
        for (const std::uint32_t triangle : mesh.around(corner)) {
            for (const std::uint32_t next : mesh.corners(triangle)) {
                const double there = way + glm::distance(mesh.place(corner), mesh.place(next));
                if (there < least[next]) {
                    least[next] = there;
                    open.emplace(there, next);
                }
            }
        }
    }
    return least[to];
}

struct Times {
    double median = 0.0, worst = 0.0; ///< seconds
};

Times of(std::vector<double> times)
{
    std::sort(times.begin(), times.end());
    return {times[times.size() / 2], times.back()};
}

void measure(std::uint32_t triangles)
{
    const auto sphere = cubeSphere(static_cast<std::uint32_t>(std::lround(std::sqrt(triangles / 12.0))));
    std::vector<double> building;
    std::shared_ptr<const SurfaceMesh> mesh;
    for (int i = 0; i < 3; ++i) {
        const Clock::time_point start = Clock::now();
        mesh = SurfaceMesh::build(*sphere, {});
        building.push_back(secondsSince(start));
    }
    constexpr int kCurves = 25;
    std::vector<double> geodesics, sections, edges;
    double longer = 0.0; // the path along the edges, than the geodesic
    int cut = 0;
    std::mt19937 random(1);
    for (int i = 0; i < kCurves; ++i) {
        const SurfacePlace from{static_cast<std::uint32_t>(random() % mesh->triangleCount()),
                                glm::dvec3(1.0, 0.0, 0.0)},
            to{static_cast<std::uint32_t>(random() % mesh->triangleCount()), glm::dvec3(1.0, 0.0, 0.0)};
        Clock::time_point start = Clock::now();
        const auto line = geodesic(*mesh, from, to, glm::dmat4(1.0), {});
        geodesics.push_back(secondsSince(start));
        start = Clock::now();
        cut += planeSection(*mesh, from, to, glm::dmat4(1.0), {}) ? 1 : 0;
        sections.push_back(secondsSince(start));
        start = Clock::now();
        const double way = alongEdges(*mesh, mesh->corners(from.triangle)[0], mesh->corners(to.triangle)[0]);
        edges.push_back(secondsSince(start));
        if (line && line->length > 0.0)
            longer = std::max(longer, way / line->length - 1.0);
    }
    const double surface = of(building).median;
    const Times plain = of(edges);
    std::printf("%u triangles; %d pairs of places, of which %d have a plane section\n", mesh->triangleCount(), kCurves,
                cut);
    std::printf("  %-34s %10s %10s %14s %14s\n", "", "median", "worst", "of the surface", "of Dijkstra's");
    const auto row = [&](const char *name, const Times &times) {
        std::printf("  %-34s %8.1f ms %8.1f ms %14.3f %14.3f\n", name, 1e3 * times.median, 1e3 * times.worst,
                    times.median / surface, times.median / plain.median);
    };
    row("the surface mesh, once", of(building));
    row("geodesic", of(geodesics));
    row("plane section", of(sections));
    row("along the edges, by Dijkstra", plain);
    std::printf("  the way along the edges is up to %.1f %% longer than the geodesic\n", 100.0 * longer);
}

/// A mesh with its triangles divided into n * n. Points of a common edge have equal coordinates.
std::shared_ptr<mesh::Model> divided(const mesh::Mesh &mesh, std::uint32_t n)
{
    mesh::Mesh fine;
    for (std::size_t triangle = 0; triangle < mesh.triangleCount(); ++triangle) {
        std::array<std::size_t, 3> ids{mesh.vertexAt(3 * triangle), mesh.vertexAt(3 * triangle + 1),
                                       mesh.vertexAt(3 * triangle + 2)};
        const bool isOdd = (ids[0] > ids[1]) ^ (ids[1] > ids[2]) ^ (ids[0] > ids[2]);
        std::sort(ids.begin(), ids.end()); // so that both triangles of an edge round in the same way
        const glm::dvec3 a(mesh.positions[ids[0]]), b(mesh.positions[ids[1]]), c(mesh.positions[ids[2]]);
        const auto first = static_cast<std::uint32_t>(fine.positions.size());
        const auto number = [&](std::uint32_t i, std::uint32_t j) { return first + i * (i + 1) / 2 + j; };
        for (std::uint32_t i = 0; i <= n; ++i) { // towards b and c; j from b to c
            for (std::uint32_t j = 0; j <= i; ++j)
                fine.positions.emplace_back((double(n - i) * a + double(i - j) * b + double(j) * c) / double(n));
        }
        const auto add = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
            fine.indices.insert(fine.indices.end(), {p, isOdd ? r : q, isOdd ? q : r});
        };
        for (std::uint32_t i = 0; i < n; ++i) {
            for (std::uint32_t j = 0; j <= i; ++j) {
                add(number(i, j), number(i + 1, j), number(i + 1, j + 1));
                if (j < i)
                    add(number(i, j), number(i + 1, j + 1), number(i, j + 1));
            }
        }
    }
    auto model = std::make_shared<mesh::Model>();
    model->meshes.push_back(std::move(fine));
    return model;
}

/// The triangle whose first corner lies farthest in a direction.
std::uint32_t outermost(const SurfaceMesh &mesh, const glm::dvec3 &direction)
{
    std::uint32_t best = 0;
    for (std::uint32_t i = 0; i < mesh.triangleCount(); ++i) {
        if (glm::dot(mesh.place(mesh.corners(i)[0]) - mesh.place(mesh.corners(best)[0]), direction) > 0.0)
            best = i;
    }
    return best;
}

void measureHead(std::uint32_t n, bool isWhole)
{
    const auto model = divided(examples::headMesh(), n);
    Clock::time_point start = Clock::now();
    const auto mesh = SurfaceMesh::build(*model, {});
    std::printf("%u triangles; the surface mesh %.1f s\n", mesh->triangleCount(), secondsSince(start));
    const SurfacePlace from{outermost(*mesh, {0.05, 0.0, 1.0}), glm::dvec3(0.2, 0.3, 0.5)},
        to{outermost(*mesh, {-0.2, 0.1, -1.0}), glm::dvec3(0.2, 0.3, 0.5)};
    start = Clock::now();
    int calls = 0;
    const auto line = geodesic(
        *mesh, from, to, glm::dmat4(1.0),
        [&calls](double) {
            ++calls;
            return true;
        },
        isWhole ? std::numeric_limits<std::size_t>::max() : kMostEdges);
    std::printf("geodesic%s: %.1f s, length %.15g, %zu places, %d calls of progress\n", isWhole ? ", whole" : "",
                secondsSince(start), line ? line->length : 0.0, line ? line->places.size() : 0, calls);
}

} // namespace

int main(int argc, char **argv)
{
    if (argc > 2 && std::string(argv[1]) == "--head") {
        const bool isWhole = std::string(argv[2]) == "--whole";
        measureHead(static_cast<std::uint32_t>(std::strtoul(argv[argc - 1], nullptr, 10)), isWhole);
        return 0;
    }
    std::vector<std::uint32_t> sizes;
    for (int i = 1; i < argc; ++i)
        sizes.push_back(static_cast<std::uint32_t>(std::strtoul(argv[i], nullptr, 10)));
    if (sizes.empty())
        sizes.push_back(1'000'000);
    for (const std::uint32_t size : sizes)
        measure(size);
    return 0;
}
