#include "core/geometry/transform.h"

#include "core/geometry/angle.h"
#include "core/geometry/finite.h"

#include <cmath>

namespace unprojector::geometry {
namespace {

Check checkFinite(const glm::dvec3 &v)
{
    if (const auto value = firstNotFinite(v))
        return Error{ErrorCode::NotFinite, *value};
    return std::monostate{};
}

struct CosineSine {
    double c, s;
};

/// Exact at multiples of 90 degrees, where cos(pi/2) would leave 6e-17.
CosineSine cosineSine(double degrees)
{
    const double turn = std::remainder(degrees, 360.0);
    if (turn == 0.0)
        return {1.0, 0.0};
    if (turn == 90.0)
        return {0.0, 1.0};
    if (turn == -90.0)
        return {0.0, -1.0};
    if (std::abs(turn) == 180.0)
        return {-1.0, 0.0};
    const double radians = radiansFromDegrees(turn);
    return {std::cos(radians), std::sin(radians)};
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
    struct Visitor {
        glm::dmat4 operator()(const Translate &t) const
        {
            glm::dmat4 m(1.0);
            m[3] = glm::dvec4(t.offset, 1.0);
            return m;
        }
        glm::dmat4 operator()(const Rotate &r) const
        {
            const glm::dvec3 a = r.axis / std::hypot(r.axis.x, r.axis.y, r.axis.z);
            const auto [c, s] = cosineSine(r.degrees);
            const double k = 1.0 - c;
            return {
                {a.x * a.x * k + c, a.y * a.x * k + a.z * s, a.z * a.x * k - a.y * s, 0.0},
                {a.x * a.y * k - a.z * s, a.y * a.y * k + c, a.z * a.y * k + a.x * s, 0.0},
                {a.x * a.z * k + a.y * s, a.y * a.z * k - a.x * s, a.z * a.z * k + c, 0.0},
                {0.0, 0.0, 0.0, 1.0},
            };
        }
        glm::dmat4 operator()(const Scale &s) const
        {
            glm::dmat4 m(1.0);
            m[0][0] = s.factors.x;
            m[1][1] = s.factors.y;
            m[2][2] = s.factors.z;
            return m;
        }
    };
    return std::visit(Visitor{}, step);
}

glm::dmat4 worldFromObject(const std::vector<TransformStep> &steps)
{
    glm::dmat4 product(1.0);
    for (const TransformStep &step : steps)
        product = product * matrixOf(step);
    return product;
}

} // namespace unprojector::geometry
