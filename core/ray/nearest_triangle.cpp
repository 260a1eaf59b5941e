#include "core/ray/nearest_triangle.h"

namespace unprojector::ray {
using namespace geometry;
using namespace mesh;

namespace {

/// The line relative to the mesh's own origin. Differences of nearby doubles are exact, so the
/// digits of mesh and ray are kept.
LineCrossing lineAbout(const glm::dvec3 &origin, const Ray<ObjectSpace> &ray)
{
    return {ray.from.coordinates() - origin, ray.along.coordinates()};
}

} // namespace

std::array<glm::dvec3, 3> cornersOf(const Mesh &mesh, std::uint32_t triangle)
{
    const std::size_t first = std::size_t{3} * triangle;
    return {mesh.fromOrigin(mesh.vertexAt(first)), mesh.fromOrigin(mesh.vertexAt(first + 1)),
            mesh.fromOrigin(mesh.vertexAt(first + 2))};
}

glm::dvec3 preciseBarycentric(const Mesh &mesh, std::uint32_t triangle, const Ray<ObjectSpace> &ray)
{
    const std::array<glm::dvec3, 3> corners = cornersOf(mesh, triangle);
    return lineAbout(mesh.origin, ray).preciseBarycentric(corners[0], corners[1], corners[2]);
}

NearestTriangle::NearestTriangle(const Model &model, const Ray<ObjectSpace> &ray)
    : m_model(model), m_ray(ray),
      m_line(lineAbout(model.meshes.empty() ? glm::dvec3(0.0) : model.meshes.front().origin, ray))
{
}

bool NearestTriangle::test(std::uint32_t mesh, std::uint32_t triangle, const std::array<glm::dvec3, 3> &corners)
{
    if (mesh != m_mesh) {
        m_line = lineAbout(m_model.meshes[mesh].origin, m_ray);
        m_mesh = mesh;
    }
    const std::optional<Crossing> crossing = m_line.with(corners[0], corners[1], corners[2]);
    if (!crossing || !(crossing->t >= m_ray.low && crossing->t <= high()))
        return false;
    if (m_hit && crossing->t == m_hit->t && triangle >= m_hit->triangle)
        return false;
    m_hit = TriangleHit{triangle, crossing->t, crossing->barycentric};
    return true;
}

} // namespace unprojector::ray
