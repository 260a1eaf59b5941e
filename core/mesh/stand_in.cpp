#include "core/mesh/stand_in.h"

#include "core/mesh/closed_surface.h"
#include "core/mesh/numbering.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace unprojector::mesh {
using namespace geometry;

namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr std::size_t kElementsBetweenReports = std::size_t{1} << 18;

/// Reports from time to time.
class Steps {
public:
    Steps(const base::Progress &progress, std::size_t total) : m_reporter(progress), m_total(total) {}
    void next()
    {
        if (++m_done % kElementsBetweenReports == 0)
            m_reporter.report(static_cast<double>(m_done) / static_cast<double>(m_total));
    }

private:
    base::Reporter m_reporter;
    std::size_t m_total;
    std::size_t m_done = 0;
};

/// Numbers the cells of a grid in the order of first use.
class Cells {
public:
    explicit Cells(double width) : m_perUnit(1.0 / width) {}

    std::uint32_t at(const glm::dvec3 &place)
    {
        // Fine enough for a few hundred thousand cells of a surface.
        constexpr double kHalf = 1 << 20;
        std::array<std::uint32_t, 3> cell{};
        for (int axis = 0; axis < 3; ++axis)
            cell[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(
                std::clamp(std::floor(place[axis] * m_perUnit), -kHalf, kHalf - 1.0) + kHalf);
        return m_numbers.add(cell);
    }

private:
    double m_perUnit;
    Numbering<std::array<std::uint32_t, 3>> m_numbers{std::size_t{1} << 15};
};

/// The sums over the vertices in one cell.
struct Cluster {
    glm::dvec3 sum{0.0};
    double count = 0.0;
    glm::dvec3 normal{0.0};
    std::uint32_t first = 0; ///< its colour and texture coordinate represent all
};

double areaOf(const Mesh &mesh)
{
    double sum = 0.0;
    for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
        const glm::dvec3 a(mesh.positions[mesh.vertexAt(3 * t)]);
        const glm::dvec3 b(mesh.positions[mesh.vertexAt(3 * t + 1)]);
        const glm::dvec3 c(mesh.positions[mesh.vertexAt(3 * t + 2)]);
        sum += glm::length(glm::cross(b - a, c - a)) / 2.0;
    }
    return sum;
}

/// The cell width for a target count. A surface keeps about two and a half triangles per square as
/// wide as a cell, because cells are cut at their corners as well as through their middles.
double cellWidth(const Model &model, std::size_t most)
{
    double area = 0.0;
    Box points;
    for (const Mesh &mesh : model.meshes) {
        area += areaOf(mesh);
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

/// Removes duplicate triangles: many triangles of a fine mesh collapse to the same three cells.
void removeRepeated(std::vector<std::array<std::uint32_t, 3>> &triangles)
{
    for (std::array<std::uint32_t, 3> &corners : triangles)
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
}

Mesh clustered(const Mesh &mesh, double width, Steps &steps)
{
    Mesh coarse;
    coarse.kind = mesh.kind;
    coarse.origin = mesh.origin;
    coarse.baseColor = mesh.baseColor;
    coarse.texture = mesh.texture;

    Cells cells(width);
    std::vector<Cluster> clusters;
    std::vector<std::uint32_t> clusterOfVertex(mesh.positions.size(), kNone);
    const auto clusterAt = [&](std::size_t element) {
        const std::size_t vertex = mesh.vertexAt(element);
        std::uint32_t &known = clusterOfVertex[vertex];
        if (known != kNone)
            return known;
        const glm::dvec3 place(mesh.positions[vertex]);
        known = cells.at(place);
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
            steps.next();
            clusterAt(point);
        }
    } else {
        for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
            steps.next();
            const std::array corners{clusterAt(3 * t), clusterAt(3 * t + 1), clusterAt(3 * t + 2)};
            const glm::dvec3 a(mesh.positions[mesh.vertexAt(3 * t)]);
            const glm::dvec3 b(mesh.positions[mesh.vertexAt(3 * t + 1)]);
            const glm::dvec3 c(mesh.positions[mesh.vertexAt(3 * t + 2)]);
            const glm::dvec3 normal = glm::cross(b - a, c - a);
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
    removeRepeated(triangles);
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
    Steps steps(progress, model.triangleCount() + model.pointCount());
    const double width = cellWidth(model, most);
    for (const Mesh &mesh : model.meshes) {
        Mesh next = clustered(mesh, width, steps);
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
