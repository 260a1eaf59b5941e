#pragma once

#include "core/ray/scene_rays.h"

#include <memory>
#include <optional>
#include <utility>

namespace unprojector::ray {

/// A function object: the point of the surface on a position's ray.
class MeshPoint {
public:
    explicit MeshPoint(std::shared_ptr<const SceneRays> rays) : m_rays(std::move(rays)) {}

    /// @param position  device pixels, origin top-left
    /// @return the hit. For a point of a point cloud, which lies beside the ray, the ray's point at
    ///         the same depth. Nothing without a hit
    std::optional<geometry::WorldPoint> operator()(const geometry::DevicePoint &position) const;

private:
    std::shared_ptr<const SceneRays> m_rays;
};

} // namespace unprojector::ray
