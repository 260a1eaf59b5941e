#include "core/view_matrix.h"

#include "core/exact_rounding.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector {
namespace {

constexpr double kRigid = 1e-5;

/// target - R p - t with what the roundings drop, so that corrections go on below the last place.
glm::dvec3 residual(const glm::dmat4 &m, const glm::dvec3 &target, const glm::dvec3 &p)
{
    glm::dvec3 result;
    for (int row = 0; row < 3; ++row) {
        double sum = target[row], dropped = lostBySum(sum, -m[3][row]);
        sum -= m[3][row];
        for (int column = 0; column < 3; ++column) {
            const double product = m[column][row] * p[column];
            dropped -= lostByProduct(m[column][row], p[column]);
            dropped += lostBySum(sum, -product);
            sum -= product;
        }
        result[row] = sum + dropped;
    }
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

Result<WorldPoint> worldFromEye(const glm::dmat4 &eyeFromWorld, const EyePoint &point)
{
    if (const Result<double> off = axesOff(eyeFromWorld); !off)
        return off.error();
    const glm::dmat3 worldFromEyeAxes = glm::transpose(glm::dmat3(eyeFromWorld));
    glm::dvec3 p(0.0);
    for (int i = 0; i < 3; ++i)
        p += worldFromEyeAxes * residual(eyeFromWorld, point.coordinates(), p);
    if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)))
        return Error{ErrorCode::PointAtInfinity};
    return WorldPoint(p);
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

} // namespace unprojector
