#include "core/mesh/stand_in.h"

#include "core/mesh/closed_surface.h"

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

/// Forwards the share done from time to time.
class Reporter {
public:
    Reporter(const StandInProgress &progress, std::size_t total) : m_progress(progress), m_total(total) {}
    /// @return whether to continue
    bool step()
    {
        if (++m_done % kElementsBetweenReports == 0 && m_progress && !m_isEnded)
            m_isEnded = !m_progress(std::min(1.0, static_cast<double>(m_done) / static_cast<double>(m_total)));
        return !m_isEnded;
    }
    bool isEnded() const { return m_isEnded; }

private:
    const StandInProgress &m_progress;
    std::size_t m_total;
    std::size_t m_done = 0;
    bool m_isEnded = false;
};

/// Numbers the cells of a grid in the order of first use.
class Cells {
public:
    explicit Cells(double width) : m_perUnit(1.0 / width), m_slots(std::size_t{1} << 16, kNone) {}

    std::uint32_t at(const glm::dvec3 &place)
    {
        const std::uint64_t key = keyOf(place);
        std::size_t slot = slotOf(key);
        while (m_slots[slot] != kNone) {
            if (m_keys[m_slots[slot]] == key)
                return m_slots[slot];
            slot = (slot + 1) & (m_slots.size() - 1);
        }
        m_slots[slot] = static_cast<std::uint32_t>(m_keys.size());
        m_keys.push_back(key);
        if (2 * m_keys.size() > m_slots.size())
            grow();
        return static_cast<std::uint32_t>(m_keys.size() - 1);
    }

private:
    /// A key of 21 bits an axis: fine enough for a few hundred thousand cells of a surface.
    std::uint64_t keyOf(const glm::dvec3 &place) const
    {
        std::uint64_t key = 0;
        for (int axis = 0; axis < 3; ++axis) {
            constexpr double kHalf = 1 << 20;
            const double cell = std::clamp(std::floor(place[axis] * m_perUnit), -kHalf, kHalf - 1.0);
            key = key << 21 | static_cast<std::uint64_t>(cell + kHalf);
        }
        return key;
    }
    std::size_t slotOf(std::uint64_t key) const
    {
        key = (key ^ (key >> 31)) * 0x9e3779b97f4a7c15ull;
        return (key ^ (key >> 29)) & (m_slots.size() - 1);
    }
    void grow()
    {
        m_slots.assign(2 * m_slots.size(), kNone);
        for (std::size_t i = 0; i < m_keys.size(); ++i) {
            std::size_t slot = slotOf(m_keys[i]);
            while (m_slots[slot] != kNone)
                slot = (slot + 1) & (m_slots.size() - 1);
            m_slots[slot] = static_cast<std::uint32_t>(i);
        }
    }

    double m_perUnit;
    std::vector<std::uint64_t> m_keys;
    std::vector<std::uint32_t> m_slots;
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

Mesh clustered(const Mesh &mesh, double width, Reporter &reporter)
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
        for (std::size_t point = 0; point < mesh.pointCount() && reporter.step(); ++point)
            clusterAt(point);
    } else {
        for (std::size_t t = 0; t < mesh.triangleCount() && reporter.step(); ++t) {
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

Model standInFor(const Model &model, std::size_t most, const StandInProgress &progress)
{
    Model coarse;
    coarse.name = model.name;
    Reporter reporter(progress, model.triangleCount() + model.pointCount());
    const double width = cellWidth(model, most);
    for (const Mesh &mesh : model.meshes) {
        Mesh next = clustered(mesh, width, reporter);
        if (reporter.isEnded())
            return {};
        // Drops meshes smaller than a cell: triangles without indices would be drawn in vertex
        // order.
        if (mesh.kind == Mesh::Kind::Points || !next.indices.empty())
            coarse.meshes.push_back(std::move(next));
    }
    coarse.textures = model.textures;
    coarse.bounds = model.bounds;
    return coarse;
}

} // namespace unprojector::mesh
