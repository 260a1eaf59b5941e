#include "core/geometry/framing.h"

#include "core/geometry/numbers.h"
#include "core/geometry/parallel_projection.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace unprojector::geometry {
namespace {

/// The smallest distance and size that count, as a share of the size of all that is shown. A needle
/// that points at the eye has no width to fill the view with.
constexpr double kLeastShare = 0.02;

} // namespace

Framing::Framing(const Setup &setup) : m_setup(setup), m_frame(eyeFrame(setup.camera()).value())
{
    const Projection &projection = setup.projection();
    const ProjectionWindow w = projectionWindow(projection);
    const double distance = isPerspective(projection) ? w.nearDistance : 1.0;
    const glm::dvec2 one(w.left / distance, w.bottom / distance), other(w.right / distance, w.top / distance);
    const glm::dvec2 middle = (one + other) / 2.0, half = glm::abs(other - one) / 2.0 * kFilled;
    m_low = middle - half;
    m_high = middle + half;
    m_shear = shearOf(projection);
    // Measured from the world's origin, not from the eye: the camera's present position does not
    // matter.
    const auto along = [](const WorldVector &axis) { return glm::dvec4(axis.coordinates(), 0.0); };
    const glm::dvec4 upward = along(m_frame.upward), forward = along(m_frame.forward);
    const glm::dvec4 side = along(m_frame.side) + w.skew * upward; // the window's x
    // A point seen at an edge: its lateral position is the edge's at its distance.
    const bool recedes = isPerspective(projection);
    m_planes[Side] = along(m_frame.side);
    m_planes[Upward] = upward;
    m_planes[Forward] = forward;
    m_planes[FromLeft] = side - forward * (recedes ? m_low.x : m_shear.x);
    m_planes[FromRight] = side - forward * (recedes ? m_high.x : m_shear.x);
    m_planes[FromBottom] = upward - forward * (recedes ? m_low.y : m_shear.y);
    m_planes[FromTop] = upward - forward * (recedes ? m_high.y : m_shear.y);
    m_lowest.fill(std::numeric_limits<double>::infinity());
    m_highest.fill(-std::numeric_limits<double>::infinity());
}

void Framing::add(const std::array<double, kMeasures> &measures)
{
    for (std::size_t k = 0; k < kMeasures; ++k) {
        m_lowest[k] = std::min(m_lowest[k], measures[k]);
        m_highest[k] = std::max(m_highest[k], measures[k]);
    }
}

void Framing::add(const WorldPoint &point)
{
    std::array<double, kMeasures> measures{};
    for (std::size_t k = 0; k < kMeasures; ++k)
        measures[k] = glm::dot(m_planes[k], glm::dvec4(point.coordinates(), 1.0));
    add(measures);
}

void Framing::add(const glm::dmat4 &worldFromSource, std::span<const glm::vec3> positions,
                  std::span<const std::uint32_t> indices)
{
    std::array<glm::dvec4, kMeasures> planes;
    for (std::size_t k = 0; k < kMeasures; ++k)
        planes[k] = m_planes[k] * worldFromSource; // a row times the matrix
    std::vector<std::uint8_t> isNamed(indices.empty() ? 0 : positions.size());
    for (const std::uint32_t index : indices)
        isNamed[index] = 1;
    // Most groups of neighbouring points contain none at an edge. Their bounding box tells so
    // without a test of each point.
    const auto reachesOut = [&](const glm::vec3 &lowest, const glm::vec3 &highest) {
        const glm::dvec3 middle = (glm::dvec3(lowest) + glm::dvec3(highest)) / 2.0;
        const glm::dvec3 half = glm::dvec3(highest) - middle;
        for (std::size_t k = 0; k < kMeasures; ++k) {
            const double measure = glm::dot(planes[k], glm::dvec4(middle, 1.0));
            const double reach = glm::dot(glm::abs(glm::dvec3(planes[k])), half);
            if (measure - reach < m_lowest[k] || measure + reach > m_highest[k])
                return true;
        }
        return false;
    };
    const auto addAt = [&](std::size_t i) {
        if (!isNamed.empty() && isNamed[i] == 0)
            return;
        const glm::dvec4 p(glm::dvec3(positions[i]), 1.0);
        std::array<double, kMeasures> measures{};
        for (std::size_t k = 0; k < kMeasures; ++k)
            measures[k] = glm::dot(planes[k], p);
        add(measures);
    };
    constexpr std::size_t kTogether = 256;
    // One point of each group puts the edges near their final position, so that few groups reach
    // out.
    for (std::size_t first = 0; first < positions.size(); first += kTogether)
        addAt(first);
    for (std::size_t first = 0; first < positions.size(); first += kTogether) {
        const std::size_t end = std::min(positions.size(), first + kTogether);
        glm::vec3 lowest = positions[first], highest = lowest;
        for (const glm::vec3 &p : positions.subspan(first, end - first)) {
            lowest = glm::min(lowest, p);
            highest = glm::max(highest, p);
        }
        if (!reachesOut(lowest, highest))
            continue;
        for (std::size_t i = first; i < end; ++i)
            addAt(i);
    }
}

double Framing::size() const
{
    return m_lowest[Forward] > m_highest[Forward] ? 0.0 : std::hypot(extent(Side), extent(Upward), extent(Forward));
}

Setup Framing::setup() const
{
    if (size() > 0.0)
        return framed();
    Framing surroundings = *this;
    const bool isEmpty = m_lowest[Forward] > m_highest[Forward];
    const WorldPoint middle = isEmpty ? WorldPoint()
                                      : WorldPoint() + m_frame.side * m_lowest[Side] + m_frame.upward * m_lowest[Upward]
                                            + m_frame.forward * m_lowest[Forward];
    for (const double x : {-0.5, 0.5}) {
        for (const double y : {-0.5, 0.5}) {
            for (const double z : {-0.5, 0.5})
                surroundings.add(middle + WorldVector(x, y, z));
        }
    }
    return surroundings.framed();
}

Setup Framing::framed() const
{
    Setup result = m_setup;
    LookAt &camera = result.camera();
    const double depth = middle(Forward); // the depth of what is shown and of the camera's new centre
    glm::dvec2 across(0.0);               // the eye's offset along the view's axes
    double along = 0.0;
    if (isPerspective(m_setup.projection())) {
        // The eye is where the points at opposite edges touch both of them. Any closer is too
        // close.
        along = std::min((m_lowest[FromLeft] - m_highest[FromRight]) / (m_high.x - m_low.x),
                         (m_lowest[FromBottom] - m_highest[FromTop]) / (m_high.y - m_low.y));
        along = std::min(along, m_lowest[Forward] - kLeastShare * size());
        // The other pair of edges leaves room on both sides; the eye divides it equally.
        across.x = (m_lowest[FromLeft] + m_low.x * along + m_highest[FromRight] + m_high.x * along) / 2.0;
        across.y = (m_lowest[FromBottom] + m_low.y * along + m_highest[FromTop] + m_high.y * along) / 2.0;
        across.x -= projectionWindow(m_setup.projection()).skew * across.y;
    } else {
        const double least = kLeastShare * size();
        const double scale = std::max(std::max(extent(FromLeft), least) / (m_high.x - m_low.x),
                                      std::max(extent(FromBottom), least) / (m_high.y - m_low.y));
        const glm::dvec2 windowMiddle = (m_low + m_high) / 2.0;
        Ortho &window = *boxOf(result.projection());
        const glm::dvec2 half = glm::dvec2(window.right - window.left, window.top - window.bottom) / 2.0 * scale;
        window.left = windowMiddle.x - half.x;
        window.right = windowMiddle.x + half.x;
        window.bottom = windowMiddle.y - half.y;
        window.top = windowMiddle.y + half.y;
        // The eye of a box moves too, so that a perspective that is selected later has the same
        // field of view as before.
        along = depth - distance(m_setup.camera().center, m_setup.camera().eye) * scale;
        across = glm::dvec2(middle(FromLeft), middle(FromBottom)) + m_shear * along - windowMiddle;
    }
    camera.eye = WorldPoint() + m_frame.side * across.x + m_frame.upward * across.y + m_frame.forward * along;
    camera.center = camera.eye + m_frame.forward * (depth - along);
    return result;
}

} // namespace unprojector::geometry
