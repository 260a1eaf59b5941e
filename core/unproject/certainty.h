#pragma once

#include "core/geometry/setup.h"
#include "core/unproject/depth_error.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <initializer_list>

namespace unprojector::unproject {

/// The uncertainty of a click's point, which stands for the centre of its pixel. Its position in
/// the view is exact, so the point and the surface lie on the ray through that centre. Only the
/// distance along the ray is uncertain.
struct Certainty {
    /// Half a step of the depth buffer at that distance, world units along the view direction: the
    /// error of rounding the depth alone.
    double halfDepthStep = 0.0;
    /// The size of a pixel at that distance, world units: points within it give the same click. It
    /// does not add to the error of the point at the pixel's centre.
    double footprintWidth = 0.0;
    double footprintHeight = 0.0;
    /// The error bound of the distance, world units along the view direction: halfDepthStep and the
    /// error of the rasteriser (see DepthError).
    double distance = 0.0;
};

/// The error bound of each coordinate of a point.
struct Uncertainty {
    geometry::EyeVector eye;
    geometry::WorldVector world;
};

/// Computes the certainty and the uncertainty of points of a setup: constants of the setup are
/// computed once.
class Certainties {
public:
    /// @pre the setup is valid and by parameters
    explicit Certainties(const geometry::Setup &setup);

    /// Computes the certainty for an error delta of the window depth. With delta as a share of the
    /// range, q = delta / |df - dn|:
    ///
    ///   perspective  q z^2 (f-n) / (f n), divided by 1 - q z (f-n) / (f n): by the farther end
    ///   box          q (f-n)
    ///
    /// The result is limited by the near and far plane, since the drawn surface lies between them. The
    /// depth step is to first order. A pixel is (r-l) z / (n width) by (t-b) z / (n height), in a box
    /// (r-l) / width by (t-b) / height.
    /// @param distance  z > 0 in front of the eye (any z for a box), eye units
    Certainty at(double distance, const DepthError &error) const;

    /// Certainty::distance along the ray through the pixel's centre, on each axis; plus half a unit in
    /// the last place of the coordinate for its rounding. The errors of the axes are not independent:
    /// all have the same share.
    /// @param eye        the point
    /// @param world      the same
    /// @param certainty  at its distance
    /// @pre a perspective sees the point (z_eye is not 0)
    Uncertainty of(const geometry::EyePoint &eye, const geometry::WorldPoint &world, const Certainty &certainty) const;

    /// The largest difference from the point to anything in its pixel at that distance: half a pixel to
    /// the side and half a pixel up, on each axis, and the uncertainty. It is the uncertainty of pointing
    /// by hand.
    Uncertainty withinPixel(const geometry::EyePoint &eye, const geometry::WorldPoint &world,
                            const Certainty &certainty) const;

private:
    /// The vector along the ray through the point, as long as the certainty's distance.
    glm::dvec3 alongRay(const geometry::EyePoint &eye, const Certainty &certainty) const;
    /// The sum of error parts, given as vectors of eye space, on each axis: all of them may occur
    /// at once.
    Uncertainty summed(const geometry::EyePoint &eye, const geometry::WorldPoint &world,
                       std::initializer_list<glm::dvec3> parts) const;

    geometry::ProjectionWindow m_window;
    bool m_isPerspective;
    glm::dvec3 m_parallel; ///< the direction of a box's rays, per unit of distance in front of the eye
    double m_range;
    glm::dvec2 m_footprint; ///< of a pixel: at distance 1 in a perspective, at any distance in a box
    geometry::EyeFrame m_frame;
};

} // namespace unprojector::unproject
