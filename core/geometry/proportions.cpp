#include "core/geometry/proportions.h"

#include <cmath>

namespace unprojector::geometry {

Proportions proportions(const Setup &setup, const WindowPoint &window)
{
    const ProjectionWindow w = projectionWindow(setup.projection());
    const Viewport &v = setup.viewport;
    const glm::dvec2 share((window.x - v.x) / v.width, (window.y - v.y) / v.height);
    // Both ends come out exactly; left + share (right - left) would not guarantee that.
    return {share, {w.left * (1.0 - share.x) + w.right * share.x, w.bottom * (1.0 - share.y) + w.top * share.y}};
}

double circleAspect(const Setup &setup)
{
    const ProjectionWindow w = projectionWindow(setup.projection());
    const Viewport &v = setup.viewport;
    return v.width / std::abs(w.right - w.left) / (v.height / std::abs(w.top - w.bottom));
}

glm::dvec2 pixelFootprint(const Setup &setup, double distance)
{
    const ProjectionWindow w = projectionWindow(setup.projection());
    const double magnification = isPerspective(setup.projection()) ? distance / w.nearDistance : 1.0;
    return {std::abs(w.right - w.left) * magnification / setup.viewport.width,
            std::abs(w.top - w.bottom) * magnification / setup.viewport.height};
}

} // namespace unprojector::geometry
