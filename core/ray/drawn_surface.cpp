#include "core/ray/drawn_surface.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace unprojector::ray {
using namespace geometry;
using namespace mesh;
using namespace scene;
using namespace unproject;

DrawnSurface drawnSurface(const SceneObject &object, const WorldPoint &point)
{
    const glm::dmat4 placement = worldFromObject(object.transform);
    const std::vector<Mesh> &meshes = object.model->meshes;
    DrawnSurface surface{placement};
    double nearest = std::numeric_limits<double>::infinity();
    for (const Mesh &mesh : meshes) {
        const glm::dmat4 worldFromVertices = glm::translate(placement, mesh.origin);
        const double distance = glm::length(glm::dvec3(worldFromVertices[3]) - point.coordinates());
        if (distance < nearest) {
            nearest = distance;
            surface.worldFromVertices = worldFromVertices;
            surface.areVerticesRounded = !mesh.remainders.empty();
        }
    }
    surface.isPoint =
        std::all_of(meshes.begin(), meshes.end(), [](const Mesh &mesh) { return mesh.kind == Mesh::Kind::Points; });
    return surface;
}

DrawnSurface drawnSurface(const SceneObject &object, const SceneHit &hit)
{
    if (!hit.triangle) {
        DrawnSurface surface = drawnSurface(object, hit.world);
        surface.isPoint = true;
        return surface;
    }
    std::size_t number = hit.triangle->triangle;
    auto mesh = object.model->meshes.begin();
    for (; number >= mesh->triangleCount(); ++mesh)
        number -= mesh->triangleCount();
    DrawnSurface surface{glm::translate(worldFromObject(object.transform), mesh->origin)};
    surface.areVerticesRounded = !mesh->remainders.empty();
    std::array<glm::dvec3, 3> &corners = surface.triangle.emplace();
    for (std::size_t k = 0; k < 3; ++k)
        corners[k] = glm::dvec3(mesh->positions[mesh->vertexAt(3 * number + k)]);
    return surface;
}

} // namespace unprojector::ray
