#include "core/mesh/stand_in.h"

#include "core/mesh/numbering.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>

namespace unprojector::mesh {
using namespace geometry;

namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr std::size_t kElementsBetweenReports = std::size_t{1} << 18;

/// A hash of an edge.
std::uint64_t edgeHash(std::uint32_t from, std::uint32_t to)
{
    std::uint64_t x = (std::uint64_t{from} << 32 | to) + 0x9e3779b97f4a7c15ull;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

/// Returns whether every edge has equally many triangles in both directions. It adds the hashes of
/// one direction and subtracts the hashes of the other: this needs neither sorting nor memory per
/// edge. A collision of the 64-bit sum is negligible.
bool areEdgesPaired(std::span<const std::array<std::uint32_t, 3>> triangles)
{
    std::uint64_t sum = 0;
    for (const std::array<std::uint32_t, 3> &corners : triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = corners[i], to = corners[(i + 1) % 3];
            if (from < to)
                sum += edgeHash(from, to);
            else
                sum -= edgeHash(to, from);
        }
    }
    return sum == 0;
}

/// Returns whether triangles form the whole surface of one or more bodies with their front sides
/// outwards. That is: each edge has equally many triangles in both directions, and no connected
/// piece has a negative volume. Seen from outside, a front side always hides the back sides of such
/// a surface.
/// @param triangles    vertex numbers of the corners: touching triangles share them. No triangle
///         has a corner twice
/// @param leastVolume  of a piece that counts, cubic units
bool isClosedOutwards(std::span<const std::array<std::uint32_t, 3>> triangles, const std::vector<glm::dvec3> &positions,
                      double leastVolume)
{
    if (triangles.empty() || !areEdgesPaired(triangles))
        return false;
    JoinedGroups pieces(positions.size());
    for (const std::array<std::uint32_t, 3> &corners : triangles) {
        pieces.join(corners[0], corners[1]);
        pieces.join(corners[0], corners[2]);
    }
    std::vector<double> volumes(positions.size(), 0.0);
    for (const std::array<std::uint32_t, 3> &corners : triangles) {
        const std::uint32_t piece = pieces.of(corners[0]);
        // Relative to a vertex of the piece, so that its volume keeps its digits.
        const glm::dvec3 about = positions[piece];
        volumes[piece] += glm::dot(positions[corners[0]] - about,
                                   glm::cross(positions[corners[1]] - about, positions[corners[2]] - about))
                          / 6.0;
    }
    return std::none_of(volumes.begin(), volumes.end(), [&](double volume) { return volume < -leastVolume; });
}

/// The sums over the vertices in one cell.
struct Cluster {
    glm::dvec3 sum{0.0};
    double count = 0.0;
    glm::dvec3 normal{0.0};
    std::uint32_t first = 0; ///< its colour and texture coordinate represent all
};

/// A triangle's normal, as long as twice its area.
glm::dvec3 normalOf(const Mesh &mesh, std::size_t triangle)
{
    const glm::dvec3 a(mesh.positions[mesh.vertexAt(3 * triangle)]);
    const glm::dvec3 b(mesh.positions[mesh.vertexAt(3 * triangle + 1)]);
    const glm::dvec3 c(mesh.positions[mesh.vertexAt(3 * triangle + 2)]);
    return glm::cross(b - a, c - a);
}

/// The cell width for a target count. A surface keeps about two and a half triangles per square as
/// wide as a cell, because cells are cut at their corners as well as through their middles.
double cellWidth(const Model &model, std::size_t most)
{
    double area = 0.0;
    Box points;
    for (const Mesh &mesh : model.meshes) {
        double own = 0.0;
        for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
            own += glm::length(normalOf(mesh, t)) / 2.0;
        area += own;
        if (mesh.kind == Mesh::Kind::Points)
            points.add(boundsOf(std::vector{mesh}));
    }
    // Points usually lie on a surface, which is about as large as their box's.
    if (!points.isEmpty()) {
        const glm::dvec3 size = points.highest - points.lowest;
        area += 2.0 * (size.x * size.y + size.y * size.z + size.z * size.x);
    }
    constexpr double kTrianglesPerSquare = 3.0;
    const double width = std::sqrt(kTrianglesPerSquare * area / static_cast<double>(std::max<std::size_t>(most, 1)));
    return width > 0.0 && std::isfinite(width) ? width : 1.0;
}

/// @param step  called for each element
Mesh clustered(const Mesh &mesh, double width, const std::function<void()> &step)
{
    Mesh coarse;
    coarse.kind = mesh.kind;
    coarse.origin = mesh.origin;
    coarse.baseColor = mesh.baseColor;
    coarse.texture = mesh.texture;

    // The cells of a grid, fine enough for a few hundred thousand of a surface.
    Numbering<std::array<std::uint32_t, 3>> cells(std::size_t{1} << 15);
    const auto cellAt = [&cells, perUnit = 1.0 / width](const glm::dvec3 &place) {
        constexpr double kHalf = 1 << 20;
        std::array<std::uint32_t, 3> cell{};
        for (int axis = 0; axis < 3; ++axis)
            cell[static_cast<std::size_t>(axis)] =
                static_cast<std::uint32_t>(std::clamp(std::floor(place[axis] * perUnit), -kHalf, kHalf - 1.0) + kHalf);
        return cells.add(cell);
    };
    std::vector<Cluster> clusters;
    std::vector<std::uint32_t> clusterOfVertex(mesh.positions.size(), kNone);
    const auto clusterAt = [&](std::size_t element) {
        const std::size_t vertex = mesh.vertexAt(element);
        std::uint32_t &known = clusterOfVertex[vertex];
        if (known != kNone)
            return known;
        const glm::dvec3 place(mesh.positions[vertex]);
        known = cellAt(place);
        if (known == clusters.size()) {
            clusters.emplace_back();
            clusters.back().first = static_cast<std::uint32_t>(vertex);
        }
        clusters[known].sum += place;
        clusters[known].count += 1.0;
        return known;
    };
    std::vector<std::array<std::uint32_t, 3>> triangles;
    if (mesh.kind == Mesh::Kind::Points) {
        for (std::size_t point = 0; point < mesh.pointCount(); ++point) {
            step();
            clusterAt(point);
        }
    } else {
        for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
            step();
            const std::array corners{clusterAt(3 * t), clusterAt(3 * t + 1), clusterAt(3 * t + 2)};
            const glm::dvec3 normal = normalOf(mesh, t);
            for (const std::uint32_t corner : corners)
                clusters[corner].normal += normal;
            if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
                triangles.push_back(corners);
        }
    }
    std::vector<glm::dvec3> means;
    for (const Cluster &cluster : clusters)
        means.push_back(cluster.sum / cluster.count);
    // Merging vertices keeps a closed surface closed. Overlapping or flipped triangles in a fold
    // are a part of that, and stay unchanged.
    coarse.isClosed = isClosedOutwards(triangles, means, width * width * width);
    // A triangle of a thin or folded mesh may come out flipped, and would be lit from behind.
    for (std::array<std::uint32_t, 3> &corners : triangles) {
        if (coarse.isClosed)
            break;
        const glm::dvec3 a = means[corners[0]];
        const glm::dvec3 normal = glm::cross(means[corners[1]] - a, means[corners[2]] - a);
        glm::dvec3 meant(0.0);
        for (const std::uint32_t corner : corners)
            meant += clusters[corner].normal;
        if (glm::dot(normal, meant) < 0.0)
            std::swap(corners[1], corners[2]);
    }
    // Many triangles of a fine mesh collapse to the same three cells.
    for (std::array<std::uint32_t, 3> &corners : triangles)
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    for (const std::array<std::uint32_t, 3> &corners : triangles)
        coarse.indices.insert(coarse.indices.end(), corners.begin(), corners.end());
    coarse.positions.assign(means.begin(), means.end());
    for (const Cluster &cluster : clusters) {
        if (mesh.kind == Mesh::Kind::Triangles) {
            const double length = glm::length(cluster.normal);
            coarse.normals.emplace_back(length > 0.0 ? cluster.normal / length : glm::dvec3(0.0, 0.0, 1.0));
        }
        if (!mesh.colors.empty())
            coarse.colors.push_back(mesh.colors[cluster.first]);
        if (!mesh.texcoords.empty())
            coarse.texcoords.push_back(mesh.texcoords[cluster.first]);
    }
    return coarse;
}

} // namespace

Model standInFor(const Model &model, std::size_t most, const base::Progress &progress)
try {
    Model coarse;
    coarse.name = model.name;
    base::Reporter reporter(progress);
    std::size_t done = 0;
    const auto total = static_cast<double>(model.triangleCount() + model.pointCount());
    const auto step = [&] {
        if (++done % kElementsBetweenReports == 0)
            reporter.report(static_cast<double>(done) / total);
    };
    const double width = cellWidth(model, most);
    for (const Mesh &mesh : model.meshes) {
        Mesh next = clustered(mesh, width, step);
        // Drops meshes smaller than a cell: triangles without indices would be drawn in vertex
        // order.
        if (mesh.kind == Mesh::Kind::Points || !next.indices.empty())
            coarse.meshes.push_back(std::move(next));
    }
    coarse.textures = model.textures;
    coarse.bounds = model.bounds;
    return coarse;
} catch (const base::Stopped &) {
    return {};
}

} // namespace unprojector::mesh
