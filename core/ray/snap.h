#pragma once

#include "core/ray/scene_rays.h"

#include <optional>

namespace unprojector::ray {

/// What in sight near a position a click snaps to. What is in sight is found by rays through the positions about it, a pixel
/// apart: a triangle too small for any of them to meet is not seen there.
class SnapSearch {
public:
    /// @param rays  outlive this
    SnapSearch(const SceneRays &rays, const DevicePoint &position);

    /// The vertex of a triangle in sight that is nearest in the picture, within kSnapPixels, and that nothing hides.
    std::optional<SceneHit> vertex() const;
    /// The point of such a triangle's edge.
    std::optional<SceneHit> edge() const;
    /// The nearest place at which a triangle was met.
    std::optional<SceneHit> face() const;

private:
    /// A triangle that was met, and how far from the position.
    struct Seen {
        SceneHit hit;
        double pixels;
    };
    /// A place on a triangle.
    struct Place {
        std::size_t object;
        std::uint32_t triangle;
        glm::dvec3 barycentric;
        WorldPoint world;
        double pixels; ///< from the position
    };

    /// Where a world point is seen; nothing behind the eye.
    std::optional<DevicePoint> seenAt(const WorldPoint &point) const;
    std::optional<SceneHit> nearestInSight(std::vector<Place> places) const;
    std::optional<SceneHit> inSight(const Place &place) const;

    const SceneRays &m_rays;
    DevicePoint m_position;
    std::optional<glm::dmat4> m_clipFromWorld;
    double m_nearW = 1.0;     ///< of clip space, on the near plane
    std::vector<Seen> m_seen; ///< the nearest first, each triangle once
};

} // namespace unprojector::ray
