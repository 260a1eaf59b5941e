#include "core/landmarks/measure.h"

#include "core/geometry/numbers.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace unprojector::landmarks {
using namespace geometry;

namespace {

using Code = MeasureError::Code;

std::optional<MeasureError> firstMissing(std::span<const Landmark *const> points)
{
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i]->isPlaced())
            return MeasureError{Code::Missing, i};
    }
    return std::nullopt;
}

/// Doesn't overflow, as the squares of coordinates of 1e200 do.
double lengthOf(const glm::dvec3 &v)
{
    return std::hypot(v.x, v.y, v.z);
}

glm::dvec3 placeOf(const Landmark &landmark)
{
    return landmark.world->coordinates();
}

/// The largest error of a point in any direction; 0 if unknown.
double reachOf(const Landmark &landmark)
{
    return landmark.uncertainty ? lengthOf(landmark.uncertainty->coordinates()) : 0.0;
}

/// A value and its error, summed over the points.
class Summed {
public:
    explicit Summed(double value) : m_measure{value, 0.0} {}

    /// @param gradient  of the value by the point's coordinates
    void add(const Landmark &landmark, const glm::dvec3 &gradient)
    {
        addIfKnown(landmark, [&](const glm::dvec3 &off) { return glm::dot(glm::abs(gradient), glm::abs(off)); });
    }
    /// Adds an error where no direction is the worst one.
    /// @param rate  of the value by the length of the point's movement
    void addAnyWay(const Landmark &landmark, double rate)
    {
        addIfKnown(landmark, [&](const glm::dvec3 &off) { return rate * lengthOf(off); });
    }
    /// @param most  largest possible error
    void limit(double most)
    {
        if (m_measure.error)
            m_measure.error = std::min(*m_measure.error, most);
    }
    Measure take() const { return m_measure; }

private:
    template <class Error>
    void addIfKnown(const Landmark &landmark, const Error &error)
    {
        if (!landmark.uncertainty)
            m_measure.error = std::nullopt;
        if (m_measure.error)
            *m_measure.error += error(landmark.uncertainty->coordinates());
    }

    Measure m_measure;
};

} // namespace

Measured distanceOf(const Landmark &a, const Landmark &b)
{
    const std::array points{&a, &b};
    return lengthAlong(points);
}

Measured lengthAlong(std::span<const Landmark *const> points)
{
    if (const auto missing = firstMissing(points))
        return *missing;
    if (points.size() < 2)
        return MeasureError{Code::TooFew, 0};
    // Each piece's direction, or none. A piece that may have no length grows with any movement of
    // its ends.
    std::vector<glm::dvec3> gradients(points.size(), glm::dvec3(0.0));
    std::vector<double> rates(points.size(), 0.0);
    double sum = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::dvec3 along = placeOf(*points[i]) - placeOf(*points[i - 1]);
        const double length = lengthOf(along);
        sum += length;
        if (length > reachOf(*points[i]) + reachOf(*points[i - 1])) {
            gradients[i] += along / length;
            gradients[i - 1] -= along / length;
        } else {
            rates[i] += 1.0;
            rates[i - 1] += 1.0;
        }
    }
    Summed measure(sum);
    for (std::size_t i = 0; i < points.size(); ++i) {
        measure.add(*points[i], gradients[i]);
        measure.addAnyWay(*points[i], rates[i]);
    }
    return measure.take();
}

Measured angleAt(const Landmark &vertex, const Landmark &a, const Landmark &c)
{
    const std::array points{&vertex, &a, &c};
    if (const auto missing = firstMissing(points))
        return *missing;
    const glm::dvec3 toA = placeOf(a) - placeOf(vertex), toC = placeOf(c) - placeOf(vertex);
    const double lengthA = lengthOf(toA), lengthC = lengthOf(toC);
    if (!(lengthA > 0.0))
        return MeasureError{Code::SamePoint, 1};
    if (!(lengthC > 0.0))
        return MeasureError{Code::SamePoint, 2};
    const glm::dvec3 ea = toA / lengthA, ec = toC / lengthC;
    const glm::dvec3 normal = glm::cross(ea, ec);
    const double sine = lengthOf(normal);
    const double angle = std::atan2(sine, glm::dot(ea, ec)), fromStraight = std::min(angle, kPi - angle);
    const double open = (reachOf(a) + reachOf(vertex)) / lengthA + (reachOf(c) + reachOf(vertex)) / lengthC;
    Summed measure(angle);
    if (fromStraight > open) {
        // These are perpendicular to each leg, in their plane, away from the other one.
        const glm::dvec3 n = normal / sine;
        const glm::dvec3 byA = glm::cross(ea, n) / lengthA, byC = glm::cross(n, ec) / lengthC;
        measure.add(a, byA);
        measure.add(c, byC);
        measure.add(vertex, -byA - byC);
    } else {
        measure.addAnyWay(a, 1.0 / lengthA);
        measure.addAnyWay(c, 1.0 / lengthC);
        measure.addAnyWay(vertex, 1.0 / lengthA + 1.0 / lengthC);
    }
    measure.limit(std::max(angle, kPi - angle));
    return measure.take();
}

Measured heightOver(const Landmark &a, const Landmark &b, const Landmark &c, const Landmark &landmark)
{
    const std::array points{&a, &b, &c, &landmark};
    if (const auto missing = firstMissing(points))
        return *missing;
    glm::dvec3 ab = placeOf(b) - placeOf(a), ac = placeOf(c) - placeOf(a), ap = placeOf(landmark) - placeOf(a);
    // In units of the longest leg, products do not overflow; a power of 2 rounds nothing.
    const double longestLeg = std::max({lengthOf(ab), lengthOf(ac), lengthOf(ap)});
    const double scale = longestLeg > 0.0 ? std::exp2(std::ilogb(longestLeg)) : 1.0;
    ab /= scale;
    ac /= scale;
    ap /= scale;
    const glm::dvec3 normal = glm::cross(ab, ac);
    const double twiceArea = lengthOf(normal);
    const double longest = std::max({lengthOf(ab), lengthOf(ac), lengthOf(ac - ab)});
    // The limit is the rounding error of coordinates far from 0, or the points' uncertainty.
    double size = 0.0;
    for (const Landmark *corner : {&a, &b, &c}) {
        const glm::dvec3 place = glm::abs(placeOf(*corner));
        size = std::max({size, place.x, place.y, place.z});
    }
    constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
    const double open = std::max(kRounding * size, reachOf(a) + reachOf(b) + reachOf(c)) / scale;
    if (!(twiceArea > open * longest)) // twice the area is the longest side times the least height
        return MeasureError{Code::NoPlane, 0};
    const glm::dvec3 n = normal / twiceArea;
    const double ofB = glm::dot(glm::cross(ap, ac), n) / twiceArea, ofC = glm::dot(glm::cross(ab, ap), n) / twiceArea;
    Summed measure(scale * glm::dot(n, ap));
    measure.add(landmark, n);
    measure.add(a, -(1.0 - ofB - ofC) * n);
    measure.add(b, -ofB * n);
    measure.add(c, -ofC * n);
    return measure.take();
}

} // namespace unprojector::landmarks
