#pragma once

#include "core/geometry/result.h"
#include "core/ray/ray.h"
#include "core/unproject/unprojector.h"

#include <optional>

namespace unprojector::ray {

/// The rays through the positions of a picture, in world space and double precision, by the closed form: from the near plane,
/// t = 0, to the far plane, t = 1; parallel ones in a box. A matrix that is no known projection goes by its inverse. Where the far
/// plane is at infinity, t = 1 is anywhere behind the near plane, and the ray has no end.
class ClickRays {
public:
    /// @param unprojector  of the picture, with this program's own conventions
    explicit ClickRays(const unproject::Unprojector &unprojector);

    /// The ray through a position, in the viewport or not.
    /// @param position  continuous device pixels, origin top-left: a pixel's centre has halves
    /// @return the errors of Unprojector::worldAt
    geometry::Result<Ray<geometry::WorldSpace>> at(const geometry::DevicePoint &position) const;

    /// By which the rays are computed, and between which depths: those of t = 0 and t = 1.
    unproject::Method method() const { return m_method; }
    geometry::DepthRange depths() const { return {m_depthAtNear, m_depthAtFar}; }

    const geometry::Setup &setup() const { return m_unprojector.setup(); }
    /// Where a perspective's rays meet; nothing for a box and for a matrix that is no known projection.
    const std::optional<geometry::WorldPoint> &eye() const { return m_eye; }
    /// Whether a position lies in the viewport, its rim included, and so in the picture.
    bool isInPicture(const geometry::DevicePoint &position) const;

private:
    unproject::Unprojector m_unprojector;
    unproject::Method m_method = unproject::Method::Formula;
    double m_depthAtNear, m_depthAtFar;
    std::optional<geometry::WorldPoint> m_eye;
};

} // namespace unprojector::ray
