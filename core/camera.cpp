#include "core/camera.h"

#include "core/exact_rounding.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

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

/// v times the power of two that brings its largest component into [1, 2): exact.
glm::dvec3 scaledToOne(const glm::dvec3 &v)
{
    const int exponent = std::ilogb(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
    return {std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)};
}

/// a x b, each component within 1.5 units in the last place.
glm::dvec3 accurateCross(const glm::dvec3 &a, const glm::dvec3 &b)
{
    return {sumOfProducts(a.y, b.z, -a.z, b.y), sumOfProducts(a.z, b.x, -a.x, b.z), sumOfProducts(a.x, b.y, -a.y, b.x)};
}

/// v / |v|, of length 1 to within the rounding of its components: one Newton step on 1 - v.v, whose cancellation
/// is carried out exactly. A component that is 0 stays 0.
glm::dvec3 accurateUnit(glm::dvec3 v)
{
    v /= length(v);
    glm::dvec3 squares = v * v;
    double excess = 0.0;
    for (int k = 0; k < 3; ++k)
        excess += lostByProduct(v[k], v[k]);
    if (squares.x < squares.y)
        std::swap(squares.x, squares.y);
    if (squares.x < squares.z)
        std::swap(squares.x, squares.z);
    excess += ((squares.x - 1.0) + squares.y) + squares.z; // the largest first: its difference to 1 stays exact
    return v - v * (excess / 2.0);
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
    if (length(view.up) == 0.0)
        return Error{ErrorCode::UpIsZero};

    // An up close to the view direction leaves only the last digits of the cross product, and they point the side
    // axis: so nothing is rounded before it, and what center - eye has dropped is put back.
    const glm::dvec3 up = scaledToOne(view.up);
    const glm::dvec3 scaledDirection = scaledToOne(direction);
    glm::dvec3 dropped;
    for (int k = 0; k < 3; ++k)
        dropped[k] = lostBySum(view.center[k], -view.eye[k]) / distance;
    const glm::dvec3 side =
        (accurateCross(scaledDirection, up) / length(scaledDirection) + glm::cross(dropped, up)) / length(up);
    const double sine = length(side);
    constexpr double kParallelSine = 1e-10;
    if (!(sine > kParallelSine))
        return Error{ErrorCode::UpParallelToView};

    const glm::dvec3 forward = accurateUnit(direction);
    const glm::dvec3 s = accurateUnit(side);
    const glm::dvec3 u = accurateUnit(accurateCross(s, forward));
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
    // Near the world's origin the eye and the way from it cancel, so what rounding drops is added at the end.
    WorldPoint world;
    for (int k = 0; k < 3; ++k) {
        double sum = frame.eye[k], dropped = 0.0;
        const auto add = [&](double coordinate, double axis) {
            const double product = coordinate * axis;
            dropped += lostByProduct(coordinate, axis) + lostBySum(sum, product);
            sum += product;
        };
        add(point.x, frame.side[k]);
        add(point.y, frame.upward[k]);
        add(-point.z, frame.forward[k]);
        world[k] = sum + dropped;
    }
    return world;
}

EyePoint eyeFromWorld(const EyeFrame &frame, const WorldPoint &point)
{
    const glm::dvec3 fromEye = point.coordinates() - frame.eye.coordinates();
    return EyePoint(glm::dot(frame.side, fromEye), glm::dot(frame.upward, fromEye), -glm::dot(frame.forward, fromEye));
}

} // namespace unprojector
