#include "core/ray/closest_place.h"

#include "core/geometry/finite.h"
#include "core/ray/nearest_triangle.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace unprojector::ray {
using namespace geometry;
using namespace mesh;
using namespace landmarks;
namespace {

/// The parameter in [0, 1] of the point closest to the origin between a and b.
double closestShare(const glm::dvec3 &a, const glm::dvec3 &b)
{
    const glm::dvec3 along = b - a;
    const double squared = glm::dot(along, along);
    return squared > 0.0 ? std::clamp(-glm::dot(a, along) / squared, 0.0, 1.0) : 0.0;
}

glm::dvec3 combined(const std::array<glm::dvec3, 3> &corners, const glm::dvec3 &b)
{
    return b[0] * corners[0] + b[1] * corners[1] + b[2] * corners[2];
}

} // namespace

glm::dvec3 closestToOrigin(const std::array<glm::dvec3, 3> &corners)
{
    glm::dvec3 best(1.0, 0.0, 0.0);
    double least = std::numeric_limits<double>::infinity();
    const auto take = [&](const glm::dvec3 &barycentric) {
        const glm::dvec3 place = combined(corners, barycentric);
        if (const double squared = glm::dot(place, place); squared < least) {
            least = squared;
            best = barycentric;
        }
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        const double share = closestShare(corners[i], corners[next]);
        glm::dvec3 onEdge(0.0);
        onEdge[int(i)] = 1.0 - share;
        onEdge[int(next)] = share;
        take(onEdge);
    }
    // Inside, if the projection of the origin onto the plane lies on the same side of all edges.
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    glm::dvec3 inside;
    for (std::size_t i = 0; i < 3; ++i)
        inside[int(i)] = glm::dot(normal, glm::cross(corners[(i + 1) % 3], corners[(i + 2) % 3]));
    if (const double sum = inside.x + inside.y + inside.z;
        sum > 0.0 && inside.x >= 0.0 && inside.y >= 0.0 && inside.z >= 0.0)
        take(inside / sum);
    return best;
}

ClosestPlaces::ClosestPlaces(std::shared_ptr<const Model> model)
    : m_model(std::move(model)), m_triangles(m_model->meshes, &Mesh::triangleCount),
      m_points(m_model->meshes, &Mesh::pointCount), m_space(*m_model)
{
}

std::shared_ptr<const ClosestPlaces> ClosestPlaces::build(std::shared_ptr<const Model> model, const Progress &progress)
try {
    const std::shared_ptr<ClosestPlaces> places(new ClosestPlaces(std::move(model)));
    const std::uint32_t triangles = places->m_triangles.count(), count = triangles + places->m_points.count();
    std::vector<BoxTree::Box> boxes;
    boxes.reserve(count);
    for (std::uint32_t box = 0; box < count; ++box) {
        const ElementNumbers::Place place = places->elementOf(box);
        const Mesh &mesh = places->m_model->meshes[place.mesh];
        const std::size_t corners = box < triangles ? 3 : 1, first = corners * place.element;
        glm::vec3 lowest(std::numeric_limits<float>::infinity()), highest(-lowest);
        for (std::size_t i = first; i < first + corners; ++i) {
            const glm::vec3 corner = places->m_space.at(mesh.origin, mesh.positions[mesh.vertexAt(i)]);
            lowest = glm::min(lowest, corner);
            highest = glm::max(highest, corner);
        }
        boxes.push_back({lowest - UnitSpace::kMargin, highest + UnitSpace::kMargin});
    }
    constexpr std::size_t kMostInLeaf = 4;
    places->m_tree = BoxTree::build(boxes, kMostInLeaf, progress);
    return places;
} catch (const base::Stopped &) {
    return nullptr;
}

std::optional<ClosestPlace> ClosestPlaces::to(const ObjectPoint &point) const
{
    if (!isFinite(point))
        return std::nullopt;
    const glm::dvec3 unit = (point.coordinates() - m_space.center()) * m_space.scale();
    // The margin of the boxes exceeds the rounding nearby; far away, rounding is a share of the distance. Measures
    // count from a distance that all boxes exceed: seen from far away, they would be the same in single precision.
    constexpr double kRounding = 0x1p-48, kReach = 2.0; // kReach: more than the boxes', sqrt(3)
    const double before = std::max(glm::length(unit) - kReach, 0.0);
    const auto entry = [&](const glm::vec3 &lowest, const glm::vec3 &highest) {
        const glm::dvec3 off =
            glm::max(glm::max(glm::dvec3(lowest) - unit, unit - glm::dvec3(highest)), glm::dvec3(0.0));
        const double distance = glm::length(off) * (1.0 - kRounding) - before;
        // Beyond the largest double, all boxes are tested.
        return std::isfinite(distance) ? std::nextafter(static_cast<float>(distance), -1e38f) : 0.0f;
    };
    double least = std::numeric_limits<double>::infinity();
    std::uint32_t closest = std::numeric_limits<std::uint32_t>::max();
    glm::dvec3 barycentric(0.0);
    const auto limit = [&] {
        const double distance = least * m_space.scale() * (1.0 + kRounding) - before;
        return distance < double(std::numeric_limits<float>::max()) / 2
                   ? std::nextafter(static_cast<float>(distance), 1e38f)
                   : std::numeric_limits<float>::max();
    };
    m_tree.search(entry, limit, [&](std::uint32_t number) {
        const ElementNumbers::Place place = elementOf(number);
        const Mesh &mesh = m_model->meshes[place.mesh];
        // Relative to each mesh's own origin, so that vertices keep all digits.
        const glm::dvec3 from = point.coordinates() - mesh.origin;
        glm::dvec3 weights(0.0), off;
        if (number < m_triangles.count()) {
            std::array<glm::dvec3, 3> corners = cornersOf(mesh, place.element);
            for (glm::dvec3 &corner : corners)
                corner -= from;
            weights = closestToOrigin(corners);
            off = combined(corners, weights);
        } else {
            off = mesh.fromOrigin(mesh.vertexAt(place.element)) - from;
        }
        const double distance = glm::length(off);
        if (distance < least || (distance == least && number < closest)) {
            least = distance;
            closest = number;
            barycentric = weights;
        }
    });
    if (!std::isfinite(least))
        return std::nullopt;
    Anchor anchor = OnTriangle{closest, barycentric};
    if (closest >= m_triangles.count()) {
        const ElementNumbers::Place place = elementOf(closest);
        anchor = AtVertex{m_model->vertexNumber(place.mesh, m_model->meshes[place.mesh].vertexAt(place.element))};
    }
    const std::optional<ObjectPoint> place = placeOf(anchor, *m_model);
    return place ? std::optional(ClosestPlace{anchor, *place, least}) : std::nullopt;
}

std::optional<ObjectPoint> placeOf(const Anchor &anchor, const Model &model)
{
    const auto vertexAt = [&model](std::uint32_t number) -> std::optional<glm::dvec3> {
        const std::optional<Model::VertexPlace> place = model.vertexOf(number);
        return place ? std::optional(model.meshes[place->mesh].position(place->vertex)) : std::nullopt;
    };
    if (const auto *triangle = std::get_if<OnTriangle>(&anchor)) {
        const ElementNumbers triangles(model.meshes, &Mesh::triangleCount);
        if (triangle->triangle >= triangles.count())
            return std::nullopt;
        const ElementNumbers::Place place = triangles.place(triangle->triangle);
        const Mesh &mesh = model.meshes[place.mesh];
        return ObjectPoint(mesh.origin + combined(cornersOf(mesh, place.element), triangle->barycentric));
    }
    if (const auto *vertex = std::get_if<AtVertex>(&anchor)) {
        const std::optional<glm::dvec3> place = vertexAt(vertex->vertex);
        return place ? std::optional(ObjectPoint(*place)) : std::nullopt;
    }
    if (const auto *edge = std::get_if<OnEdge>(&anchor)) {
        const std::optional<glm::dvec3> from = vertexAt(edge->vertices[0]), to = vertexAt(edge->vertices[1]);
        if (!from || !to)
            return std::nullopt;
        return ObjectPoint(*from + edge->share * (*to - *from));
    }
    return std::nullopt;
}

} // namespace unprojector::ray
