#include "core/camera.h"

#include <glm/geometric.hpp>

namespace unprojector {
namespace {

bool isFinite(const glm::dvec3 &v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double firstNotFinite(const glm::dvec3 &v)
{
    return !std::isfinite(v.x) ? v.x : !std::isfinite(v.y) ? v.y : v.z;
}

/// std::hypot neither overflows nor underflows, so cameras of any scale have axes.
double length(const glm::dvec3 &v)
{
    return std::hypot(v.x, v.y, v.z);
}

} // namespace

Result<EyeFrame> eyeFrame(const LookAt &view)
{
    for (const glm::dvec3 &v : {view.eye.coordinates(), view.center.coordinates(), view.up}) {
        if (!isFinite(v))
            return Error{ErrorCode::NotFinite, firstNotFinite(v)};
    }
    const glm::dvec3 direction = view.center - view.eye;
    const double distance = length(direction);
    if (distance == 0.0)
        return Error{ErrorCode::EyeEqualsCenter};
    const double upLength = length(view.up);
    if (upLength == 0.0)
        return Error{ErrorCode::UpIsZero};

    const glm::dvec3 forward = direction / distance;
    const glm::dvec3 side = glm::cross(forward, view.up / upLength);
    const double sine = length(side);
    constexpr double kParallelSine = 1e-10;
    if (!(sine > kParallelSine))
        return Error{ErrorCode::UpParallelToView};

    glm::dvec3 s = side / sine;
    // A nearly parallel up leaves few digits in the cross product; the axes must be orthogonal to the last place for
    // worldFromEye to be the inverse. Otherwise they are, and an exact 0 in a level side axis stays one.
    constexpr double kFewDigitsSine = 0.1;
    if (sine < kFewDigitsSine) {
        s -= forward * glm::dot(s, forward);
        s /= length(s);
    }
    glm::dvec3 u = glm::cross(s, forward);
    u /= length(u);
    return EyeFrame{view.eye, s, u, forward};
}

glm::dmat4 eyeFromWorld(const EyeFrame &frame)
{
    const auto &[eye, s, u, f] = frame;
    const glm::dvec3 origin = eye.coordinates();
    return {
        {s.x, u.x, -f.x, 0.0},
        {s.y, u.y, -f.y, 0.0},
        {s.z, u.z, -f.z, 0.0},
        {-glm::dot(s, origin), -glm::dot(u, origin), glm::dot(f, origin), 1.0},
    };
}

WorldPoint worldFromEye(const EyeFrame &frame, const EyePoint &point)
{
    const glm::dvec3 fromEye = point.x * frame.side + point.y * frame.upward - point.z * frame.forward;
    return WorldPoint(frame.eye.coordinates() + fromEye);
}

EyePoint eyeFromWorld(const EyeFrame &frame, const WorldPoint &point)
{
    const glm::dvec3 fromEye = point.coordinates() - frame.eye.coordinates();
    return EyePoint(glm::dot(frame.side, fromEye), glm::dot(frame.upward, fromEye), -glm::dot(frame.forward, fromEye));
}

} // namespace unprojector
