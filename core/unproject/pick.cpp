#include "core/unproject/pick.h"

namespace unprojector::unproject {

Result<Pick> pickAt(const Unprojector &unprojector, const WidgetPoint &position, const DepthSample &sample)
{
    const Picture &picture = unprojector.picture();
    const Result<DevicePixel> pixel = devicePixelFromWidget(picture.surface, position);
    if (!pixel)
        return pixel.error();
    const Result<WindowPoint> clicked = unprojector.windowAt(position, sample.depth);
    if (!clicked)
        return clicked.error();
    const WindowPoint window = *clicked;
    const auto windowAt = [&](double depth) { return WindowPoint(window.x, window.y, depth); };

    const Unprojected point = unprojector.at(window);
    Certainty certainty;
    Uncertainty uncertainty;
    if (sample.hit()) {
        const Result<EyePoint> &eye = point.eye[Method::Formula];
        if (!eye)
            return eye.error();
        certainty = certaintyAt(picture, -eye->z, sample.depthBits);
        uncertainty = uncertaintyOf(picture, *eye, certainty);
    }
    return Pick{position,
                *pixel,
                window,
                sample.object,
                picture,
                point,
                certainty,
                uncertainty,
                unprojector.at(windowAt(picture.depthRange.atNear)),
                unprojector.at(windowAt(picture.depthRange.atFar))};
}

} // namespace unprojector::unproject
