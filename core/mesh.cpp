#include "core/mesh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace unprojector {

void Box::add(const glm::dvec3 &point)
{
    if (isEmpty()) {
        lowest = point;
        highest = point;
        return;
    }
    lowest = glm::min(lowest, point);
    highest = glm::max(highest, point);
}

void Box::add(const Box &other)
{
    if (other.isEmpty())
        return;
    add(other.lowest);
    add(other.highest);
}

double Box::diagonal() const
{
    return isEmpty() ? 0.0 : glm::length(highest - lowest);
}

Box Box::transformed(const glm::dmat4 &targetFromSource) const
{
    Box box;
    if (isEmpty())
        return box;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 point(corner & 1 ? highest.x : lowest.x, corner & 2 ? highest.y : lowest.y,
                               corner & 4 ? highest.z : lowest.z, 1.0);
        const glm::dvec4 target = targetFromSource * point;
        box.add(glm::dvec3(target) / target.w);
    }
    return box;
}

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

} // namespace unprojector
