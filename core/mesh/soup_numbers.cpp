#include "core/mesh/soup_numbers.h"

#include "core/base/parallel.h"
#include "core/mesh/mesh.h"
#include "core/mesh/numbering.h"

#include <algorithm>

namespace unprojector::mesh {

std::uint64_t placeHash(const Mesh &mesh, std::size_t vertex)
{
    std::uint64_t hash = hashOf(mesh.positions[vertex]);
    for (int axis = 0; axis < 3 && !mesh.remainders.empty(); ++axis)
        hash = mixed(hash, static_cast<std::uint32_t>(mesh.remainders[vertex][axis]));
    return hash;
}

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
        const std::size_t verticesAtPlace = mesh.indices.empty() ? 6 : 1; // in most meshes
        FirstEqual first(vertices / verticesAtPlace / tasks);
        const auto hashAt = [&mesh](std::uint32_t vertex) { return placeHash(mesh, vertex); };
        const auto areEqual = [&mesh](std::uint32_t a, std::uint32_t b) {
            return mesh.fromOrigin(a) == mesh.fromOrigin(b);
        };
        for (std::uint32_t vertex = 0; vertex < vertices; ++vertex) {
            if ((hashAt(vertex) >> 40) % tasks == task)
                numbers[vertex] = first.of(vertex, hashAt, areEqual);
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
