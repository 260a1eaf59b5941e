#include "core/scene/opening_view.h"

#include "core/geometry/numbers.h"

#include <cmath>

namespace unprojector::scene {
using namespace geometry;

namespace {

/// 1, 2 or 5 times a power of ten, at least `value`.
double roundedUp(double value)
{
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit * power >= value * (1.0 - 1e-9))
            return digit * power;
    }
    return 10.0 * power;
}

} // namespace

Projection openingProjection()
{
    return Perspective{Angle::fromDegrees(45.0), 1.0, 0.1, 100.0};
}

LookAt openingCamera(const std::vector<SceneObject> &objects, const Surface &surface)
{
    // Scans usually face +z; a view slightly from above and the side shows their depth.
    Setup home{surface,
               wholeSurface(surface),
               {},
               openingProjection(),
               LookAt{WorldPoint(0.35, 0.25, 1.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}}};
    home.projection() = withAspect(home.projection(), aspectOf(home.viewport));
    Framing framing(home);
    for (const SceneObject &object : objects) {
        if (!object.isHidden)
            add(framing, object);
    }
    return framing.setup().camera();
}

Ground groundUnder(const Box &bounds)
{
    Ground ground;
    if (bounds.isEmpty())
        return ground;
    const double size = bounds.diagonal() > 0.0 ? bounds.diagonal() : 1.0;
    ground.spacing = roundedUp(size / 15.0);
    // Lines lie at multiples of the spacing, so that they can be read as coordinates.
    const auto snapped = [&ground](double value, double direction) {
        return (std::floor(value / ground.spacing) + direction) * ground.spacing;
    };
    const double margin = size * 0.5;
    const double y = bounds.lowest.y;
    ground.box.add({snapped(bounds.lowest.x - margin, 0.0), y, snapped(bounds.lowest.z - margin, 0.0)});
    ground.box.add({snapped(bounds.highest.x + margin, 1.0), y, snapped(bounds.highest.z + margin, 1.0)});
    return ground;
}

} // namespace unprojector::scene
