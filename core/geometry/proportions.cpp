#include "core/geometry/proportions.h"

#include <cmath>

namespace unprojector::geometry {

Proportions proportions(const Picture &geometry, const WindowPoint &window)
{
    const ProjectionWindow w = projectionWindow(geometry.projection());
    const Viewport &v = geometry.viewport;
    const glm::dvec2 share((window.x - v.x) / v.width, (window.y - v.y) / v.height);
    // Both ends come out exactly, which left + share (right - left) would not give.
    return {share, {w.left * (1.0 - share.x) + w.right * share.x, w.bottom * (1.0 - share.y) + w.top * share.y}};
}

double circleAspect(const Picture &geometry)
{
    const ProjectionWindow w = projectionWindow(geometry.projection());
    const Viewport &v = geometry.viewport;
    return v.width / std::abs(w.right - w.left) / (v.height / std::abs(w.top - w.bottom));
}

glm::dvec2 pixelFootprint(const Picture &picture, double distance)
{
    const ProjectionWindow w = projectionWindow(picture.projection());
    const double magnification = isPerspective(picture.projection()) ? distance / w.nearDistance : 1.0;
    return {std::abs(w.right - w.left) * magnification / picture.viewport.width,
            std::abs(w.top - w.bottom) * magnification / picture.viewport.height};
}

} // namespace unprojector::geometry
