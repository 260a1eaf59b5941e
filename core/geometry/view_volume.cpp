#include "core/geometry/view_volume.h"

#include "core/geometry/parallel_projection.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace unprojector::geometry {

std::array<EyePoint, 8> viewVolumeCorners(const Projection &projection)
{
    const ProjectionWindow w = projectionWindow(projection);
    const bool perspective = isPerspective(projection);
    const glm::dvec2 shear = shearOf(projection);
    std::array<EyePoint, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double distance = i & 4 ? w.farDistance : w.nearDistance;
        const double magnified = perspective ? distance / w.nearDistance : 1.0;
        EyePoint corner((i & 1 ? w.right : w.left) * magnified, (i & 2 ? w.top : w.bottom) * magnified, -distance);
        if (w.skew != 0.0)
            corner.x -= w.skew * corner.y;
        corner.x += shear.x * distance;
        corner.y += shear.y * distance;
        corners[i] = corner;
    }
    return corners;
}

Result<ViewVolumeMorph> viewVolumeMorph(const Projection &projection)
{
    const Result<glm::dmat4> clip = clipFromEye(projection);
    if (!clip)
        return clip.error();
    const ProjectionWindow w = projectionWindow(projection);
    const std::array<EyePoint, 8> corners = viewVolumeCorners(projection);
    EyePoint center;
    for (const EyePoint &corner : corners)
        center += (corner - EyePoint()) / 8.0;
    double radius = 0.0;
    for (const EyePoint &corner : corners)
        radius = std::max(radius, distance(corner, center));

    ViewVolumeMorph morph{glm::dmat4(1.0), glm::dmat4(1.0), *clip, 1.0, center, std::sqrt(3.0) / radius};
    for (int axis = 0; axis < 3; ++axis) {
        morph.unitFromEye[axis][axis] = morph.scale;
        morph.unitFromEye[3][axis] = -center[axis] * morph.scale;
    }
    morph.morphedFromNdc[0][0] = w.right > w.left ? 1.0 : -1.0;
    morph.morphedFromNdc[1][1] = w.top > w.bottom ? 1.0 : -1.0;
    morph.morphedFromNdc[2][2] = -1.0;
    if (isPerspective(projection))
        morph.weight = std::sqrt(w.nearDistance) * std::sqrt(w.farDistance);
    return morph;
}

glm::dmat4 morphedFromEye(const ViewVolumeMorph &morph, double t)
{
    return morph.unitFromEye * ((1.0 - t) * morph.weight) + morph.morphedFromNdc * morph.clipFromEye * t;
}

std::array<glm::dvec4, 6> closingPlanes(const ViewVolumeMorph &morph, double t)
{
    // clip.w +- clip.axis >= 0 with a slack of (1 - t) k. For a perspective's near plane this is
    //   z > near - (1 - t) k (f - n) / (2 f t), with z in front of the eye.
    // w is 0 only at z = -(1 - t) k / t.
    const glm::dmat4 rows = glm::transpose(morph.clipFromEye);
    const glm::dvec4 slack(0.0, 0.0, 0.0, (1.0 - t) * morph.weight);
    const auto plane = [&](int axis, double sign) { return (rows[3] + rows[axis] * sign) * t + slack; };
    return {plane(2, 1.0), plane(0, 1.0), plane(0, -1.0), plane(1, 1.0), plane(1, -1.0), plane(2, -1.0)};
}

glm::dvec4 planeInSource(const glm::dvec4 &plane, const glm::dmat4 &targetFromSource)
{
    return plane * targetFromSource; // a row vector times the matrix
}

} // namespace unprojector::geometry
