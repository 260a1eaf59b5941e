#include "core/ray/ray_caster.h"

#include <algorithm>
#include <utility>

namespace unprojector::ray {
using namespace geometry;
using namespace mesh;

RayCaster::RayCaster(std::shared_ptr<const Model> model, const Box &bounds)
    : m_model(std::move(model)), m_numbers(m_model->meshes, [](const Mesh &mesh) { return mesh.triangleCount(); }),
      m_space(bounds), m_packets(*m_model, m_numbers, m_space)
{
}

std::shared_ptr<const RayCaster> RayCaster::build(std::shared_ptr<const Model> model, const Progress &progress,
                                                  Tree tree)
{
    const Box bounds = model->bounds.isEmpty() ? boundsOf(model->meshes) : model->bounds;
    const std::shared_ptr<RayCaster> caster(new RayCaster(std::move(model), bounds));
    const std::size_t triangles = caster->m_numbers.count(), points = caster->m_model->pointCount();
    const double all = static_cast<double>(std::max<std::size_t>(triangles + points, 1));
    // The steps run in sequence, each with its share of the progress.
    const auto partOf = [&progress](double from, double size) -> Progress {
        if (!progress)
            return {};
        return [&progress, from, size](double share) { return progress(from + size * share); };
    };
    const double shareOfPoints = static_cast<double>(points) / all;
    if (points > 0) {
        caster->m_points = PointCloud::build(*caster->m_model, caster->m_space, partOf(0.0, shareOfPoints));
        if (!caster->m_points)
            return nullptr;
    }
    if (triangles == 0)
        return caster;
    // Computed now, so that no click waits for the vertex numbers.
    if (caster->m_model->soupNumbers)
        caster->m_model->vertexNumber(0, 0);
    const Progress rest = partOf(shareOfPoints, 1.0 - shareOfPoints);
    bool isCancelled = false;
    if (tree == Tree::Fastest)
        caster->m_triangles = embreeTriangleTree(caster->m_packets, rest, isCancelled);
    if (!caster->m_triangles && !isCancelled)
        caster->m_triangles = plainTriangleTree(caster->m_packets, rest);
    return caster->m_triangles ? caster : nullptr;
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
