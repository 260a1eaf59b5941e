#pragma once

#include "core/geometry/result.h"
#include "core/geometry/way_back.h"
#include "core/ray/ray.h"
#include "core/unproject/unprojector.h"

#include <glm/mat4x4.hpp>

#include <optional>

namespace unprojector::ray {

/// The rays through the positions of a setup, in world space and double precision, by the closed
/// form. They go from the near plane, t = 0, to the far plane, t = 1; the rays of a box are
/// parallel. A matrix that is no known projection uses its inverse in 32 digits. The near plane is
/// the one where |w| is smaller; in a box, the one in front along the eye's -z. If the far plane is
/// at infinity, t = 1 is an arbitrary point behind the near plane, and the ray has no end.
class ClickRays {
public:
    /// @param unprojector  of the setup, in this program's own convention
    explicit ClickRays(const unproject::Unprojector &unprojector);

    /// The ray through a position, inside or outside the viewport.
    /// @param position  continuous device pixels, origin top-left: a pixel's centre has halves
    /// @return the errors of Unprojector::worldAt; SingularMatrix
    geometry::Result<Ray<geometry::WorldSpace>> at(const geometry::DevicePoint &position) const;

    /// The method that computes the rays, and below the depths of their ends at t = 0 and t = 1.
    unproject::Method method() const { return m_method; }
    geometry::DepthRange depths() const { return {m_depthAtNear, m_depthAtFar}; }

    const geometry::Setup &setup() const { return m_unprojector.setup(); }
    /// The common point of a perspective's rays; nothing for a box.
    const std::optional<geometry::WorldPoint> &eye() const { return m_eye; }
    /// The setup's clipFromWorld with its sign turned where needed, so that w > 0 in front of the
    /// eye.
    const std::optional<glm::dmat4> &clipFromWorld() const { return m_clipFromWorld; }
    /// Returns whether a position lies in the viewport, its rim included.
    bool isInPicture(const geometry::DevicePoint &position) const;

private:
    void orderDepths();
    struct End {
        geometry::WorldPoint point;
        geometry::WorldVector error = {};
        double inverseW = 1.0; ///< of the clip point; its sign counts
    };
    geometry::Result<End> endAt(const geometry::DevicePoint &position, double depth) const;

    unproject::Unprojector m_unprojector;
    unproject::Method m_method = unproject::Method::Formula;
    geometry::Result<geometry::WayBack> m_wayBack; ///< where m_method is no formula
    double m_wInFront = 1.0;
    std::optional<glm::dmat4> m_clipFromWorld;
    double m_depthAtNear, m_depthAtFar;
    std::optional<geometry::WorldPoint> m_eye;
};

} // namespace unprojector::ray
