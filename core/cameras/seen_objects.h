#pragma once

#include "core/geometry/box.h"

#include <glm/mat4x4.hpp>

namespace unprojector::cameras {

/// The part of a box that a camera sees: of 27 of its points (corners, centres of edges and faces,
/// centre), those in front of the camera and in the image. 0 to 1.
double seenPart(const glm::dmat4 &clipFromEye, const glm::dmat4 &eyeFromWorld, const geometry::Box &box);

/// The larger side of the part of the image that a box takes, in parts of the image's side; 0 for a
/// box that reaches behind the eye.
double imageShare(const glm::dmat4 &clipFromEye, const glm::dmat4 &eyeFromWorld, const geometry::Box &box);

/// The depths of a box in front of the eye.
struct DepthExtent {
    double nearest = 0.0, farthest = 0.0;
};
/// @return nearest is 0 where the box reaches behind the eye; farthest is 0 if all of it lies there
DepthExtent depthExtent(const glm::dmat4 &eyeFromWorld, const geometry::Box &box);

} // namespace unprojector::cameras
