#include "core/geometry/view_geometry.h"

#include <algorithm>
#include <cmath>

namespace unprojector::geometry {

Check check(const ViewGeometry &geometry)
{
    const Check checks[] = {check(geometry.surface), check(geometry.viewport), check(geometry.depthRange),
                            check(geometry.projection)};
    for (const Check &valid : checks) {
        if (!valid)
            return valid;
    }
    if (const Result<EyeFrame> frame = eyeFrame(geometry.camera); !frame)
        return frame.error();
    return std::monostate{};
}

Result<glm::dmat4> clipFromWorld(const ViewGeometry &geometry)
{
    const Result<glm::dmat4> projection = clipFromEye(geometry.projection);
    if (!projection)
        return projection;
    const Result<EyeFrame> frame = eyeFrame(geometry.camera);
    if (!frame)
        return frame.error();
    return *projection * eyeFromWorld(*frame);
}

Result<WindowPoint> windowFromWorld(const ViewGeometry &geometry, const WorldPoint &point)
{
    const Result<glm::dmat4> matrix = clipFromWorld(geometry);
    if (!matrix)
        return matrix.error();
    const ClipPoint clip(*matrix * glm::dvec4(point.coordinates(), 1.0));
    if (clip.w == 0.0)
        return Error{ErrorCode::PointAtInfinity};
    const NdcPoint ndc(clip.x / clip.w, clip.y / clip.w, clip.z / clip.w);
    return windowFromNdc(geometry.viewport, geometry.depthRange, ndc);
}

double Certainty::radius() const
{
    return std::max({halfDepthStep, footprintWidth / 2.0, footprintHeight / 2.0});
}

Certainty certaintyAt(const ViewGeometry &geometry, double distance, int depthBits)
{
    const ProjectionWindow w = projectionWindow(geometry.projection);
    const double n = w.nearDistance, f = w.farDistance;
    const double steps =
        (std::ldexp(1.0, depthBits) - 1.0) * std::abs(geometry.depthRange.atFar - geometry.depthRange.atNear);
    const bool perspective = isPerspective(geometry.projection);
    const double step = perspective ? distance * distance * (f - n) / (f * n) / steps : (f - n) / steps;
    const double magnification = perspective ? distance / n : 1.0;
    return {step / 2.0, std::abs(w.right - w.left) * magnification / geometry.viewport.width,
            std::abs(w.top - w.bottom) * magnification / geometry.viewport.height};
}

} // namespace unprojector::geometry
