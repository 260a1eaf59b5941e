#include "core/unproject/pick.h"

#include <utility>

namespace unprojector::unproject {
using namespace geometry;

Pick refined(Pick pick, const DrawnSurface &surface)
{
    const Result<EyePoint> &eye = pick.point.eye[Method::Formula];
    const Result<WorldPoint> &world = pick.point.world[Method::Formula];
    if (!pick.hit() || !eye || !world)
        return pick;
    const Certainties certainties(pick.setup);
    pick.certainty = certainties.at(-eye->z, depthErrorAt(pick.setup, pick.window, *world, pick.sample, surface));
    // A dot only tells that its point's pixel is among the pixels that it covers.
    pick.certainty.footprintWidth *= pick.sample.dotPixels;
    pick.certainty.footprintHeight *= pick.sample.dotPixels;
    pick.withinPixel = certainties.withinPixel(*eye, *world, pick.certainty);
    const bool isPoint = surface.isPoint || (pick.sample.dotPixels > 1.0 && !surface.triangle);
    pick.uncertainty = isPoint ? pick.withinPixel : certainties.of(*eye, *world, pick.certainty);
    return pick;
}

Result<ObjectPoint> objectPointOf(const Pick &pick, Method method, const PreciseMatrix &worldFromObject)
{
    const Result<ObjectFromWorld> object = ObjectFromWorld::of(worldFromObject);
    if (!object)
        return object.error();
    const Result<Unprojector> unprojector = Unprojector::of(pick.setup);
    return unprojector ? unprojector->objectAt(method, pick.window, *object) : unprojector.error();
}

Result<Pick> pickAt(const Unprojector &unprojector, const PixelClick &click, const SurfaceAt &surfaceAt)
{
    const Setup &setup = unprojector.setup();
    const WindowPoint window = windowFromDevice(setup.surface, pixelCenter(click.pixel), click.sample.depth);
    const auto windowAt = [&](double depth) { return WindowPoint(window.x, window.y, depth); };

    Pick pick{click.position,
              click.pixel,
              window,
              click.sample.object,
              setup,
              unprojector.at(window),
              {},
              {},
              {},
              unprojector.at(windowAt(setup.depthRange.atNear)),
              unprojector.at(windowAt(setup.depthRange.atFar)),
              click.sample};
    if (const Result<EyePoint> &eye = pick.point.eye[Method::Formula]; pick.hit() && !eye)
        return eye.error();
    const Result<WorldPoint> &world = pick.point.world[Method::Formula];
    const DrawnSurface surface = pick.hit() && world && surfaceAt ? surfaceAt(*world) : DrawnSurface{};
    return refined(pick, surface);
}

} // namespace unprojector::unproject
