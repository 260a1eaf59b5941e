#include "core/unproject/depth_error.h"

#include "core/geometry/proportions.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace unprojector::unproject {
using namespace geometry;

namespace {

/// Half the spacing of floats, relative.
constexpr double kFloatRounding = 0x1p-24;

using Corners = std::array<glm::dvec3, 3>; ///< window coordinates

/// The slope of a surface that is inclined by 80 degrees to the plane of the view, at a distance.
DepthSlope steepSlope(const Setup &setup, double depthOfUnit, double distance)
{
    const double tangent = std::tan(radiansFromDegrees(80.0));
    const glm::dvec2 footprint = pixelFootprint(setup, distance);
    return {depthOfUnit * footprint.x * tangent, depthOfUnit * footprint.y * tangent};
}

/// The change of the window depth per unit of distance in front of the eye: |dd/dz|.
double depthOfUnitDistance(const Setup &setup, double distance)
{
    const ProjectionWindow w = projectionWindow(setup.projection());
    const double n = w.nearDistance, f = w.farDistance;
    const double range = std::abs(setup.depthRange.atFar - setup.depthRange.atNear);
    return isPerspective(setup.projection()) ? range * f * n / ((f - n) * distance * distance) : range / (f - n);
}

/// The slope of a triangle. Its depth is a x + b y + c in NDC, and so a x + b y + c w in clip
/// space, wherever its corners lie: also behind the eye.
/// @return nothing for a triangle that is seen edge on
std::optional<DepthSlope> slopeOf(const Setup &setup, const std::array<glm::dvec4, 3> &clip)
{
    glm::dmat3 rows(0.0);
    glm::dvec3 depths;
    for (int k = 0; k < 3; ++k) {
        const glm::dvec4 &corner = clip[static_cast<std::size_t>(k)];
        const double size = std::max({std::abs(corner.x), std::abs(corner.y), std::abs(corner.w)});
        rows[0][k] = corner.x / size;
        rows[1][k] = corner.y / size;
        rows[2][k] = corner.w / size;
        depths[k] = corner.z / size;
    }
    const glm::dvec3 plane = glm::inverse(rows) * depths;
    if (!std::isfinite(plane.x) || !std::isfinite(plane.y))
        return std::nullopt;
    const double range = std::abs(setup.depthRange.atFar - setup.depthRange.atNear);
    return DepthSlope{std::abs(plane.x) * range / setup.viewport.width,
                      std::abs(plane.y) * range / setup.viewport.height};
}

/// The depth error at a position due to rounding of a triangle's corner differences, their products
/// and its area. The plane is anchored at an unknown corner, and the error grows with the distance
/// from it.
///
///   dd/dx = (d01 y20 - d20 y01) / A, A = x01 y20 - x20 y01
///
/// The products of a thin triangle are far larger than their difference.
double thinTriangleError(const Corners &corners, const glm::dvec3 &place)
{
    double worst = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 &hung = corners[k];
        const glm::dvec3 a = glm::abs(hung - corners[(k + 1) % 3]), b = glm::abs(corners[(k + 2) % 3] - hung);
        const glm::dvec3 way = glm::abs(place - hung);
        const glm::dvec3 products(a.z * b.y + b.z * a.y, b.z * a.x + a.z * b.x, a.x * b.y + b.x * a.y);
        worst = std::max(worst, glm::dot(products, way));
    }
    const glm::dvec3 a = corners[1] - corners[0], b = corners[2] - corners[0];
    return kFloatRounding * worst / std::abs(a.x * b.y - a.y * b.x);
}

/// The distance from a position to the nearest edge of a triangle, pixels.
double edgeDistance(const Corners &corners, const glm::dvec3 &place)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec2 along(corners[(k + 1) % 3] - corners[k]), way(place - corners[k]);
        nearest = std::min(nearest, std::abs(along.x * way.y - along.y * way.x) / glm::length(along));
    }
    return nearest;
}

} // namespace

double DepthFormat::halfStep(double depth) const
{
    if (!isFloat)
        return 0.5 / (std::ldexp(1.0, bits) - 1.0);
    const double size = std::max(std::abs(depth), double(std::numeric_limits<float>::min()));
    return std::ldexp(1.0, std::ilogb(size) - 24);
}

double DepthFormat::kept(double depth) const
{
    if (isFloat)
        return static_cast<double>(static_cast<float>(depth));
    const double steps = std::ldexp(1.0, bits) - 1.0;
    return std::round(depth * steps) / steps;
}

DepthErrors::DepthErrors(const Setup &setup, const glm::dmat4 &worldFromVertices, bool areVerticesRounded)
    : m_setup(setup), m_clipFromVertices(clipFromWorld(setup).value() * worldFromVertices),
      m_verticesFromWorld(glm::inverse(worldFromVertices)), m_vertexRoundings(areVerticesRounded ? 2.0 : 1.0)
{
}

DepthError DepthErrors::at(const WindowPoint &window, const WorldPoint &world, const DepthSample &sample,
                           const std::optional<std::array<glm::dvec3, 3>> &triangle, bool isPoint) const
{
    const Viewport &viewport = m_setup.viewport;
    const double range = std::abs(m_setup.depthRange.atFar - m_setup.depthRange.atNear);
    const glm::dvec4 place = m_verticesFromWorld * glm::dvec4(world.coordinates(), 1.0);
    const glm::dvec4 clip = m_clipFromVertices * place;

    // The vertices' error, carried to the point between them.
    glm::dvec4 sums(0.0);
    for (int column = 0; column < 4; ++column)
        sums += glm::abs(m_clipFromVertices[column] * place[column]);
    const glm::dvec3 ndc = glm::abs(glm::dvec3(clip) / clip.w);
    const glm::dvec3 vertices =
        m_vertexRoundings * kFloatRounding * (glm::dvec3(sums) + ndc * sums.w) / std::abs(clip.w);

    std::optional<DepthSlope> slope = sample.slope;
    std::optional<Corners> corners;
    if (triangle) {
        std::array<glm::dvec4, 3> clipCorners;
        Corners windowCorners;
        bool isBeforeTheEye = true;
        for (std::size_t k = 0; k < 3; ++k) {
            clipCorners[k] = m_clipFromVertices * glm::dvec4((*triangle)[k], 1.0);
            const glm::dvec4 &corner = clipCorners[k];
            isBeforeTheEye = isBeforeTheEye && corner.w > 0.0;
            windowCorners[k] =
                windowFromNdc(viewport, m_setup.depthRange, NdcPoint(glm::dvec3(corner) / corner.w)).coordinates();
        }
        if (const std::optional<DepthSlope> known = slopeOf(m_setup, clipCorners)) {
            slope = known;
            if (isBeforeTheEye) // otherwise it is clipped, and its corners are others
                corners = windowCorners;
        }
    }
    if (!slope && !isPoint) {
        const double distance = isPerspective(m_setup.projection()) ? std::abs(clip.w) : 1.0;
        slope = steepSlope(m_setup, depthOfUnitDistance(m_setup, distance), distance);
    }

    DepthError error{sample.format.halfStep(window.z), 0.0};
    constexpr double kDepthRoundings = 2.0, kInterpolationRoundings = 2.0;
    error.drawing = vertices.z * range / 2.0 + kDepthRoundings * kFloatRounding * std::abs(window.z);
    if (isPoint)
        return error;
    const auto interpolation = [](double pixels) {
        return kInterpolationRoundings * kFloatRounding * std::abs(pixels);
    };
    const double shiftX = vertices.x * viewport.width / 2.0 + interpolation(window.x) + sample.cornerShiftPixels;
    const double shiftY = vertices.y * viewport.height / 2.0 + interpolation(window.y) + sample.cornerShiftPixels;
    error.drawing += slope->perPixelX * shiftX + slope->perPixelY * shiftY;
    if (corners) {
        error.drawing += thinTriangleError(*corners, window.coordinates());
        if (edgeDistance(*corners, window.coordinates()) < std::sqrt(2.0) * kCornerShiftPixels) {
            const DepthSlope &beside = sample.slope.value_or(*slope);
            error.drawing +=
                kCornerShiftPixels * (slope->perPixelX + slope->perPixelY + beside.perPixelX + beside.perPixelY);
        }
    }
    return error;
}

DepthError depthErrorAt(const Setup &setup, const WindowPoint &window, const WorldPoint &world,
                        const DepthSample &sample, const DrawnSurface &surface)
{
    return DepthErrors(setup, surface.worldFromVertices, surface.areVerticesRounded)
        .at(window, world, sample, surface.triangle, surface.isPoint);
}

} // namespace unprojector::unproject
