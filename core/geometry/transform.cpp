#include "core/geometry/transform.h"

#include "core/geometry/finite.h"
#include "core/geometry/numbers.h"

#include <algorithm>
#include <cmath>

namespace unprojector::geometry {
namespace {

/// Sine and cosine, exact at multiples of 90 degrees, where cos(pi/2) would leave 6e-17.
SineCosine sineCosineOf(double degrees)
{
    const double turn = std::remainder(degrees, 360.0);
    if (turn == 0.0)
        return {0.0, 1.0};
    if (turn == 90.0)
        return {1.0, 0.0};
    if (turn == -90.0)
        return {-1.0, 0.0};
    if (std::abs(turn) == 180.0)
        return {0.0, -1.0};
    return preciseSineCosine(kPrecisePi * turn / 180.0);
}

PreciseMatrix rotation(const Rotate &r)
{
    // Scaled to about 1: the square of a length can leave the range of doubles.
    const double longest = std::max({std::abs(r.axis.x), std::abs(r.axis.y), std::abs(r.axis.z)});
    const DoubleDouble3 axis{DoubleDouble(r.axis.x) / longest, DoubleDouble(r.axis.y) / longest,
                             DoubleDouble(r.axis.z) / longest};
    const DoubleDouble size = length(axis);
    const DoubleDouble x = axis[0] / size, y = axis[1] / size, z = axis[2] / size;
    const auto [s, c] = sineCosineOf(r.degrees);
    const DoubleDouble k = 1.0 - c;
    PreciseMatrix m(glm::dmat4(1.0));
    m.columns[0] = {x * x * k + c, y * x * k + z * s, z * x * k - y * s, 0.0};
    m.columns[1] = {x * y * k - z * s, y * y * k + c, z * y * k + x * s, 0.0};
    m.columns[2] = {x * z * k + y * s, y * z * k - x * s, z * z * k + c, 0.0};
    return m;
}

PreciseMatrix preciseMatrixOf(const TransformStep &step)
{
    if (const auto *rotate = std::get_if<Rotate>(&step))
        return rotation(*rotate);
    glm::dmat4 m(1.0);
    if (const auto *translate = std::get_if<Translate>(&step)) {
        m[3] = glm::dvec4(translate->offset, 1.0);
        return m;
    }
    for (int axis = 0; axis < 3; ++axis)
        m[axis][axis] = std::get_if<Scale>(&step)->factors[axis];
    return m;
}

} // namespace

Check check(const TransformStep &step)
{
    const auto *rotate = std::get_if<Rotate>(&step);
    const auto *scale = std::get_if<Scale>(&step);
    if (rotate && !std::isfinite(rotate->degrees))
        return Error{ErrorCode::NotFinite, rotate->degrees};
    const glm::dvec3 &v = rotate ? rotate->axis : scale ? scale->factors : std::get_if<Translate>(&step)->offset;
    if (const auto value = firstNotFinite(v))
        return Error{ErrorCode::NotFinite, *value};
    if (rotate && v == glm::dvec3(0.0))
        return Error{ErrorCode::RotationAxisIsZero};
    if (scale && (v.x == 0.0 || v.y == 0.0 || v.z == 0.0))
        return Error{ErrorCode::ScaleIsZero, 0.0};
    return std::monostate{};
}

glm::dmat4 matrixOf(const TransformStep &step)
{
    return preciseMatrixOf(step).rounded();
}

PreciseMatrix preciseWorldFromObject(const std::vector<TransformStep> &steps)
{
    PreciseMatrix product;
    for (const TransformStep &step : steps)
        product = product * preciseMatrixOf(step);
    return product;
}

glm::dmat4 worldFromObject(const std::vector<TransformStep> &steps)
{
    return preciseWorldFromObject(steps).rounded();
}

} // namespace unprojector::geometry
