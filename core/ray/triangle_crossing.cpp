#include "core/ray/triangle_crossing.h"

#include "core/geometry/numbers.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::ray {
using namespace geometry;
namespace {

/// Cross product of two sheared corners: its sign is the side of their edge on which the line
/// passes.
double edge(double bx, double by, double cx, double cy)
{
    return cx * by - cy * bx;
}

} // namespace

LineCrossing::LineCrossing(const glm::dvec3 &from, const glm::dvec3 &along) : m_from(from), m_along(along)
{
    const glm::dvec3 size = glm::abs(along);
    m_z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    m_x = (m_z + 1) % 3;
    m_y = (m_z + 2) % 3;
    m_shearX = along[m_x] / along[m_z];
    m_shearY = along[m_y] / along[m_z];
}

LineCrossing::Sheared LineCrossing::sheared(const glm::dvec3 &corner) const
{
    const glm::dvec3 p = corner - m_from;
    return {p[m_x] - m_shearX * p[m_z], p[m_y] - m_shearY * p[m_z], p[m_z],
            std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)})};
}

double LineCrossing::preciseEdge(const glm::dvec3 &b, const glm::dvec3 &c) const
{
    // Only the direction matters: with its longest coordinate between 1 and 2, the products stay in
    // range.
    const int exponent = std::ilogb(m_along[m_z]);
    const auto direction = [&](int axis) { return std::scalbn(m_along[axis], -exponent); };
    const double longest = direction(m_z);
    const auto shearedOf = [&](const glm::dvec3 &corner, int axis) {
        const auto from = [&](int k) { return DoubleDouble(corner[k]) - m_from[k]; };
        return from(axis) * longest - from(m_z) * direction(axis);
    };
    // All terms times `longest` squared, which is above 0.
    const DoubleDouble area = shearedOf(c, m_x) * shearedOf(b, m_y) - shearedOf(c, m_y) * shearedOf(b, m_x);
    return (area / (DoubleDouble(longest) * longest)).value;
}

glm::dvec3 LineCrossing::preciseBarycentric(const glm::dvec3 &a, const glm::dvec3 &b, const glm::dvec3 &c) const
{
    const glm::dvec3 edges(preciseEdge(b, c), preciseEdge(c, a), preciseEdge(a, b));
    return edges / (edges.x + edges.y + edges.z);
}

std::optional<Crossing> LineCrossing::with(const glm::dvec3 &a, const glm::dvec3 &b, const glm::dvec3 &c) const
{
    const Sheared p = sheared(a), q = sheared(b), r = sheared(c);
    double u = edge(q.x, q.y, r.x, r.y);
    double v = edge(r.x, r.y, p.x, p.y);
    double w = edge(p.x, p.y, q.x, q.y);
    // The rounding error of x and y is a few roundings of `size`; this bounds the error of an edge.
    const double size = std::max({p.size, q.size, r.size});
    const double reach =
        std::max({std::abs(p.x), std::abs(p.y), std::abs(q.x), std::abs(q.y), std::abs(r.x), std::abs(r.y)});
    constexpr double kRounding = 0x1p-53;
    const double unsure = 64.0 * kRounding * size * (reach + 4.0 * kRounding * size);
    if (std::max({u, v, w}) > unsure && std::min({u, v, w}) < -unsure)
        return std::nullopt;
    if (std::abs(u) <= unsure)
        u = preciseEdge(b, c);
    if (std::abs(v) <= unsure)
        v = preciseEdge(c, a);
    if (std::abs(w) <= unsure)
        w = preciseEdge(a, b);
    const bool isInside = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
    const double area = u + v + w;
    if (!isInside || area == 0.0)
        return std::nullopt;
    const glm::dvec3 barycentric(u / area, v / area, w / area);
    const double depth = barycentric.x * p.z + barycentric.y * q.z + barycentric.z * r.z;
    return Crossing{depth / m_along[m_z], barycentric};
}

} // namespace unprojector::ray
