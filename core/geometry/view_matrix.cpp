#include "core/geometry/view_matrix.h"

#include "core/geometry/finite.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::geometry {
namespace {

/// The tolerance for a rigid matrix. A rotation in single precision, printed with six digits, is
/// off by 2e-6. A larger deviation is assumed to be intended.
constexpr double kRigid = 1e-5;

/// The tolerance for the last row (0, 0, 0, w), relative to the translation. Elimination with full
/// pivoting leaves at most the rounding error of its precision, 1.4e-16 in doubles. Cofactors and
/// partial pivoting leave zeros.
constexpr double kRounding = 0x1p-50;

Error notRigid(double value, int column, int row)
{
    return {ErrorCode::ViewNotRigid, value, double(column * 4 + row)};
}

} // namespace

Result<double> axesOff(const glm::dmat4 &m)
{
    if (const Check finite = checkFinite(m); !finite)
        return finite.error();
    const double w = m[3][3];
    if (!(w > 0.0))
        return notRigid(w, 3, 3);
    const glm::dmat3 axes = glm::dmat3(m) / w;
    const glm::dmat3 off = axes * glm::transpose(axes) - glm::dmat3(1.0);
    double largest = 0.0;
    Error error{ErrorCode::ViewNotRigid};
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row <= column; ++row) {
            const double entry = off[column][row];
            if (!std::isfinite(entry))
                return notRigid(entry, column, row);
            if (std::abs(entry) <= largest)
                continue;
            largest = std::abs(entry);
            error = notRigid(entry, column, row);
        }
    }
    if (!(largest <= kRigid))
        return error;
    const glm::dvec3 translation = glm::dvec3(m[3]) / w;
    const double reach = std::max({1.0, std::abs(translation.x), std::abs(translation.y), std::abs(translation.z)});
    for (int column = 0; column < 3; ++column) {
        if (!(std::abs(m[column][3]) / w * reach <= 4.0 * std::max(largest, kRounding)))
            return notRigid(m[column][3], column, 3);
    }
    return largest;
}

Result<PreciseAxes> preciseAxes(const glm::dmat4 &m)
{
    if (const Result<double> off = axesOff(m); !off)
        return off.error();
    const auto row = [&](int i) { return DoubleDouble3{m[0][i], m[1][i], m[2][i]}; };
    PreciseAxes axes{{}, cross(row(1), row(2)), cross(row(2), row(0)), cross(row(0), row(1))};
    const DoubleDouble determinant = dot(row(0), axes.x);
    for (std::size_t k = 0; k < 3; ++k) {
        axes.origin[k] = -(m[3][0] * axes.x[k] + m[3][1] * axes.y[k] + m[3][2] * axes.z[k]) / determinant;
        for (DoubleDouble3 *axis : {&axes.x, &axes.y, &axes.z})
            (*axis)[k] = m[3][3] * (*axis)[k] / determinant;
    }
    return axes;
}

Result<PrecisePoint<WorldSpace>> preciseWorldFromEye(const glm::dmat4 &m, const PrecisePoint<EyeSpace> &point)
{
    const Result<PreciseAxes> axes = preciseAxes(m);
    if (!axes)
        return axes.error();
    const auto component = [&](std::size_t k) {
        const DoubleDouble turned = point.x * axes->x[k] + point.y * axes->y[k] + point.z * axes->z[k];
        return axes->origin[k] + turned;
    };
    const PrecisePoint<WorldSpace> world(component(0), component(1), component(2));
    if (!isFinite(world.rounded()))
        return Error{ErrorCode::PointAtInfinity};
    return world;
}

Result<WorldPoint> worldFromEye(const glm::dmat4 &m, const PrecisePoint<EyeSpace> &point)
{
    const Result<PrecisePoint<WorldSpace>> world = preciseWorldFromEye(m, point);
    if (!world)
        return world.error();
    return world->rounded();
}

Result<LookAt> lookAtFrom(const glm::dmat4 &eyeFromWorld, double distance)
{
    const Result<WorldPoint> eye = worldFromEye(eyeFromWorld, EyePoint());
    if (!eye)
        return eye.error();
    const glm::dmat3 rows = glm::transpose(glm::dmat3(eyeFromWorld)) / eyeFromWorld[3][3];
    if (glm::determinant(rows) < 0.0)
        return Error{ErrorCode::ViewMirrored};
    return LookAt{*eye, *eye - WorldVector(rows[2]) * distance, WorldVector(rows[1])};
}

} // namespace unprojector::geometry
