#include "core/ray/scene_hit.h"

#include "core/geometry/numbers.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace unprojector::ray {
using namespace geometry;
using namespace mesh;
using namespace unproject;

namespace {

/// A mesh's vertices in the world. The mesh's origin and the object's position are summed first,
/// since they may cancel.
class PlacedMesh {
public:
    PlacedMesh(const Mesh &mesh, const glm::dmat4 &worldFromObject)
        : m_origin(mesh.origin), m_linear(worldFromObject),
          m_worldOrigin(glm::dvec3(worldFromObject * glm::dvec4(mesh.origin, 1.0)))
    {
        const auto sizes = [](const glm::dvec3 &v) { return glm::abs(v); };
        for (int column = 0; column < 3; ++column)
            m_absolute[column] = sizes(m_linear[column]);
        m_size = m_absolute * sizes(mesh.origin) + sizes(glm::dvec3(worldFromObject[3]));
    }

    /// @param place  relative to the mesh's origin
    WorldPoint world(const glm::dvec3 &place) const { return WorldPoint(m_worldOrigin + m_linear * place); }
    ObjectPoint object(const glm::dvec3 &place) const { return ObjectPoint(m_origin + place); }
    const glm::dmat3 &linear() const { return m_linear; }

    /// A normal of a triangle in the world, of any length, accurate to the last digit also where the
    /// triangle is seen edge on.
    glm::dvec3 preciseNormal(const std::array<glm::dvec3, 3> &corners, double size) const
    {
        const auto side = [&](const glm::dvec3 &corner) {
            DoubleDouble3 object, world;
            for (int k = 0; k < 3; ++k)
                object[static_cast<std::size_t>(k)] = (DoubleDouble(corner[k]) - corners[0][k]) / size;
            for (int k = 0; k < 3; ++k)
                world[static_cast<std::size_t>(k)] =
                    m_linear[0][k] * object[0] + m_linear[1][k] * object[1] + m_linear[2][k] * object[2];
            return world;
        };
        const DoubleDouble3 normal = cross(side(corners[1]), side(corners[2]));
        return {normal[0].value, normal[1].value, normal[2].value};
    }

    /// The rounding error in double of a position of the mesh in the world, and of differences
    /// between positions that are no larger.
    WorldVector rounding(const glm::dvec3 &place) const
    {
        return WorldVector(kRoundings * (m_size + m_absolute * glm::abs(place)));
    }
    /// The same, plus the rounding error of a ray through it at t.
    WorldVector rounding(const glm::dvec3 &place, const Ray<WorldSpace> &ray, double t) const
    {
        // A point at t has (1 - t) times the error of one end and t times that of the other.
        const double ends = std::max(1.0, std::abs(2.0 * t - 1.0));
        const glm::dvec3 along =
            ends * glm::abs(ray.from.coordinates()) + 2.0 * std::abs(t) * glm::abs(ray.along.coordinates());
        return rounding(place) + WorldVector(kRoundings * along) + ray.error * ends;
    }

private:
    static constexpr double kRoundings = 8.0 * 0x1p-53;

    glm::dvec3 m_origin;
    glm::dmat3 m_linear;
    glm::dvec3 m_worldOrigin;
    glm::dmat3 m_absolute{0.0};
    glm::dvec3 m_size;
};

/// @param place  relative to the mesh's origin
SceneHit hitAt(const Target &target, const PlacedMesh &placed, const glm::dvec3 &place, const Ray<WorldSpace> &ray,
               const std::optional<WorldPoint> &eye)
{
    SceneHit hit;
    hit.object = target.object;
    hit.objectPoint = placed.object(place);
    hit.world = placed.world(place);
    hit.t = dot(hit.world - ray.from, ray.along) / dot(ray.along, ray.along);
    hit.distance = eye ? distance(hit.world, *eye) : hit.t * length(ray.along);
    return hit;
}

/// The parameter in [0, 1] between two points that is nearest to a third.
double nearestShare(const WorldPoint &from, const WorldPoint &to, const WorldPoint &point)
{
    const WorldVector way = to - from;
    const double square = dot(way, way);
    return square > 0.0 ? std::clamp(dot(point - from, way) / square, 0.0, 1.0) : 0.0;
}

} // namespace

Placement::Placement(const glm::dmat4 &worldFromObject, const ObjectFromWorld &objectFromWorld)
    : m_worldFromObject(worldFromObject), m_objectFromWorld(objectFromWorld),
      m_plainInverse(glm::inverse(glm::dmat3(worldFromObject)))
{
}

Result<Placement> Placement::of(const glm::dmat4 &worldFromObject)
{
    const Result<ObjectFromWorld> inverse = ObjectFromWorld::of(worldFromObject);
    if (!inverse)
        return inverse.error();
    return Placement(worldFromObject, *inverse);
}

Result<Ray<ObjectSpace>> Placement::objectRay(const Ray<WorldSpace> &ray) const
{
    const Result<ObjectPoint> from = m_objectFromWorld.at(ray.from);
    if (!from)
        return from.error();
    const Result<Vector<ObjectSpace>> along = m_objectFromWorld.at(ray.along);
    if (!along)
        return along.error();
    return Ray<ObjectSpace>{*from, *along, ray.low, ray.high};
}

Ray<ObjectSpace> Placement::plainObjectRay(const Ray<WorldSpace> &ray) const
{
    const glm::dvec3 from = ray.from.coordinates() - glm::dvec3(m_worldFromObject[3]);
    return {ObjectPoint(m_plainInverse * from), Vector<ObjectSpace>(m_plainInverse * ray.along.coordinates()), ray.low,
            ray.high};
}

std::array<WorldPoint, 3> worldCorners(const Target &target, std::uint32_t triangle)
{
    const ElementNumbers::Place place = target.caster->triangleNumbers().place(triangle);
    const Mesh &mesh = target.caster->model().meshes[place.mesh];
    const auto corners = cornersOf(mesh, place.element);
    const glm::dmat4 &m = target.placement.worldFromObject();
    const glm::dvec3 origin(m * glm::dvec4(mesh.origin, 1.0));
    std::array<WorldPoint, 3> world;
    for (std::size_t k = 0; k < 3; ++k)
        world[k] = WorldPoint(origin + glm::dmat3(m) * corners[k]);
    return world;
}

SceneHit hitOnTriangle(const Target &target, std::uint32_t triangle, const glm::dvec3 &barycentric,
                       const Ray<WorldSpace> &ray, const std::optional<WorldPoint> &eye)
{
    const Model &model = target.caster->model();
    const ElementNumbers::Place place = target.caster->triangleNumbers().place(triangle);
    const Mesh &mesh = model.meshes[place.mesh];
    const PlacedMesh placed(mesh, target.placement.worldFromObject());
    const std::array<glm::dvec3, 3> corners = cornersOf(mesh, place.element);
    SceneHit hit = hitAt(
        target, placed, barycentric.x * corners[0] + barycentric.y * corners[1] + barycentric.z * corners[2], ray, eye);
    TriangleDetail detail;
    detail.triangle = triangle;
    detail.barycentric = barycentric;
    std::array<WorldPoint, 3> world;
    for (std::size_t k = 0; k < 3; ++k) {
        detail.ids[k] = model.vertexNumber(place.mesh, mesh.vertexAt(std::size_t{3} * place.element + k));
        world[k] = placed.world(corners[k]);
    }
    // Scaled to about 1, since the square of a length can leave the range of doubles.
    const glm::dvec3 side = corners[1] - corners[0], other = corners[2] - corners[0];
    const double size = std::max(glm::length(side), glm::length(other));
    const glm::dvec3 normal = glm::inverse(glm::transpose(placed.linear())) * glm::cross(side / size, other / size);
    detail.normal =
        WorldVector(glm::normalize(normal / std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)})));

    detail.edge.distance = hit.vertex.distance = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if (const double d = distance(world[k], hit.world); d < hit.vertex.distance)
            hit.vertex = {detail.ids[k], world[k], d, placed.rounding(corners[k])};
        const double share = nearestShare(world[k], world[next], hit.world);
        const WorldPoint nearest = world[k] + share * (world[next] - world[k]);
        if (const double d = distance(nearest, hit.world); d < detail.edge.distance)
            detail.edge = {{detail.ids[k], detail.ids[next]},
                           nearest,
                           d,
                           placed.rounding(glm::max(glm::abs(corners[k]), glm::abs(corners[next])))};
    }

    // An error of the plane along its normal moves the hit along the ray.
    const glm::dvec3 n = placed.preciseNormal(corners, size), along = ray.along.coordinates();
    const glm::dvec3 largest = glm::max(glm::max(glm::abs(corners[0]), glm::abs(corners[1])), glm::abs(corners[2]));
    const WorldVector rounding = placed.rounding(largest, ray, hit.t);
    const double shift = glm::dot(glm::abs(n), rounding.coordinates()) / std::abs(glm::dot(n, along));
    hit.uncertainty = rounding + WorldVector(glm::abs(along) * shift);
    hit.triangle = detail;
    return hit;
}

SceneHit hitOnPoint(const Target &target, std::uint32_t vertex, const Ray<WorldSpace> &ray,
                    const std::optional<WorldPoint> &eye)
{
    const Model &model = target.caster->model();
    std::uint32_t mesh = 0, inMesh = vertex;
    while (inMesh >= model.meshes[mesh].positions.size())
        inMesh -= static_cast<std::uint32_t>(model.meshes[mesh++].positions.size());
    const PlacedMesh placed(model.meshes[mesh], target.placement.worldFromObject());
    const glm::dvec3 point = model.meshes[mesh].fromOrigin(inMesh);
    SceneHit hit = hitAt(target, placed, point, ray, eye);
    hit.uncertainty = placed.rounding(point);
    hit.vertex = {model.vertexNumber(mesh, inMesh), hit.world, 0.0, hit.uncertainty};
    return hit;
}

} // namespace unprojector::ray
