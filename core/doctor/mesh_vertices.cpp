#include "core/doctor/mesh_vertices.h"

#include <glm/common.hpp>

#include <algorithm>

namespace unprojector::doctor {
using namespace geometry;

std::vector<KnownPoint> verticesIn(std::span<const scene::SceneObject> objects, const Box &world)
{
    constexpr std::size_t kMost = 1000;
    std::vector<KnownPoint> found;
    for (const scene::SceneObject &object : objects) {
        if (object.isHidden || !object.model)
            continue;
        const glm::dmat4 worldFromModel = worldFromObject(object.transform);
        for (std::size_t mesh = 0; mesh < object.model->meshes.size(); ++mesh) {
            const mesh::Mesh &own = object.model->meshes[mesh];
            for (std::size_t vertex = 0; vertex < own.positions.size(); ++vertex) {
                const glm::dvec3 at(worldFromModel * glm::dvec4(own.position(vertex), 1.0));
                if (glm::clamp(at, world.lowest, world.highest) != at)
                    continue;
                // Many vertices coincide in a triangle soup.
                if (std::any_of(found.begin(), found.end(), [&at](const KnownPoint &one) { return one.point == at; }))
                    continue;
                if (found.size() == kMost)
                    return found;
                found.push_back({KnownPoint::Kind::Vertex, at, object.name, object.model->vertexNumber(mesh, vertex)});
            }
        }
    }
    return found;
}

} // namespace unprojector::doctor
