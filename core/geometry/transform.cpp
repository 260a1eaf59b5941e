#include "core/geometry/transform.h"

#include "core/geometry/finite.h"
#include "core/geometry/numbers.h"

#include <algorithm>
#include <cmath>

namespace unprojector::geometry {
namespace {

Check checkFinite(const glm::dvec3 &v)
{
    if (const auto value = firstNotFinite(v))
        return Error{ErrorCode::NotFinite, *value};
    return std::monostate{};
}

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
    struct Visitor {
        PreciseMatrix operator()(const Translate &t) const
        {
            glm::dmat4 m(1.0);
            m[3] = glm::dvec4(t.offset, 1.0);
            return PreciseMatrix(m);
        }
        PreciseMatrix operator()(const Rotate &r) const { return rotation(r); }
        PreciseMatrix operator()(const Scale &s) const
        {
            glm::dmat4 m(1.0);
            m[0][0] = s.factors.x;
            m[1][1] = s.factors.y;
            m[2][2] = s.factors.z;
            return PreciseMatrix(m);
        }
    };
    return std::visit(Visitor{}, step);
}

} // namespace

Check check(const TransformStep &step)
{
    struct Visitor {
        Check operator()(const Translate &t) const { return checkFinite(t.offset); }
        Check operator()(const Rotate &r) const
        {
            if (!std::isfinite(r.degrees))
                return Error{ErrorCode::NotFinite, r.degrees};
            if (const Check valid = checkFinite(r.axis); !valid)
                return valid;
            if (r.axis == glm::dvec3(0.0))
                return Error{ErrorCode::RotationAxisIsZero};
            return std::monostate{};
        }
        Check operator()(const Scale &s) const
        {
            if (const Check valid = checkFinite(s.factors); !valid)
                return valid;
            if (s.factors.x == 0.0 || s.factors.y == 0.0 || s.factors.z == 0.0)
                return Error{ErrorCode::ScaleIsZero, 0.0};
            return std::monostate{};
        }
    };
    return std::visit(Visitor{}, step);
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
