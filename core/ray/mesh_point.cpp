#include "core/ray/mesh_point.h"

namespace unprojector::ray {
using namespace geometry;

std::optional<WorldPoint> MeshPoint::operator()(const DevicePoint &position) const
{
    const auto hit = m_rays->at(position);
    if (!hit || !*hit)
        return std::nullopt;
    if ((*hit)->triangle)
        return (*hit)->world;
    const Setup &setup = m_rays->rays().setup();
    const Result<WindowPoint> window = windowFromWorld(setup, (*hit)->world);
    const auto unprojector = unproject::Unprojector::of(setup);
    if (!window || !unprojector)
        return std::nullopt;
    const Result<WorldPoint> onRay =
        unprojector->worldAt(m_rays->rays().method(), windowFromDevice(setup.surface, position, window->z));
    return onRay ? std::optional(*onRay) : std::nullopt;
}

} // namespace unprojector::ray
