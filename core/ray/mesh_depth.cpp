#include "core/ray/mesh_depth.h"

namespace unprojector::ray {
using namespace geometry;

std::optional<double> MeshDepth::operator()(const DevicePoint &position) const
{
    const auto hit = m_rays->at(position);
    if (!hit || !*hit)
        return std::nullopt;
    const Result<WindowPoint> window = windowFromWorld(m_rays->rays().setup(), (*hit)->world);
    return window ? std::optional(window->z) : std::nullopt;
}

} // namespace unprojector::ray
