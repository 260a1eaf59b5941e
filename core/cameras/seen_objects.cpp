#include "core/cameras/seen_objects.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace unprojector::cameras {
namespace {

constexpr int kPoints = 27;

/// A point of a box: the corners, and the centres between them.
glm::dvec4 pointOf(const geometry::Box &box, int index)
{
    const glm::dvec3 share(index % 3 / 2.0, index / 3 % 3 / 2.0, index / 9 / 2.0);
    return glm::dvec4(glm::mix(box.lowest, box.highest, share), 1.0);
}

} // namespace

double seenPart(const glm::dmat4 &clipFromEye, const glm::dmat4 &eyeFromWorld, const geometry::Box &box)
{
    int seen = 0;
    for (int i = 0; i < kPoints; ++i) {
        const glm::dvec4 clip = clipFromEye * (eyeFromWorld * pointOf(box, i));
        seen += clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w ? 1 : 0;
    }
    return double(seen) / kPoints;
}

double imageShare(const glm::dmat4 &clipFromEye, const glm::dmat4 &eyeFromWorld, const geometry::Box &box)
{
    geometry::Box ndc;
    for (int i = 0; i < kPoints; ++i) {
        const glm::dvec4 clip = clipFromEye * (eyeFromWorld * pointOf(box, i));
        if (!(clip.w > 0.0))
            return 0.0;
        ndc.add({clip.x / clip.w, clip.y / clip.w, 0.0});
    }
    constexpr double kWholeSide = 2.0; // of the image in NDC
    return std::max(ndc.highest.x - ndc.lowest.x, ndc.highest.y - ndc.lowest.y) / kWholeSide;
}

DepthExtent depthExtent(const glm::dmat4 &eyeFromWorld, const geometry::Box &box)
{
    DepthExtent extent{std::numeric_limits<double>::infinity(), 0.0};
    for (int i = 0; i < kPoints; ++i) {
        const double depth = -(eyeFromWorld * pointOf(box, i)).z;
        extent.nearest = std::min(extent.nearest, std::max(depth, 0.0));
        extent.farthest = std::max(extent.farthest, depth);
    }
    return extent;
}

} // namespace unprojector::cameras
