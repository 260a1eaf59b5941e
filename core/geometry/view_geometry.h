#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projection.h"
#include "core/geometry/viewport.h"

#include <glm/mat4x4.hpp>

namespace unprojector::geometry {

/// How a picture of the world is taken, and all that is needed to compute a click on it again.
struct ViewGeometry {
    Surface surface;
    Viewport viewport;
    DepthRange depthRange;
    Projection projection;
    LookAt camera;
};

/// @return the first error of check(surface), check(viewport), check(depthRange), check(projection), eyeFrame(camera)
Check check(const ViewGeometry &geometry);

/// clipFromEye * eyeFromWorld
/// @return the errors of clipFromEye and eyeFrame
Result<glm::dmat4> clipFromWorld(const ViewGeometry &geometry);

/// The way forward, stage by stage; nothing when the point lies in the plane of the eye (w = 0).
/// @return PointAtInfinity; the errors of clipFromWorld
Result<WindowPoint> windowFromWorld(const ViewGeometry &geometry, const WorldPoint &point);

/// How far apart world points can lie and still give the depth and the pixel that were read.
struct Certainty {
    /// Half a step of the depth buffer at that distance, world units along the view direction: rounding the depth
    /// puts the true point within plus or minus this.
    double halfDepthStep = 0.0;
    /// Size of one pixel at that distance, world units.
    double footprintWidth = 0.0;
    double footprintHeight = 0.0;

    /// The largest of the three halves: how far off a coordinate can be.
    double radius() const;
};

/// Perspective: half of z^2 (f-n) / (f n) / (2^N - 1), and (r-l) z / (n width) by (t-b) z / (n height).
/// Box: half of (f-n) / (2^N - 1), and (r-l) / width by (t-b) / height.
/// @param distance   z > 0 in front of the eye (any z for a box), eye units
/// @param depthBits  of the depth buffer, fixed point
/// @pre the geometry is valid
Certainty certaintyAt(const ViewGeometry &geometry, double distance, int depthBits);

} // namespace unprojector::geometry
