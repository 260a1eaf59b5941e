#include "core/geometry/observer_camera.h"

#include "core/geometry/numbers.h"
#include "core/geometry/parallel_projection.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace unprojector::geometry {
namespace {

constexpr WorldVector kWorldUp{0.0, 1.0, 0.0};
constexpr double kElevationRadians = radiansFromDegrees(35.0);
constexpr double kAzimuthRadians = radiansFromDegrees(60.0); // from straight behind

/// Rounded to the largest power of ten up to `step`, without noise digits.
double roundedTo(double value, double step)
{
    const double power = std::floor(std::log10(step));
    const double scale = std::pow(10.0, std::abs(power));
    return power < 0.0 ? std::round(value * scale) / scale : std::round(value / scale) * scale;
}

} // namespace

glm::dmat4 matrixOf(const Placement &placement)
{
    glm::dmat4 matrix(glm::mat3_cast(placement.rotation) * placement.scale);
    matrix[3] = glm::dvec4(placement.position, 1.0);
    return matrix;
}

Placement between(const Placement &from, const Placement &to, double t)
{
    return {from.position * (1.0 - t) + to.position * t, glm::slerp(from.rotation, to.rotation, t),
            from.scale * std::pow(to.scale / from.scale, t)};
}

Placement placementOf(const EyeFrame &frame, const ViewVolumeMorph &morph)
{
    const glm::dmat3 axes(frame.side.coordinates(), frame.upward.coordinates(), (-frame.forward).coordinates());
    return {worldFromEye(frame, morph.center).coordinates(), glm::normalize(glm::quat_cast(axes)), 1.0 / morph.scale};
}

LookAt observerOf(const EyeFrame &watched, const WorldPoint &center)
{
    // The level direction ahead; for a camera that looks straight up or down, its up direction.
    WorldVector ahead = watched.forward - kWorldUp * dot(watched.forward, kWorldUp);
    constexpr double kSteep = 1e-3;
    if (length(ahead) < kSteep)
        ahead = watched.upward - kWorldUp * dot(watched.upward, kWorldUp);
    ahead = normalized(ahead);
    const WorldVector right = cross(ahead, kWorldUp);
    const WorldVector level = right * std::sin(kAzimuthRadians) - ahead * std::cos(kAzimuthRadians);
    const WorldVector offset = level * std::cos(kElevationRadians) + kWorldUp * std::sin(kElevationRadians);
    return {center + offset, center, kWorldUp};
}

ClipPlaneDrag::ClipPlaneDrag(const Projection &projection, ClipPlane plane, const EyePoint &grabbed,
                             const glm::dmat4 &widgetFromEye, const glm::dvec2 &pointer)
    : m_plane(plane)
{
    const double distance = -grabbed.z;
    const glm::dvec2 shear = shearOf(projection);
    const EyeVector direction =
        isPerspective(projection) ? (grabbed - EyePoint()) / distance : EyeVector(shear.x, shear.y, -1.0);
    m_direction = widgetFromEye * glm::dvec4(direction.coordinates(), 0.0);
    m_origin = widgetFromEye * glm::dvec4((grabbed - direction * distance).coordinates(), 1.0);
    const glm::dvec4 held = m_origin + m_direction * distance;
    const ProjectionWindow w = projectionWindow(projection);
    m_deepest = w.nearDistance + 1000.0 * (w.farDistance - w.nearDistance);
    m_isFacing = held.w > 0.0;
    if (!m_isFacing)
        return;
    m_offset = pointer - glm::dvec2(held) / held.w;
    m_rate = (glm::dvec2(m_direction) - glm::dvec2(held) / held.w * m_direction.w) / held.w;
}

std::optional<double> ClipPlaneDrag::distanceAt(const glm::dvec2 &pointer) const
{
    const double rate = glm::length(m_rate);
    if (!m_isFacing || !(rate > 0.0))
        return std::nullopt;
    const glm::dvec2 along = m_rate / rate;
    const double wanted = glm::dot(along, pointer - m_offset);
    const double distance = (wanted * m_origin.w - glm::dot(along, glm::dvec2(m_origin)))
                            / (glm::dot(along, glm::dvec2(m_direction)) - wanted * m_direction.w);
    if (!std::isfinite(distance) || !(m_origin.w + distance * m_direction.w > 0.0))
        return std::nullopt;
    return roundedTo(distance, 1.0 / rate);
}

std::optional<Projection> ClipPlaneDrag::projectionAt(const Projection &current, const glm::dvec2 &pointer) const
{
    std::optional<double> distance = distanceAt(pointer);
    if (!distance)
        return std::nullopt;
    ProjectionWindow w = projectionWindow(current);
    const double gap = 1e-3 * std::max(std::abs(w.nearDistance), std::abs(w.farDistance));
    if (m_plane == ClipPlane::Near) {
        w.nearDistance = std::min(*distance, w.farDistance - gap);
        if (isPerspective(current))
            w.nearDistance = std::max(w.nearDistance, w.farDistance * 1e-6);
    } else {
        w.farDistance = std::max(std::min(*distance, m_deepest), w.nearDistance + gap);
    }
    return withClipDistances(current, w.nearDistance, w.farDistance);
}

} // namespace unprojector::geometry
