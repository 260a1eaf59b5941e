#include "core/scene/measures.h"

#include "core/geometry/numbers.h"
#include "core/mesh/soup_numbers.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace unprojector::scene {
using namespace geometry;
using namespace mesh;

namespace {

/// The sum of the area vectors over the total area that rounding alone can leave.
constexpr double kMostOfAClosedOne = 1e-6;

/// A sum with compensation for rounding.
class Sum {
public:
    void add(double term)
    {
        m_lost += lostBySum(m_sum, term);
        m_sum += term;
    }
    double value() const { return m_sum + m_lost; }

private:
    double m_sum = 0.0, m_lost = 0.0;
};

/// The number of different positions, across meshes with a common origin: meshes of a model that was
/// split by material share positions.
std::size_t placesOf(const std::vector<Mesh> &meshes)
{
    std::size_t count = 0;
    std::vector<bool> isCounted(meshes.size());
    for (std::size_t first = 0; first < meshes.size(); ++first) {
        std::vector<std::array<double, 3>> places;
        for (std::size_t i = first; i < meshes.size(); ++i) {
            const Mesh &mesh = meshes[i];
            if (isCounted[i] || mesh.origin != meshes[first].origin)
                continue;
            isCounted[i] = true;
            for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
                const glm::dvec3 place = mesh.fromOrigin(vertex);
                places.push_back({place.x, place.y, place.z});
            }
        }
        std::sort(places.begin(), places.end());
        count += static_cast<std::size_t>(std::unique(places.begin(), places.end()) - places.begin());
    }
    return count;
}

/// Widens a box, and sets the half gaps of the ends that the point moves.
void widen(Measures &measures, const glm::dvec3 &lowest, const glm::dvec3 &lowestHalfGap, const glm::dvec3 &highest,
           const glm::dvec3 &highestHalfGap)
{
    const bool isFirst = measures.box.isEmpty();
    for (int axis = 0; axis < 3; ++axis) {
        if (isFirst || lowest[axis] < measures.box.lowest[axis]) {
            measures.box.lowest[axis] = lowest[axis];
            measures.lowestHalfGap[axis] = lowestHalfGap[axis];
        }
        if (isFirst || highest[axis] > measures.box.highest[axis]) {
            measures.box.highest[axis] = highest[axis];
            measures.highestHalfGap[axis] = highestHalfGap[axis];
        }
    }
}

} // namespace

glm::dvec3 halfGapAt(const Mesh &mesh, std::size_t vertex, const glm::dmat3 &worldFromSource)
{
    glm::dvec3 world(0.0);
    if (!mesh.remainders.empty())
        return world;
    for (int axis = 0; axis < 3; ++axis) {
        const float size = std::abs(mesh.positions[vertex][axis]);
        // Below a power of two the gap is half as large as above it.
        const float other = size > 0.0f ? std::nextafter(size, 0.0f) : std::nextafter(0.0f, 1.0f);
        world += glm::abs(worldFromSource[axis]) * (std::abs(double{size} - double{other}) / 2.0);
    }
    return world;
}

void Measures::add(const Measures &other)
{
    vertices += other.vertices;
    triangles += other.triangles;
    area += other.area;
    volume += other.volume;
    isOpen = isOpen || other.isOpen;
    if (!other.box.isEmpty())
        widen(*this, other.box.lowest, other.lowestHalfGap, other.box.highest, other.highestHalfGap);
}

Measures measuresOf(const SceneObject &object)
{
    const glm::dmat4 worldFromSource = worldFromObject(object.transform);
    const glm::dmat3 linear(worldFromSource);
    const glm::dvec3 center = object.model->bounds.isEmpty() ? glm::dvec3(0.0) : object.model->bounds.center();
    Measures measures;
    const Model &model = *object.model;
    measures.vertices = model.fileVertices > 0 ? model.fileVertices
                        : model.soupNumbers    ? model.soupNumbers->placeCount(model.meshes.front())
                                               : placesOf(model.meshes);
    Sum area, volume;
    glm::dvec3 areaVector(0.0);
    for (const Mesh &mesh : object.model->meshes) {
        measures.triangles += mesh.triangleCount();
        // Relative to the object's center, so that no large numbers cancel.
        const glm::dvec3 origin = mesh.origin - center, worldOrigin(worldFromSource * glm::dvec4(mesh.origin, 1.0));
        const auto position = [&mesh](std::size_t element) { return mesh.fromOrigin(mesh.vertexAt(element)); };
        for (std::size_t element = 0; element < mesh.elementCount(); ++element) {
            const glm::dvec3 world = worldOrigin + linear * position(element);
            if (measures.box.isEmpty() || glm::any(glm::lessThan(world, measures.box.lowest))
                || glm::any(glm::greaterThan(world, measures.box.highest))) {
                const glm::dvec3 halfGap = halfGapAt(mesh, mesh.vertexAt(element), linear);
                widen(measures, world, halfGap, world, halfGap);
            }
        }
        for (std::size_t triangle = 0; triangle < mesh.triangleCount(); ++triangle) {
            const glm::dvec3 a = position(3 * triangle), b = position(3 * triangle + 1), c = position(3 * triangle + 2);
            const glm::dvec3 twice = glm::cross(linear * (b - a), linear * (c - a));
            areaVector += twice / 2.0;
            area.add(glm::length(twice) / 2.0);
            volume.add(glm::dot(origin + a, glm::cross(origin + b, origin + c)) / 6.0);
        }
    }
    measures.area = area.value();
    measures.isOpen = glm::length(areaVector) > kMostOfAClosedOne * measures.area;
    measures.volume = volume.value() * std::abs(glm::determinant(linear));
    return measures;
}

} // namespace unprojector::scene
