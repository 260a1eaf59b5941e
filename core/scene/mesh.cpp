#include "core/scene/mesh.h"

#include <glm/common.hpp>

namespace unprojector::scene {

std::size_t Model::triangleCount() const
{
    std::size_t count = 0;
    for (const Mesh &mesh : meshes)
        count += mesh.triangleCount();
    return count;
}

Box boundsOf(const std::vector<Mesh> &meshes)
{
    Box box;
    for (const Mesh &mesh : meshes) {
        if (mesh.indices.empty())
            continue;
        glm::vec3 lowest = mesh.positions[mesh.indices.front()];
        glm::vec3 highest = lowest;
        for (const std::uint32_t index : mesh.indices) {
            lowest = glm::min(lowest, mesh.positions[index]);
            highest = glm::max(highest, mesh.positions[index]);
        }
        box.add(glm::dvec3(lowest));
        box.add(glm::dvec3(highest));
    }
    return box;
}

} // namespace unprojector::scene
