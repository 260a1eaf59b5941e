#include "core/geometry/view_matrix.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::geometry {
namespace {

constexpr double kRigid = 1e-5;

/// target - R p - t
DoubleDouble3 residual(const glm::dmat4 &m, const DoubleDouble3 &target, const DoubleDouble3 &p)
{
    DoubleDouble3 result;
    for (int row = 0; row < 3; ++row)
        result[std::size_t(row)] =
            target[std::size_t(row)] - m[3][row] - m[0][row] * p[0] - m[1][row] * p[1] - m[2][row] * p[2];
    return result;
}

} // namespace

Result<double> axesOff(const glm::dmat4 &m)
{
    for (int i = 0; i < 16; ++i) {
        if (!std::isfinite(m[i / 4][i % 4]))
            return Error{ErrorCode::NotFinite, m[i / 4][i % 4], double(i)};
    }
    for (int column = 0; column < 4; ++column) {
        if (m[column][3] != (column == 3 ? 1.0 : 0.0))
            return Error{ErrorCode::ViewNotRigid, m[column][3], double(column * 4 + 3)};
    }
    const glm::dmat3 axes(m);
    const glm::dmat3 off = axes * glm::transpose(axes) - glm::dmat3(1.0);
    double largest = 0.0;
    for (int i = 0; i < 9; ++i) {
        const double entry = std::abs(off[i / 3][i % 3]);
        largest = std::isfinite(entry) ? std::max(largest, entry) : entry;
        if (!(largest <= kRigid))
            return Error{ErrorCode::ViewNotRigid, largest};
    }
    return largest;
}

Result<WorldPoint> worldFromEye(const glm::dmat4 &m, const PrecisePoint<EyeSpace> &point)
{
    if (const Result<double> off = axesOff(m); !off)
        return off.error();
    DoubleDouble3 p;
    for (int i = 0; i < 3; ++i) {
        const DoubleDouble3 left = residual(m, {point.x, point.y, point.z}, p);
        for (int k = 0; k < 3; ++k)
            p[std::size_t(k)] = p[std::size_t(k)] + (m[k][0] * left[0] + m[k][1] * left[1] + m[k][2] * left[2]);
    }
    const WorldPoint world(p[0].value, p[1].value, p[2].value);
    if (!(std::isfinite(world.x) && std::isfinite(world.y) && std::isfinite(world.z)))
        return Error{ErrorCode::PointAtInfinity};
    return world;
}

Result<WorldPoint> worldFromEye(const glm::dmat4 &eyeFromWorld, const EyePoint &point)
{
    return worldFromEye(eyeFromWorld, PrecisePoint<EyeSpace>{point.x, point.y, point.z});
}

Result<LookAt> lookAtFrom(const glm::dmat4 &eyeFromWorld, double distance)
{
    const Result<WorldPoint> eye = worldFromEye(eyeFromWorld, EyePoint());
    if (!eye)
        return eye.error();
    const glm::dmat3 rows = glm::transpose(glm::dmat3(eyeFromWorld));
    if (glm::determinant(rows) < 0.0)
        return Error{ErrorCode::ViewNotRigid, 2.0};
    return LookAt{*eye, WorldPoint(eye->coordinates() - rows[2] * distance), rows[1]};
}

} // namespace unprojector::geometry
