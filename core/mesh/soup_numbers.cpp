#include "core/mesh/soup_numbers.h"

#include "core/base/parallel.h"
#include "core/mesh/mesh.h"
#include "core/mesh/numbering.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace unprojector::mesh {
namespace {

constexpr std::uint32_t kEmpty = 0xffffffffu;

std::uint64_t hashAt(const Mesh &mesh, std::size_t vertex)
{
    std::uint64_t hash = hashOf(mesh.positions[vertex]);
    for (int axis = 0; axis < 3 && !mesh.remainders.empty(); ++axis)
        hash = mixed(hash, static_cast<std::uint32_t>(mesh.remainders[vertex][axis]));
    return hash;
}

/// Finds the first vertex at a position, among those queried so far.
class FirstVertices {
public:
    FirstVertices(const Mesh &mesh, std::size_t expectedCount)
        : m_mesh(mesh), m_slots(std::bit_ceil(std::max<std::size_t>(16, expectedCount + expectedCount / 2)), kEmpty)
    {
    }

    std::uint32_t at(std::uint32_t vertex, std::uint64_t hash)
    {
        if (m_count + m_count / 4 >= m_slots.size())
            grow();
        std::uint32_t &slot = slotOf(vertex, hash);
        if (slot == kEmpty) {
            slot = vertex;
            ++m_count;
        }
        return slot;
    }

private:
    std::uint32_t &slotOf(std::uint32_t vertex, std::uint64_t hash)
    {
        const std::size_t mask = m_slots.size() - 1;
        std::size_t slot = hash & mask;
        while (m_slots[slot] != kEmpty && m_mesh.fromOrigin(m_slots[slot]) != m_mesh.fromOrigin(vertex))
            slot = (slot + 1) & mask;
        return m_slots[slot];
    }

    void grow()
    {
        const std::vector<std::uint32_t> before =
            std::exchange(m_slots, std::vector<std::uint32_t>(m_slots.size() * 2, kEmpty));
        for (const std::uint32_t vertex : before) {
            if (vertex != kEmpty)
                slotOf(vertex, hashAt(m_mesh, vertex)) = vertex;
        }
    }

    const Mesh &m_mesh;
    std::vector<std::uint32_t> m_slots;
    std::size_t m_count = 0;
};

} // namespace

std::size_t numberPlaces(const Mesh &mesh, std::vector<std::uint32_t> &numbers)
{
    const std::size_t vertices = mesh.positions.size();
    constexpr std::size_t kMostTasks = 16, kFewVertices = std::size_t{1} << 16;
    const std::size_t cores = base::coreCount();
    const std::size_t tasks = vertices < kFewVertices ? 1 : std::min(cores, kMostTasks);
    numbers.resize(vertices);
    // Each task scans all vertices in order and takes the ones with its own hashes, so equal ones
    // belong to one task.
    base::inParallel(tasks, {}, [&](std::size_t task) {
        constexpr std::size_t kVerticesAtPlace = 6; // in most meshes
        FirstVertices first(mesh, vertices / kVerticesAtPlace / tasks);
        for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
            const std::uint64_t hash = hashAt(mesh, vertex);
            if ((hash >> 40) % tasks == task)
                numbers[vertex] = first.at(static_cast<std::uint32_t>(vertex), hash);
        }
    });
    std::uint32_t count = 0;
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
        const std::uint32_t firstVertex = numbers[vertex];
        numbers[vertex] = firstVertex == vertex ? count++ : numbers[firstVertex]; // which has a lower index
    }
    return count;
}

} // namespace unprojector::mesh
