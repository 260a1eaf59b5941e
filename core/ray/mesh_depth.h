#pragma once

#include "core/ray/scene_rays.h"

#include <memory>
#include <optional>
#include <utility>

namespace unprojector::ray {

/// The depth of what the ray of a position meets, as a function.
class MeshDepth {
public:
    explicit MeshDepth(std::shared_ptr<const SceneRays> rays) : m_rays(std::move(rays)) {}

    /// @param position  device pixels, origin top-left
    /// @return in the picture's depth range; nothing where nothing is met
    std::optional<double> operator()(const geometry::DevicePoint &position) const;

private:
    std::shared_ptr<const SceneRays> m_rays;
};

} // namespace unprojector::ray
