#include "core/ray/point_cloud.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace unprojector::ray {
using namespace mesh;

namespace {

glm::dvec4 rowOf(const glm::dmat4 &m, int row)
{
    return {m[0][row], m[1][row], m[2][row], m[3][row]};
}

double at(const glm::dvec4 &plane, const glm::dvec3 &point)
{
    return glm::dot(glm::dvec3(plane), point) + plane.w;
}

/// A query, prepared for many boxes and points.
class Reach {
public:
    explicit Reach(const PointAim &aim) : m_aim(aim)
    {
        const glm::dmat4 &m = aim.clipFromObject;
        const glm::dvec4 w = rowOf(m, 3);
        const glm::dvec2 reach = aim.ndcOfPixel * aim.pixels;
        for (int axis = 0; axis < 2; ++axis) {
            m_sides[std::size_t(axis) * 2] = rowOf(m, axis) - w * (aim.position[axis] - reach[axis]);
            m_sides[std::size_t(axis) * 2 + 1] = w * (aim.position[axis] + reach[axis]) - rowOf(m, axis);
        }
        // A perspective's depth is w. In a box w is 1 everywhere, and z is the depth.
        m_depth = glm::dvec3(w) == glm::dvec3(0.0) ? rowOf(m, 2) : w;
        m_start = at(m_depth, aim.ray.from.coordinates());
        m_rise = glm::dot(glm::dvec3(m_depth), aim.ray.along.coordinates());
        m_widthOfW = 2.0 * reach.x / glm::length(glm::dvec3(rowOf(m, 0))) / glm::length(aim.ray.along.coordinates());
        m_w = w;
    }

    /// The t of the first depth at which a box may hold a candidate; infinity: none.
    double begin(const glm::dvec3 &center, const glm::dvec3 &half) const
    {
        for (const glm::dvec4 &side : m_sides) {
            if (at(side, center) + glm::dot(glm::abs(glm::dvec3(side)), half) < 0.0)
                return std::numeric_limits<double>::infinity();
        }
        const double middle = tAt(center), spread = glm::dot(glm::abs(glm::dvec3(m_depth)), half) / std::abs(m_rise);
        return middle - spread <= m_aim.ray.high && middle + spread >= m_aim.ray.low
                   ? middle - spread
                   : std::numeric_limits<double>::infinity();
    }

    double tAt(const glm::dvec3 &point) const { return (at(m_depth, point) - m_start) / m_rise; }

    /// The offset from the position in the view, pixels; infinity for a point that does not count.
    glm::dvec2 pixelsOff(const glm::dvec3 &point, double t) const
    {
        constexpr glm::dvec2 kNone(std::numeric_limits<double>::infinity());
        const glm::dvec4 clip = m_aim.clipFromObject * glm::dvec4(point, 1.0);
        if (!(clip.w > 0.0 && t >= m_aim.ray.low && t <= m_aim.ray.high))
            return kNone;
        for (const glm::dvec4 &plane : m_aim.clipPlanes) {
            if (at(plane, point) < 0.0)
                return kNone;
        }
        const glm::dvec2 off = (glm::dvec2(clip) / clip.w - m_aim.position) / m_aim.ndcOfPixel;
        return glm::dot(off, off) <= m_aim.pixels * m_aim.pixels ? off : kNone;
    }
    /// Returns whether the position is on the dot of a point.
    /// @param off  pixelsOff of it
    bool isOnDot(const glm::dvec2 &off) const
    {
        return std::max(std::abs(off.x), std::abs(off.y)) <= m_aim.dotPixels / 2.0;
    }

    /// The largest difference in t between the front points.
    double frontDepth(const glm::dvec3 &first) const
    {
        constexpr double kWidths = 4.0;
        return kWidths * m_widthOfW * at(m_w, first);
    }

private:
    const PointAim &m_aim;
    std::array<glm::dvec4, 4> m_sides; ///< planes, positive inside
    glm::dvec4 m_depth, m_w;
    double m_start, m_rise;
    double m_widthOfW; ///< the width of the reach at w = 1, in t
};

} // namespace

PointCloud::PointCloud(const Model &model, const UnitSpace &space, const Progress &progress)
    : m_model(model), m_space(space), m_points(model.meshes, &Mesh::pointCount),
      m_vertices(model.meshes, [](const Mesh &mesh) { return mesh.positions.size(); })
{
    std::vector<BoxTree::Box> boxes;
    boxes.reserve(m_points.count());
    for (const Mesh &mesh : model.meshes) {
        for (std::size_t i = 0; i < mesh.pointCount(); ++i) {
            const glm::vec3 place = space.at(mesh.origin, mesh.positions[mesh.vertexAt(i)]);
            boxes.push_back({place - UnitSpace::kMargin, place + UnitSpace::kMargin});
        }
    }
    constexpr std::size_t kMostInLeaf = 8;
    m_tree = BoxTree::build(boxes, kMostInLeaf, progress);
}

std::optional<PointHit> PointCloud::nearest(const PointAim &aim) const
{
    const Reach reach(aim);
    double high = aim.ray.high;
    const auto entry = [&](const glm::vec3 &lowest, const glm::vec3 &highest) {
        const glm::dvec3 low(lowest), top(highest);
        const glm::dvec3 center = m_space.center() + (low + top) / (2.0 * m_space.scale());
        // Rounding may make t too large: the search compares it in double again.
        const double begin = reach.begin(center, (top - low) / (2.0 * m_space.scale()));
        return begin <= high ? static_cast<float>(begin) : std::numeric_limits<float>::infinity();
    };
    const auto search = [&](const auto &take) {
        m_tree.search(
            entry, [] { return std::numeric_limits<float>::max(); },
            [&](std::uint32_t number) {
                const ElementNumbers::Place place = m_points.place(number);
                const Mesh &mesh = m_model.meshes[place.mesh];
                const std::size_t vertex = mesh.vertexAt(place.element);
                const glm::dvec3 point = mesh.position(vertex);
                const double t = reach.tAt(point);
                if (t > high)
                    return;
                const glm::dvec2 off = reach.pixelsOff(point, t);
                if (std::isfinite(off.x))
                    take(m_vertices.of(place.mesh, static_cast<std::uint32_t>(vertex)), point, t, off);
            });
    };
    std::optional<PointHit> drawn;
    search([&](std::uint32_t vertex, const glm::dvec3 &, double t, const glm::dvec2 &off) {
        if (!reach.isOnDot(off) || (drawn && t == drawn->t && vertex > drawn->vertex))
            return;
        high = t;
        drawn = PointHit{vertex, t, true};
    });
    if (drawn)
        return drawn;
    std::optional<glm::dvec3> first;
    search([&](std::uint32_t, const glm::dvec3 &point, double t, const glm::dvec2 &) {
        high = t;
        first = point;
    });
    if (!first)
        return std::nullopt;
    high = std::min(aim.ray.high, high + reach.frontDepth(*first));
    std::optional<PointHit> best;
    double least = std::numeric_limits<double>::infinity();
    search([&](std::uint32_t vertex, const glm::dvec3 &, double t, const glm::dvec2 &off) {
        const double squared = glm::dot(off, off);
        const bool isNearer =
            squared < least || (squared == least && (t < best->t || (t == best->t && vertex < best->vertex)));
        if (!isNearer)
            return;
        least = squared;
        best = PointHit{vertex, t};
    });
    return best;
}

} // namespace unprojector::ray
