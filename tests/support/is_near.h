#pragma once

#include <QtGlobal>

#include <glm/vec3.hpp>

#include <cmath>

/// Returns whether two numbers differ by at most the tolerance; prints them otherwise. NaN is near
/// nothing.
inline bool isNear(double a, double b, double tolerance)
{
    if (std::abs(a - b) <= tolerance)
        return true;
    qWarning("%.17g is not %.17g", a, b);
    return false;
}

/// The same for each coordinate.
inline bool isNear(const glm::dvec3 &a, const glm::dvec3 &b, double tolerance)
{
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(a[axis] - b[axis]) <= tolerance)) {
            qWarning("(%.17g, %.17g, %.17g) is not (%.17g, %.17g, %.17g)", a.x, a.y, a.z, b.x, b.y, b.z);
            return false;
        }
    }
    return true;
}

/// Returns whether two numbers differ by at most the tolerance times the second; prints them
/// otherwise.
inline bool isRelativelyNear(double a, double b, double tolerance)
{
    if (std::abs(a - b) <= tolerance * std::abs(b))
        return true;
    qWarning("%.17g is not %.17g", a, b);
    return false;
}
