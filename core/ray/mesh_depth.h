#pragma once

#include "core/ray/scene_rays.h"

#include <memory>
#include <optional>
#include <utility>

namespace unprojector::ray {

/// A function object: the depth of the hit of a position's ray.
class MeshDepth {
public:
    explicit MeshDepth(std::shared_ptr<const SceneRays> rays) : m_rays(std::move(rays)) {}

    /// @param position  device pixels, origin top-left
    /// @return in the setup's depth range; nothing without a hit
    std::optional<double> operator()(const geometry::DevicePoint &position) const;

private:
    std::shared_ptr<const SceneRays> m_rays;
};

} // namespace unprojector::ray
