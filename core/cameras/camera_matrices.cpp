#include "core/cameras/camera_matrices.h"

#include "core/cameras/reader_parts.h"
#include "core/pipeline/printed_digits.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace unprojector::cameras {

glm::dmat3 rotationOf(const glm::dvec3 &axis)
{
    const double angle = glm::length(axis);
    if (angle == 0.0)
        return glm::dmat3(1.0);
    const glm::dvec3 n = axis / angle;
    const double half = std::sin(angle / 2.0), s = std::sin(angle), oneMinusCosine = 2.0 * half * half;
    const glm::dmat3 cross(0.0, n.z, -n.y, -n.z, 0.0, n.x, n.y, -n.x, 0.0);
    return glm::dmat3(1.0) + s * cross + oneMinusCosine * (cross * cross);
}

bool areOrthonormal(const glm::dmat3 &axes)
{
    constexpr double kPrinted = 0.02;
    return pipeline::largestDifference(axes * glm::transpose(axes), glm::dmat3(1.0)) < kPrinted;
}

std::optional<CameraParts> partsOf(std::span<const double> p)
{
    glm::dvec3 rows[3];
    for (std::size_t i = 0; i < 3; ++i)
        rows[i] = {p[4 * i], p[4 * i + 1], p[4 * i + 2]};
    glm::dvec3 last{p[3], p[7], p[11]};
    const double determinant = glm::dot(rows[0], glm::cross(rows[1], rows[2])), size = glm::length(rows[2]);
    const double scale = determinant < 0.0 ? -size : size;
    if (!(size > 0.0 && std::isfinite(size)) || determinant == 0.0)
        return std::nullopt;
    for (glm::dvec3 &row : rows)
        row /= scale;
    last /= scale;
    // Gram and Schmidt from the last row up: what a row has along the rows below it is K's.
    CameraParts parts;
    Intrinsics &k = parts.intrinsics;
    const glm::dvec3 r2 = rows[2];
    k.cy = glm::dot(rows[1], r2);
    const glm::dvec3 up = rows[1] - k.cy * r2;
    k.fy = glm::length(up);
    const glm::dvec3 r1 = up / k.fy;
    k.cx = glm::dot(rows[0], r2);
    k.skew = glm::dot(rows[0], r1);
    const glm::dvec3 right = rows[0] - k.cx * r2 - k.skew * r1;
    k.fx = glm::length(right);
    const glm::dvec3 r0 = right / k.fx;
    if (!(k.fx > 0.0 && k.fy > 0.0 && std::isfinite(k.fx) && std::isfinite(k.fy)))
        return std::nullopt;
    const double z = last.z, y = (last.y - k.cy * z) / k.fy, x = (last.x - k.cx * z - k.skew * y) / k.fx;
    parts.cameraFromWorld = rigid(glm::transpose(glm::dmat3(r0, r1, r2)), {x, y, z});
    return parts;
}

} // namespace unprojector::cameras
