#include "core/pipeline/decomposition.h"

#include "core/base/translation.h"
#include "core/geometry/condition_number.h"
#include "core/geometry/matrix_projection.h"
#include "core/pipeline/matrix_format.h"
#include "core/pipeline/printed_digits.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::pipeline {
namespace {

using geometry::largestEntry;
using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

/// The relative error of a right angle in single precision or with six printed digits.
constexpr double kPrinted = 1e-5;

dvec3 axesOfRow(const dmat4 &m, int row)
{
    return dvec3(glm::row(m, row));
}

/// Sets the view and the residual.
/// @param shift     the view's translation
/// @param rounding  what the last printed decimal explains
/// @return nothing if the product is not the given one
std::optional<Decomposition> completed(Decomposition apart, const glm::dmat3 &worldFromEye, const dvec3 &shift,
                                       const dmat4 &clipFromWorld, double rounding)
{
    apart.eyeFromWorld = dmat4(glm::transpose(worldFromEye));
    apart.eyeFromWorld[3] = dvec4(shift, 1.0);
    apart.residual =
        largestEntry(apart.clipFromEye * apart.eyeFromWorld * apart.w - clipFromWorld) / largestEntry(clipFromWorld);
    if (!(apart.residual <= std::max(10.0 * kPrinted, rounding)))
        return std::nullopt;
    apart.clipFromEye = withoutNegativeZeros(apart.clipFromEye);
    apart.eyeFromWorld = withoutNegativeZeros(apart.eyeFromWorld);
    return apart;
}

/// @param sign  of w in front of the eye
std::optional<Decomposition> decomposed(const dmat4 &clipFromWorld, double sign)
{
    Decomposition result;
    const double length = glm::length(axesOfRow(clipFromWorld, 3));
    if (!(length > kPrinted * kPrinted * largestEntry(clipFromWorld)))
        return std::nullopt;
    result.w = sign * length;
    // The rounding of the last decimal affects all four rows, in angles and lengths; hence the
    // margin.
    const double rounding = 4.0 * printedUnit(clipFromWorld) / length, tolerance = std::max(kPrinted, rounding);
    const dmat4 m = clipFromWorld / result.w;
    const dvec3 x = axesOfRow(m, 0), y = axesOfRow(m, 1), z = axesOfRow(m, 2), f = axesOfRow(m, 3);
    const double zScale = glm::dot(z, f), xOffset = glm::dot(x, f), yOffset = glm::dot(y, f);
    const dvec3 side = x - xOffset * f, upward = y - yOffset * f;
    const double xScale = glm::length(side), height = glm::length(upward);
    const double skew = std::max(10.0 * kPrinted * xScale * height, rounding * (xScale + height));
    if (!(xScale > 0.0 && height > 0.0) || std::abs(glm::dot(side, upward)) > skew
        || glm::length(z - zScale * f) > tolerance * std::max(glm::length(z), 1.0))
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
    const dvec3 shift((m[3][0] - xOffset * forward) / xScale, (m[3][1] - yOffset * forward) / yScale, -forward);
    return completed(result, {s, u, -f}, shift, clipFromWorld, rounding);
}

/// Decomposes a matrix whose last row is 0 0 0 w.
std::optional<Decomposition> boxTakenApart(const dmat4 &clipFromWorld)
{
    Decomposition result;
    result.isBox = true;
    result.w = clipFromWorld[3][3];
    if (!(std::abs(result.w) > 0.0)
        || glm::length(axesOfRow(clipFromWorld, 3)) > kPrinted * kPrinted * std::abs(result.w))
        return std::nullopt;
    const dmat4 m = clipFromWorld / result.w;
    const dvec3 x = axesOfRow(m, 0), y = axesOfRow(m, 1), z = axesOfRow(m, 2);
    const double xScale = glm::length(x), height = glm::length(y), depth = glm::length(z);
    const double rounding = 4.0 * printedUnit(clipFromWorld) / std::abs(result.w);
    const auto arePerpendicular = [rounding](const dvec3 &a, double lengthOfA, const dvec3 &b, double lengthOfB) {
        return std::abs(glm::dot(a, b))
               <= std::max(10.0 * kPrinted * lengthOfA * lengthOfB, rounding * (lengthOfA + lengthOfB));
    };
    if (!(xScale > 0.0 && height > 0.0 && depth > 0.0) || !arePerpendicular(x, xScale, y, height)
        || !arePerpendicular(x, xScale, z, depth) || !arePerpendicular(y, height, z, depth))
        return std::nullopt;
    const dvec3 s = x / xScale, b = -glm::normalize(z - glm::dot(z, s) * s), u = glm::cross(b, s);
    const double yScale = glm::dot(u, y);
    result.isMirrored = yScale < 0.0;
    dmat4 &p = result.clipFromEye;
    p = dmat4(1.0);
    p[0][0] = xScale;
    p[1][1] = yScale;
    p[2][2] = -depth;
    p[3][2] = -1.0;
    const dvec3 shift(m[3][0] / xScale, m[3][1] / yScale, -(m[3][2] + 1.0) / depth);
    return completed(result, {s, u, b}, shift, clipFromWorld, rounding);
}

} // namespace

std::optional<Decomposition> decomposed(const dmat4 &clipFromWorld)
{
    if (const auto box = boxTakenApart(clipFromWorld))
        return box;
    const auto apart = decomposed(clipFromWorld, 1.0);
    if (!apart)
        return std::nullopt;
    const auto isProjection = [](const Decomposition &one) {
        const auto form = geometry::recognised({one.clipFromEye, std::nullopt});
        return form && !form->negated;
    };
    if (isProjection(*apart))
        return apart;
    const auto negated = decomposed(clipFromWorld, -1.0);
    return negated && isProjection(*negated) ? negated : apart;
}

std::string decompositionText(const Decomposition &apart)
{
    return base::tr(apart.isBox ? "decomposed into projection and view, with a residual of %1 of its largest entry; an "
                                  "orthographic eye may be anywhere along the view: it is put on the near plane"
                                : "decomposed into projection and view, with a residual of %1 of its largest entry",
                    numberText(apart.residual, Digits::Double, 1));
}

} // namespace unprojector::pipeline
