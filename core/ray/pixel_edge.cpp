#include "core/ray/pixel_edge.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

namespace unprojector::ray {
using namespace geometry;

namespace {

/// The least step in depth at an edge, in widths of a pixel.
constexpr double kLeastStep = 1.0;
/// The distances of the rays on both sides from the edge, in pixels: the smaller one for triangles
/// that are seen nearly edge on.
constexpr std::array kBeside{1e-4, 1e-6};

/// A point in the view: x / w and y / w are device pixels from the centre of the square.
using ViewPoint = glm::dvec3;

/// The volume that three view points span with the eye; its sign tells the side of the third.
double sideOf(const ViewPoint &a, const ViewPoint &b, const ViewPoint &c)
{
    return glm::dot(a, glm::cross(b - a, c - a));
}

/// An edge of a triangle, or of its cut.
struct Side {
    WorldPoint from, to;
    WorldPoint third; ///< on the triangle's side of the edge
};

bool isLess(const WorldPoint &a, const WorldPoint &b)
{
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// The search for edges in a square of the view.
class PixelEdgeSearch {
public:
    PixelEdgeSearch(const SceneRays &rays, const DevicePoint &position, double pixels)
        : m_rays(rays), m_position(position), m_half(pixels / 2.0)
    {
    }

    std::optional<PixelEdge> run(const std::optional<SceneHit> &hit)
    {
        const Result<Ray<WorldSpace>> ray = m_rays.rays().at(m_position);
        if (!ray || !prepareView())
            return std::nullopt;
        m_hit = hit;
        m_along = ray->along.coordinates();
        for (const Target &target : m_rays.targets())
            visitOccluding(sidesOf(target));
        if (m_found && m_hit)
            m_found->reach = WorldVector(glm::abs(m_along) * m_most);
        return m_found;
    }

private:
    /// The steps from world space to the view, and the planes that cut surfaces.
    bool prepareView()
    {
        const Setup &setup = m_rays.rays().setup();
        const std::optional<glm::dmat4> &matrix = m_rays.rays().clipFromWorld();
        if (!matrix)
            return false;
        const auto deviceAt = [&](double ndc) {
            return deviceFromWindow(setup.surface, windowFromNdc(setup.viewport, setup.depthRange,
                                                                 NdcPoint(ndc, ndc, 0.0), ndcDepthOf(setup)));
        };
        const DevicePoint middle = deviceAt(0.0), end = deviceAt(1.0);
        const glm::dmat4 rows = glm::transpose(*matrix);
        m_viewFromWorld = {rows[0] * (end.x - middle.x) + rows[3] * (middle.x - m_position.x),
                           rows[1] * (end.y - middle.y) + rows[3] * (middle.y - m_position.y), rows[3]};
        m_planes = m_rays.clipPlanes();
        const Result<Ray<WorldSpace>> ray = m_rays.rays().at(m_position);
        for (const double depth : {m_rays.rays().depths().atNear, m_rays.rays().depths().atFar}) {
            const NdcPoint ndc =
                ndcFromWindow(setup.viewport, setup.depthRange, WindowPoint(0.0, 0.0, depth), ndcDepthOf(setup));
            const glm::dvec4 plane = rows[2] - ndc.z * rows[3];
            const double inside = glm::dot(plane, glm::dvec4(ray->at(0.5).coordinates(), 1.0));
            if (glm::length(glm::dvec3(plane)) > 0.0) // else it is at infinity
                m_planes.push_back(inside < 0.0 ? -plane : plane);
        }
        return true;
    }

    ViewPoint viewOf(const WorldPoint &point) const
    {
        const glm::dvec4 p(point.coordinates(), 1.0);
        return {glm::dot(m_viewFromWorld[0], p), glm::dot(m_viewFromWorld[1], p), glm::dot(m_viewFromWorld[2], p)};
    }

    /// The bounds of the square: each is not negative inside.
    std::array<double, 4> inside(const ViewPoint &p) const
    {
        return {m_half * p.z + p.x, m_half * p.z - p.x, m_half * p.z + p.y, m_half * p.z - p.y};
    }

    /// The part of an edge inside the square, in shares of the edge.
    std::optional<std::pair<double, double>> partInside(const ViewPoint &from, const ViewPoint &to) const
    {
        double low = 0.0, high = 1.0;
        const std::array<double, 4> a = inside(from), b = inside(to);
        for (std::size_t k = 0; k < a.size(); ++k) {
            if (a[k] < 0.0 && b[k] < 0.0)
                return std::nullopt;
            if (a[k] < 0.0)
                low = std::max(low, a[k] / (a[k] - b[k]));
            else if (b[k] < 0.0)
                high = std::min(high, a[k] / (a[k] - b[k]));
        }
        return low < high ? std::optional(std::pair(low, high)) : std::nullopt;
    }

    /// The edges of an object's triangles that cross the square. Every triangle at such an edge is
    /// among the ones near the square.
    std::vector<Side> sidesOf(const Target &target) const
    {
        std::vector<Side> sides;
        for (const std::uint32_t triangle : m_rays.trianglesAbout(target, m_position, m_half)) {
            const std::array<WorldPoint, 3> corners = worldCorners(target, triangle);
            const std::array<ViewPoint, 3> views{viewOf(corners[0]), viewOf(corners[1]), viewOf(corners[2])};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t next = (k + 1) % 3;
                if (corners[k] == corners[next] || !partInside(views[k], views[next]))
                    continue;
                Side side{corners[k], corners[next], corners[(k + 2) % 3]};
                if (isLess(side.to, side.from))
                    std::swap(side.from, side.to);
                sides.push_back(side);
            }
            for (const glm::dvec4 &plane : m_planes)
                addCut(corners, plane, sides);
        }
        return sides;
    }

    /// Adds the edge along which a plane cuts a triangle.
    void addCut(const std::array<WorldPoint, 3> &corners, const glm::dvec4 &plane, std::vector<Side> &sides) const
    {
        std::array<double, 3> off{};
        for (std::size_t k = 0; k < 3; ++k)
            off[k] = glm::dot(plane, glm::dvec4(corners[k].coordinates(), 1.0));
        std::vector<WorldPoint> cut;
        std::optional<WorldPoint> kept;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            if (off[k] >= 0.0)
                kept = corners[k];
            if ((off[k] >= 0.0) != (off[next] >= 0.0))
                cut.push_back(corners[k] + (corners[next] - corners[k]) * (off[k] / (off[k] - off[next])));
        }
        if (kept && cut.size() == 2 && partInside(viewOf(cut[0]), viewOf(cut[1])))
            sides.push_back({cut[0], cut[1], *kept});
    }

    /// Visits the edges with no triangle on one of their sides.
    void visitOccluding(std::vector<Side> sides)
    {
        std::sort(sides.begin(), sides.end(), [](const Side &a, const Side &b) {
            return isLess(a.from, b.from) || (!isLess(b.from, a.from) && isLess(a.to, b.to));
        });
        for (auto side = sides.begin(); side != sides.end();) {
            int left = 0, right = 0;
            const Side &edge = *side;
            const ViewPoint from = viewOf(edge.from), to = viewOf(edge.to);
            for (; side != sides.end() && side->from == edge.from && side->to == edge.to; ++side) {
                const double volume = sideOf(from, to, viewOf(side->third));
                left += volume > 0.0 ? 1 : 0;
                right += volume < 0.0 ? 1 : 0;
            }
            if ((left > 0) != (right > 0))
                visit(edge, from, to, left > 0);
        }
    }

    /// Looks at both sides of the parts of an edge that lie in the square.
    void visit(const Side &edge, const ViewPoint &from, const ViewPoint &to, bool isLeft)
    {
        constexpr double kMost = 16.0, kPerPixel = 8.0;
        const std::optional<std::pair<double, double>> part = partInside(from, to);
        if (!part)
            return;
        const auto at = [&](double share) {
            const ViewPoint p = from + share * (to - from);
            return glm::dvec2(p) / p.z;
        };
        const glm::dvec2 start = at(part->first), way = at(part->second) - start;
        const double length = glm::length(way);
        if (!(length > 0.0)) // seen along itself
            return;
        const glm::dvec2 inward = (isLeft ? 1.0 : -1.0) / length * glm::dvec2(-way.y, way.x);
        const int count = static_cast<int>(std::clamp(std::ceil(kPerPixel * length), 1.0, kMost));
        for (int i = 0; i < count; ++i) {
            const double share = part->first + (part->second - part->first) * ((i + 0.5) / count);
            look(edge.from + (edge.to - edge.from) * share, at(share), inward);
        }
    }

    struct Seen {
        std::optional<std::size_t> object; ///< nothing: the background
        double t = 0.0;
    };
    std::optional<Seen> seenAt(const glm::dvec2 &place) const
    {
        const Result<Ray<WorldSpace>> ray =
            m_rays.rays().at(DevicePoint(m_position.x + place.x, m_position.y + place.y));
        if (!ray)
            return std::nullopt;
        const std::optional<FirstTriangle> first = m_rays.firstTriangle(*ray);
        return first ? Seen{first->object, first->hit.t} : Seen{};
    }

    /// Compares what rays on both sides of an edge's point see.
    /// @param inward  to the triangle's side, one pixel long
    void look(const WorldPoint &point, const glm::dvec2 &place, const glm::dvec2 &inward)
    {
        const DevicePoint device(m_position.x + place.x, m_position.y + place.y);
        const Result<Ray<WorldSpace>> ray = m_rays.rays().at(device),
                                      beside = m_rays.rays().at(DevicePoint(device.x + 1.0, device.y));
        if (!ray || !beside)
            return;
        const glm::dvec3 along = ray->along.coordinates();
        const double t = glm::dot((point - ray->from).coordinates(), along) / glm::dot(along, along);
        const double least = kLeastStep * distance(ray->at(t), beside->at(t)) / glm::length(along);
        for (const double away : kBeside) {
            const std::optional<Seen> own = seenAt(place + away * inward), other = seenAt(place - away * inward);
            if (!own || !other || (other->object && other->t - t < least))
                return;
            if (own->object
                && std::abs(own->t - t) < least / 2.0) // else something hides the edge, or the slope is steep
                return take(*own, *other);
        }
    }

    void take(const Seen &front, const Seen &back)
    {
        if (!m_hit) {
            if (!m_found)
                m_found = PixelEdge{front.object, 0.0, {}};
            return;
        }
        const double size = glm::length(m_along);
        const auto off = [&](const Seen &seen) { return std::abs(seen.t - m_hit->t); };
        // The hit is on the side that is nearer to it.
        const Seen &other = back.object && off(front) > off(back) ? front : back;
        const PixelEdge edge{other.object, other.object ? (other.t - m_hit->t) * size : 0.0, {}};
        m_most = std::max({m_most, off(front), back.object ? off(back) : 0.0});
        if (!m_found || std::abs(edge.behind) > std::abs(m_found->behind))
            m_found = edge;
    }

    const SceneRays &m_rays;
    DevicePoint m_position;
    double m_half; ///< of the square's side, pixels
    std::array<glm::dvec4, 3> m_viewFromWorld{};
    std::vector<glm::dvec4> m_planes; ///< surfaces are shown on their positive side
    std::optional<SceneHit> m_hit;
    glm::dvec3 m_along{0.0}; ///< the ray through the position
    double m_most = 0.0;     ///< the largest |t| from the hit to a surface at an edge
    std::optional<PixelEdge> m_found;
};

} // namespace

std::optional<PixelEdge> edgeInPixel(const SceneRays &rays, const DevicePoint &position,
                                     const std::optional<SceneHit> &hit, double pixels)
{
    return PixelEdgeSearch(rays, position, pixels).run(hit);
}

} // namespace unprojector::ray
