#include "core/matrices/taken_apart.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::matrices {
namespace {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

/// Relative: what single precision and six printed digits leave of a right angle.
constexpr double kPrinted = 1e-5;

double largestEntry(const dmat4 &m)
{
    double largest = 0.0;
    for (int i = 0; i < 16; ++i)
        largest = std::max(largest, std::abs(m[i / 4][i % 4]));
    return largest;
}

dvec3 axesOfRow(const dmat4 &m, int row)
{
    return {m[0][row], m[1][row], m[2][row]};
}

} // namespace

std::optional<TakenApart> takenApart(const dmat4 &clipFromWorld)
{
    TakenApart result;
    result.w = glm::length(axesOfRow(clipFromWorld, 3));
    if (!(result.w > kPrinted * kPrinted * largestEntry(clipFromWorld)))
        return std::nullopt;
    const dmat4 m = clipFromWorld / result.w;
    const dvec3 x = axesOfRow(m, 0), y = axesOfRow(m, 1), z = axesOfRow(m, 2), f = axesOfRow(m, 3);
    const double zScale = glm::dot(z, f), xOffset = glm::dot(x, f), yOffset = glm::dot(y, f);
    const dvec3 side = x - xOffset * f, upward = y - yOffset * f;
    const double xScale = glm::length(side), height = glm::length(upward);
    if (!(xScale > 0.0 && height > 0.0) || std::abs(glm::dot(side, upward)) > 10.0 * kPrinted * xScale * height
        || glm::length(z - zScale * f) > kPrinted * std::max(glm::length(z), 1.0))
        return std::nullopt;

    const dvec3 s = side / xScale, u = glm::cross(s, f);
    const double yScale = glm::dot(u, upward);
    result.isMirrored = yScale < 0.0;
    const double forward = m[3][3];
    dmat4 &p = result.clipFromEye;
    p[0][0] = xScale;
    p[1][1] = yScale;
    p[2] = dvec4(-xOffset, -yOffset, -zScale, -1.0);
    p[3][2] = m[3][2] - zScale * forward;
    dmat4 &v = result.eyeFromWorld;
    for (int column = 0; column < 3; ++column)
        v[column] = dvec4(s[column], u[column], -f[column], 0.0);
    v[3] = dvec4((m[3][0] - xOffset * forward) / xScale, (m[3][1] - yOffset * forward) / yScale, -forward, 1.0);
    result.off = largestEntry(p * v * result.w - clipFromWorld) / largestEntry(clipFromWorld);
    if (!(result.off <= 10.0 * kPrinted))
        return std::nullopt;
    return result;
}

} // namespace unprojector::matrices
