#include "core/unproject/pick.h"

namespace unprojector::unproject {

Result<Pick> pickAt(const ViewGeometry &geometry, const WidgetPoint &position, const DepthSample &sample)
{
    if (const Check valid = check(geometry); !valid)
        return valid.error();
    const Result<DevicePixel> pixel = devicePixelFromWidget(geometry.surface, position);
    if (!pixel)
        return pixel.error();
    const auto windowAt = [&](double depth) { return windowFromDevice(geometry.surface, pixelCenter(*pixel), depth); };
    const WindowPoint window = windowAt(sample.depth);

    Comparison point = compareUnprojections(geometry, window);
    Certainty certainty;
    if (sample.hit) {
        if (!point.eye.formula)
            return point.eye.formula.error();
        certainty = certaintyAt(geometry, -point.eye.formula->z, sample.depthBits);
    }
    return Pick{position,
                *pixel,
                window,
                sample.hit,
                sample.object,
                geometry,
                std::move(point),
                certainty,
                compareUnprojections(geometry, windowAt(geometry.depthRange.atNear)),
                compareUnprojections(geometry, windowAt(geometry.depthRange.atFar))};
}

} // namespace unprojector::unproject
