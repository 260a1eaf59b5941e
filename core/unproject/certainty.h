#pragma once

#include "core/geometry/setup.h"
#include "core/unproject/depth_error.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <initializer_list>

namespace unprojector::unproject {

/// How sure the point of a click is, which stands for the centre of its pixel. Its place in the picture is exact; so it lies on
/// the ray through that centre, and so does the surface: what is not sure is how far along.
struct Certainty {
    /// Half a step of the depth buffer at that distance, world units along the view direction: what rounding the depth alone
    /// leaves open.
    double halfDepthStep = 0.0;
    /// Size of one pixel at that distance, world units: how far apart points can lie and still be clicked as one. It says
    /// nothing against the point of the pixel's centre.
    double footprintWidth = 0.0;
    double footprintHeight = 0.0;
    /// How much nearer or farther than the point the surface may be, world units along the view direction: halfDepthStep and
    /// what the rasteriser was off (see DepthError).
    double distance = 0.0;
};

/// To window depth's error delta, of which the range's share is q = delta / |df - dn|:
///
///   perspective  q z^2 (f-n) / (f n), divided by 1 - q z (f-n) / (f n): by the end that is farther off
///   box          q (f-n)
///
/// and no more than there is to the near or far plane, since what was drawn lies between them. The depth step to first
/// order. A pixel is (r-l) z / (n width) by (t-b) z / (n height), in a box (r-l) / width by (t-b) / height.
/// @param distance  z > 0 in front of the eye (any z for a box), eye units
/// @pre the setup is valid and by parameters
Certainty certaintyAt(const geometry::Setup &setup, double distance, const DepthError &error);

/// How far each coordinate of a point can be off, at most.
struct Uncertainty {
    geometry::EyeVector eye;
    geometry::WorldVector world;
};

/// Certainty::distance along the ray through the pixel's centre, on each axis; and half a unit in the last place of the
/// coordinate, to which it is rounded. The axes are not off independently: all of them by the same share.
/// @param eye        the point
/// @param world      the same
/// @param certainty  at its distance
/// @pre the setup is valid and by parameters; a perspective sees the point (z_eye is not 0)
Uncertainty uncertaintyOf(const geometry::Setup &setup, const geometry::EyePoint &eye,
                          const geometry::WorldPoint &world, const Certainty &certainty);

/// certaintyAt and uncertaintyOf for many pixels of a picture: what hangs on the picture alone is computed once.
class Certainties {
public:
    /// @pre the setup is valid and by parameters
    explicit Certainties(const geometry::Setup &setup);

    Certainty at(double distance, const DepthError &error) const;
    Uncertainty of(const geometry::EyePoint &eye, const geometry::WorldPoint &world, const Certainty &certainty) const;

private:
    friend Uncertainty withinPixel(const geometry::Setup &setup, const geometry::EyePoint &eye,
                                   const geometry::WorldPoint &world, const Certainty &certainty);

    /// Along the ray through the point, as far as the certainty's distance.
    glm::dvec3 alongRay(const geometry::EyePoint &eye, const Certainty &certainty) const;
    /// Parts of an error, as vectors of eye space, on each axis: added up, since all of them can be off at once.
    Uncertainty summed(const geometry::EyePoint &eye, const geometry::WorldPoint &world,
                       std::initializer_list<glm::dvec3> parts) const;

    geometry::ProjectionWindow m_window;
    bool m_isPerspective;
    glm::dvec3 m_parallel; ///< a box's rays, for a unit of distance in front of the eye
    double m_range;
    glm::dvec2 m_footprint; ///< of a pixel at the distance 1 in a perspective, anywhere in a box
    geometry::EyeFrame m_frame;
};

/// How far from the point what lies in its pixel at that distance can be, besides: half a pixel to the side and half a
/// pixel up, on each axis, and uncertaintyOf. What a hand that points at something leaves open.
Uncertainty withinPixel(const geometry::Setup &setup, const geometry::EyePoint &eye, const geometry::WorldPoint &world,
                        const Certainty &certainty);

} // namespace unprojector::unproject
