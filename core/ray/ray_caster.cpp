#include "core/ray/ray_caster.h"

#include <algorithm>
#include <utility>

namespace unprojector::ray {
using namespace geometry;
using namespace mesh;

RayCaster::RayCaster(std::shared_ptr<const Model> model)
    : m_model(std::move(model)), m_numbers(m_model->meshes, &Mesh::triangleCount), m_space(*m_model),
      m_packets(*m_model, m_numbers, m_space)
{
}

std::shared_ptr<const RayCaster> RayCaster::build(std::shared_ptr<const Model> model, const Progress &progress,
                                                  [[maybe_unused]] Tree tree)
try {
    const std::shared_ptr<RayCaster> caster(new RayCaster(std::move(model)));
    const std::size_t triangles = caster->m_numbers.count(), points = caster->m_model->pointCount();
    const double shareOfPoints =
        static_cast<double>(points) / static_cast<double>(std::max<std::size_t>(triangles + points, 1));
    const Progress first = [&](double share) { return !progress || progress(shareOfPoints * share); };
    if (points > 0)
        caster->m_points.emplace(*caster->m_model, caster->m_space, first);
    if (triangles == 0)
        return caster;
    // Computed now, so that no click waits for the vertex numbers.
    if (caster->m_model->soupNumbers)
        caster->m_model->vertexNumber(0, 0);
    const Progress rest = [&](double share) {
        return !progress || progress(shareOfPoints + (1.0 - shareOfPoints) * share);
    };
#ifdef UNPROJECTOR_EMBREE
    if (tree == Tree::Fastest)
        caster->m_triangles = embreeTriangleTree(caster->m_packets, rest);
#endif
    if (!caster->m_triangles)
        caster->m_triangles = plainTriangleTree(caster->m_packets, rest);
    return caster;
} catch (const base::Stopped &) {
    return nullptr;
}

std::vector<std::uint32_t> RayCaster::trianglesAbout(const RayBundle &bundle) const
{
    std::vector<std::uint32_t> triangles;
    if (!m_triangles)
        return triangles;
    for (const Ball &ball : ballsAlong(bundle, m_space)) {
        m_triangles->within(ball, [&](std::uint32_t packet) {
            const auto &own = m_packets.trianglesOf(packet);
            triangles.insert(triangles.end(), own.begin(), own.end());
        });
    }
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    return triangles;
}

std::optional<PointHit> RayCaster::nearestPoint(const PointAim &aim) const
{
    return m_points ? m_points->nearest(aim) : std::nullopt;
}

std::optional<TriangleHit> RayCaster::nearestTriangle(const Ray<ObjectSpace> &ray) const
{
    if (!m_triangles)
        return std::nullopt;
    const std::optional<UnitRay> inside = m_space.inside(ray);
    if (!inside)
        return std::nullopt;
    NearestTriangle nearest(*m_model, ray);
    PacketSearch search(*m_model, m_space, *inside, nearest);
    m_triangles->search(*inside, search);
    return nearest.hit();
}

} // namespace unprojector::ray
