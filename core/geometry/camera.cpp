#include "core/geometry/camera.h"

#include "core/geometry/finite.h"

#include <algorithm>
#include <cmath>

namespace unprojector::geometry {
namespace {

/// v times the power of two that brings its largest component into [1, 2). The scaling is exact,
/// and the square cannot overflow.
DoubleDouble3 scaledToOne(const DoubleDouble3 &v)
{
    const double largest = std::max({std::abs(v[0].value), std::abs(v[1].value), std::abs(v[2].value)});
    const int exponent = std::ilogb(largest);
    const auto scaled = [&](const DoubleDouble &c) {
        return DoubleDouble(std::scalbn(c.value, -exponent), std::scalbn(c.rest, -exponent));
    };
    return {scaled(v[0]), scaled(v[1]), scaled(v[2])};
}

DoubleDouble3 unit(const DoubleDouble3 &v)
{
    const DoubleDouble norm = length(v);
    return {v[0] / norm, v[1] / norm, v[2] / norm};
}

bool isZero(const DoubleDouble3 &v)
{
    return v[0].value == 0.0 && v[1].value == 0.0 && v[2].value == 0.0;
}

DoubleDouble3 precise(const Components<3> &v)
{
    return {v.x, v.y, v.z};
}

WorldVector rounded(const DoubleDouble3 &v)
{
    return {v[0].value, v[1].value, v[2].value};
}

} // namespace

EyeFrame PreciseEyeFrame::rounded() const
{
    return {eye, geometry::rounded(side), geometry::rounded(upward), geometry::rounded(forward)};
}

Result<PreciseEyeFrame> preciseEyeFrame(const LookAt &view)
{
    for (const glm::dvec3 &v : {view.eye.coordinates(), view.center.coordinates(), view.up.coordinates()}) {
        if (const auto value = firstNotFinite(v))
            return Error{ErrorCode::NotFinite, *value};
    }
    const DoubleDouble3 eye = precise(view.eye), center = precise(view.center), up = precise(view.up);
    const DoubleDouble3 direction{center[0] - eye[0], center[1] - eye[1], center[2] - eye[2]};
    if (isZero(direction))
        return Error{ErrorCode::EyeEqualsCenter};
    if (isZero(up))
        return Error{ErrorCode::UpIsZero};

    const DoubleDouble3 f = unit(scaledToOne(direction));
    const DoubleDouble3 side = cross(f, unit(scaledToOne(up)));
    constexpr double kParallelSine = 1e-10;
    if (!(length(side).value > kParallelSine))
        return Error{ErrorCode::UpParallelToView};
    const DoubleDouble3 s = unit(side);
    return PreciseEyeFrame{view.eye, s, cross(s, f), f};
}

Result<EyeFrame> eyeFrame(const LookAt &view)
{
    const Result<PreciseEyeFrame> frame = preciseEyeFrame(view);
    if (!frame)
        return frame.error();
    return frame->rounded();
}

glm::dmat4 eyeFromWorld(const EyeFrame &frame)
{
    const auto &[eye, s, u, f] = frame;
    const WorldVector toEye = eye - WorldPoint();
    return {
        {s.x, u.x, -f.x, 0.0},
        {s.y, u.y, -f.y, 0.0},
        {s.z, u.z, -f.z, 0.0},
        {-dot(s, toEye), -dot(u, toEye), dot(f, toEye), 1.0},
    };
}

PrecisePoint<WorldSpace> preciseWorldFromEye(const PreciseEyeFrame &frame, const PrecisePoint<EyeSpace> &point)
{
    const auto component = [&](std::size_t k) {
        return frame.eye[static_cast<int>(k)] + point.x * frame.side[k] + point.y * frame.upward[k]
               - point.z * frame.forward[k];
    };
    return {component(0), component(1), component(2)};
}

WorldPoint worldFromEye(const PreciseEyeFrame &frame, const PrecisePoint<EyeSpace> &point)
{
    return preciseWorldFromEye(frame, point).rounded();
}

WorldPoint worldFromEye(const EyeFrame &frame, const EyePoint &point)
{
    return worldFromEye(PreciseEyeFrame{frame.eye, precise(frame.side), precise(frame.upward), precise(frame.forward)},
                        PrecisePoint<EyeSpace>(point));
}

EyePoint eyeFromWorld(const EyeFrame &frame, const WorldPoint &point)
{
    const WorldVector fromEye = point - frame.eye;
    return EyePoint(dot(frame.side, fromEye), dot(frame.upward, fromEye), -dot(frame.forward, fromEye));
}

} // namespace unprojector::geometry
