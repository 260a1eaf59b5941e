#include "core/ray/ray_caster.h"

#include <utility>

namespace unprojector::ray {

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
    if (caster->m_numbers.count() == 0)
        return caster;
    bool isCancelled = false;
    if (tree == Tree::Fastest)
        caster->m_triangles = embreeTriangleTree(caster->m_packets, progress, isCancelled);
    if (!caster->m_triangles && !isCancelled)
        caster->m_triangles = plainTriangleTree(caster->m_packets, progress);
    return caster->m_triangles ? caster : nullptr;
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
