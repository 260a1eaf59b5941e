#include "core/mesh/closed_surface.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace unprojector::mesh {
namespace {

/// The connected pieces of the vertices.
class Pieces {
public:
    explicit Pieces(std::size_t vertexCount) : m_parents(vertexCount)
    {
        std::iota(m_parents.begin(), m_parents.end(), std::uint32_t{0});
    }
    std::uint32_t of(std::uint32_t vertex)
    {
        while (m_parents[vertex] != vertex)
            vertex = m_parents[vertex] = m_parents[m_parents[vertex]];
        return vertex;
    }
    void join(std::uint32_t a, std::uint32_t b) { m_parents[of(a)] = of(b); }

private:
    std::vector<std::uint32_t> m_parents;
};

/// A hash of an edge.
std::uint64_t mixed(std::uint32_t from, std::uint32_t to)
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
                sum += mixed(from, to);
            else
                sum -= mixed(to, from);
        }
    }
    return sum == 0;
}

} // namespace

bool isClosedOutwards(std::span<const std::array<std::uint32_t, 3>> triangles, const std::vector<glm::dvec3> &positions,
                      double leastVolume)
{
    if (triangles.empty() || !areEdgesPaired(triangles))
        return false;
    Pieces pieces(positions.size());
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

} // namespace unprojector::mesh
