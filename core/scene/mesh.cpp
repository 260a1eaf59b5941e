#include "core/scene/mesh.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::scene {

std::size_t Model::triangleCount() const
{
    std::size_t count = 0;
    for (const Mesh &mesh : meshes)
        count += mesh.triangleCount();
    return count;
}

std::size_t Model::pointCount() const
{
    std::size_t count = 0;
    for (const Mesh &mesh : meshes)
        count += mesh.pointCount();
    return count;
}

glm::dvec3 originFor(const Box &box)
{
    glm::dvec3 origin(0.0);
    if (box.isEmpty())
        return origin;
    const glm::dvec3 size = box.highest - box.lowest;
    const double width = std::max({size.x, size.y, size.z});
    // A little more than the width: then every float of the box is between half the origin and twice it, where the
    // difference of two floats is one as well.
    constexpr double kFar = 1.01;
    for (int axis = 0; axis < 3; ++axis) {
        const double middle = box.center()[axis];
        if (std::isfinite(middle) && std::abs(middle) > kFar * width)
            origin[axis] = static_cast<double>(static_cast<float>(middle));
    }
    return origin;
}

void setPositions(Mesh &mesh, const glm::dvec3 &origin, std::span<const glm::dvec3> positions)
{
    mesh.origin = origin;
    mesh.positions.clear();
    mesh.positions.reserve(positions.size());
    for (const glm::dvec3 &position : positions)
        mesh.positions.emplace_back(position - mesh.origin);
}

Box boundsOf(const std::vector<Mesh> &meshes)
{
    Box box;
    for (const Mesh &mesh : meshes) {
        if (mesh.elementCount() == 0)
            continue;
        glm::vec3 lowest = mesh.positions[mesh.vertexAt(0)];
        glm::vec3 highest = lowest;
        for (std::size_t element = 1; element < mesh.elementCount(); ++element) {
            const glm::vec3 &position = mesh.positions[mesh.vertexAt(element)];
            lowest = glm::min(lowest, position);
            highest = glm::max(highest, position);
        }
        box.add(mesh.origin + glm::dvec3(lowest));
        box.add(mesh.origin + glm::dvec3(highest));
    }
    return box;
}

} // namespace unprojector::scene
