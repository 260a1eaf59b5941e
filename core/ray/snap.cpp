#include "core/ray/snap.h"

#include "core/base/translation.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace unprojector::ray {
using namespace geometry;

namespace {

/// The tolerance in pixels: of two points behind each other, rounding may make the rear one nearer.
constexpr double kSamePlace = 1e-6;

/// Finds the visible vertex, edge or face near a position that a click snaps to. Rays through the
/// positions around it, a pixel apart, find most of them. A search among all triangles there finds
/// the ones thin or small enough to lie between the rays.
class SnapSearch {
public:
    SnapSearch(const SceneRays &rays, const DevicePoint &position) : m_rays(rays), m_position(position)
    {
        m_clipFromWorld = rays.rays().clipFromWorld();
        if (const Result<Ray<WorldSpace>> ray = rays.rays().at(position); ray && m_clipFromWorld)
            m_nearW = (*m_clipFromWorld * glm::dvec4(ray->from.coordinates(), 1.0)).w;
        std::vector<std::pair<double, DevicePoint>> positions;
        // Casts rays somewhat beyond the radius, since a triangle may end at the very point that
        // counts.
        constexpr double kFarther = 2.0;
        const int reach = static_cast<int>(kSnapPixels + kFarther);
        for (int j = -reach; j <= reach; ++j) {
            for (int i = -reach; i <= reach; ++i) {
                const double pixels = std::hypot(double(i), double(j));
                if (pixels <= kSnapPixels + kFarther)
                    positions.emplace_back(pixels, DevicePoint(position.x + i, position.y + j));
            }
        }
        std::stable_sort(positions.begin(), positions.end(),
                         [](const auto &a, const auto &b) { return a.first < b.first; });
        std::set<std::pair<std::size_t, std::uint32_t>> known;
        for (const auto &[pixels, at] : positions) {
            const std::optional<Ray<WorldSpace>> ray = m_rays.shownAt(at);
            const std::optional<SceneHit> hit = ray ? m_rays.nearest(*ray) : std::nullopt;
            if (hit && known.insert({hit->object, hit->triangle->triangle}).second)
                m_seen.push_back({*hit, pixels});
        }
    }

    /// The nearest visible vertex or point of an edge in the view, within kSnapPixels.
    std::optional<SceneHit> nearest(bool isVertex) const
    {
        if (!m_clipFromWorld)
            return std::nullopt;
        const auto addPlaces = isVertex ? &SnapSearch::addCorners : &SnapSearch::addEdges;
        std::vector<Place> places;
        for (const Seen &seen : m_seen)
            (this->*addPlaces)(m_rays.target(seen.hit.object), seen.hit.triangle->triangle, kSnapPixels, places);
        std::optional<InSight> taken = nearestInSight(std::move(places));
        // A triangle that no ray has hit may have something nearer.
        constexpr double kRounding = 0.01;
        const double reach = taken ? taken->pixels : kSnapPixels;
        const std::vector<Occluder> hiding = occluders();
        constexpr double kBeyond = 1.001;
        double high = std::numeric_limits<double>::infinity();
        for (const Occluder &occluder : hiding)
            high = std::min(high, kBeyond * occluder.coversTo);
        places.clear();
        for (const Target &target : m_rays.targets()) {
            for (const std::uint32_t triangle : m_rays.trianglesAbout(target, m_position, reach + kRounding, high))
                (this->*addPlaces)(target, triangle, reach, places);
        }
        if (taken)
            std::erase_if(places, [reach](const Place &place) { return place.pixels >= reach - kSamePlace; });
        eraseHidden(places, hiding);
        if (const std::optional<InSight> nearer = nearestInSight(std::move(places)))
            taken = nearer;
        if (!taken)
            return std::nullopt;
        // Its own, since no plane is intersected.
        taken->hit.uncertainty = isVertex ? taken->hit.vertex.uncertainty : taken->hit.triangle->edge.uncertainty;
        return taken->hit;
    }

    /// The nearest location where a ray hit a triangle.
    std::optional<SceneHit> face() const
    {
        return m_seen.empty() || m_seen.front().pixels > kSnapPixels ? std::nullopt : std::optional(m_seen.front().hit);
    }

private:
    /// A hit triangle, and its distance from the position.
    struct Seen {
        SceneHit hit;
        double pixels;
    };
    /// A location on a triangle.
    struct Place {
        const Target *target;
        std::uint32_t triangle;
        glm::dvec3 barycentric;
        WorldPoint world;
        DevicePoint at;
        double pixels; ///< from the position
    };
    /// A hit triangle that can hide others: wholly in front of the eye and not clipped.
    struct Occluder {
        std::array<glm::dvec2, 3> corners; ///< in the view, counter-clockwise in these coordinates
        WorldPoint on;
        glm::dvec3 behind; ///< its normal towards the far side, length 1
        WorldPoint from;   ///< on the near plane
        double coversTo; ///< the t up to which points beside it may be visible; infinity: it does not cover everything

        bool covers(const DevicePoint &at) const
        {
            constexpr double kInside = 0.01; // pixels
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec2 along = corners[(k + 1) % 3] - corners[k], off = at.coordinates() - corners[k];
                if (!(along.x * off.y - along.y * off.x > kInside * glm::length(along)))
                    return false;
            }
            return true;
        }
    };

    struct InSight {
        SceneHit hit;
        double pixels;
    };

    /// The position of a world point in the view; nothing behind the eye.
    std::optional<DevicePoint> seenAt(const WorldPoint &point) const
    {
        if (!m_clipFromWorld)
            return std::nullopt;
        const glm::dvec4 clip = *m_clipFromWorld * glm::dvec4(point.coordinates(), 1.0);
        if (!(clip.w > 0.0))
            return std::nullopt;
        const Setup &setup = m_rays.rays().setup();
        const NdcPoint ndc(clip.x / clip.w, clip.y / clip.w, clip.z / clip.w);
        return deviceFromWindow(setup.surface, windowFromNdc(setup.viewport, setup.depthRange, ndc, ndcDepthOf(setup)));
    }

    /// Returns whether no clip plane removes a point.
    bool isOnShownSide(const WorldPoint &point) const
    {
        return std::ranges::all_of(m_rays.clipPlanes(), [&point](const glm::dvec4 &plane) {
            return glm::dot(plane, glm::dvec4(point.coordinates(), 1.0)) >= 0.0;
        });
    }

    std::optional<SceneHit> inSight(const Place &place) const
    {
        const std::optional<DevicePoint> at = seenAt(place.world);
        const std::optional<Ray<WorldSpace>> part = at ? m_rays.shownAt(*at) : std::nullopt;
        if (!part)
            return std::nullopt;
        const SceneHit hit =
            hitOnTriangle(*place.target, place.triangle, place.barycentric, *part, m_rays.rays().eye());
        // The tolerance at the rim of hidden or clipped parts, where rounding decides.
        constexpr double kRounding = 1e-9;
        if (hit.t < part->low - kRounding || hit.t > part->high * (1.0 + kRounding))
            return std::nullopt;
        const std::optional<SceneHit> first = m_rays.nearest(*part);
        // The uncertainty is the edge's, at any angle of the triangle.
        const WorldVector &own = hit.triangle->edge.uncertainty;
        const bool isHidden = first && first->t < hit.t * (1.0 - kRounding) - kRounding
                              && distance(first->world, hit.world) > 4.0 * length(first->uncertainty + own);
        return isHidden ? std::nullopt : std::optional(hit);
    }

    std::optional<InSight> nearestInSight(std::vector<Place> places) const
    {
        std::stable_sort(places.begin(), places.end(),
                         [](const Place &a, const Place &b) { return a.pixels < b.pixels; });
        const Place *before = nullptr;
        std::optional<InSight> nearest;
        for (const Place &place : places) {
            if (nearest && place.pixels > nearest->pixels + kSamePlace)
                break;
            const bool isKnown = before && before->target == place.target && before->world == place.world;
            before = &place;
            if (isKnown) // a corner shared by several triangles
                continue;
            const std::optional<SceneHit> hit = inSight(place);
            if (hit && (!nearest || hit->t < nearest->hit.t)) // the front one of overlapping points
                nearest = InSight{*hit, nearest ? nearest->pixels : place.pixels};
        }
        return nearest;
    }

    std::vector<Occluder> occluders() const
    {
        // Bounds all positions that can be snapped to.
        std::vector<std::pair<DevicePoint, Ray<WorldSpace>>> rays;
        for (const double right : {-kSnapPixels, kSnapPixels}) {
            for (const double down : {-kSnapPixels, kSnapPixels}) {
                const DevicePoint at(m_position.x + right, m_position.y + down);
                const auto ray = m_rays.rays().at(at);
                if (!ray)
                    return {};
                rays.emplace_back(at, *ray);
            }
        }
        std::vector<Occluder> result;
        for (const Seen &seen : m_seen) {
            const auto corners = m_rays.corners(seen.hit);
            const glm::dvec3 normal =
                glm::cross((corners[1] - corners[0]).coordinates(), (corners[2] - corners[0]).coordinates());
            const double size = glm::length(normal);
            const auto side = [&](const WorldPoint &point) {
                return glm::dot(normal / size, (point - corners[0]).coordinates());
            };
            const double own = side(rays[0].second.from);
            Occluder occluder{{}, corners[0], normal / size * (own > 0.0 ? -1.0 : 1.0), rays[0].second.from, 0.0};
            bool isWhole = size > 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::optional<DevicePoint> at = seenAt(corners[k]);
                isWhole = isWhole && at && isOnShownSide(corners[k]);
                occluder.corners[k] = at ? at->coordinates() : glm::dvec2(0.0);
            }
            const auto &[a, b, c] = occluder.corners;
            if ((b - a).x * (c - a).y - (b - a).y * (c - a).x < 0.0)
                std::swap(occluder.corners[1], occluder.corners[2]);
            for (const auto &[at, ray] : rays) {
                const double start = side(ray.from), t = start / (start - side(ray.at(1.0)));
                isWhole = isWhole && start * own > 0.0;
                occluder.coversTo = occluder.covers(at) && t >= 0.0 ? std::max(occluder.coversTo, t)
                                                                    : std::numeric_limits<double>::infinity();
            }
            if (isWhole)
                result.push_back(occluder);
        }
        return result;
    }

    /// Removes the locations well behind an occluder: much faster than casting rays.
    static void eraseHidden(std::vector<Place> &places, const std::vector<Occluder> &occluders)
    {
        constexpr double kBehind = 1e-4; // share of the distance to the point
        std::erase_if(places, [&occluders](const Place &place) {
            return std::any_of(occluders.begin(), occluders.end(), [&place](const Occluder &occluder) {
                return occluder.covers(place.at)
                       && glm::dot(occluder.behind, (place.world - occluder.on).coordinates())
                              > kBehind * distance(place.world, occluder.from);
            });
        });
    }

    /// Adds a location on the edge from corner k if it lies within some pixels.
    void addPlace(const Target &target, std::uint32_t triangle, std::size_t k, double share, const WorldPoint &world,
                  double pixels, std::vector<Place> &places) const
    {
        const std::optional<DevicePoint> at = seenAt(world);
        if (!at || distance(*at, m_position) > pixels)
            return;
        glm::dvec3 barycentric(0.0);
        barycentric[static_cast<int>(k)] = 1.0 - share;
        barycentric[static_cast<int>((k + 1) % 3)] = share;
        places.push_back({&target, triangle, barycentric, world, *at, distance(*at, m_position)});
    }
    void addCorners(const Target &target, std::uint32_t triangle, double pixels, std::vector<Place> &places) const
    {
        const auto corners = worldCorners(target, triangle);
        for (std::size_t k = 0; k < 3; ++k)
            addPlace(target, triangle, k, 0.0, corners[k], pixels, places);
    }
    void addEdges(const Target &target, std::uint32_t triangle, double pixels, std::vector<Place> &places) const
    {
        const auto corners = worldCorners(target, triangle);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            // Cuts the part behind the near plane, in shares of the edge.
            const auto depth = [&](const WorldPoint &p) {
                return (*m_clipFromWorld * glm::dvec4(p.coordinates(), 1.0)).w;
            };
            const double one = depth(corners[k]) - m_nearW, other = depth(corners[next]) - m_nearW;
            if (one < 0.0 && other < 0.0)
                continue;
            const double crossing = one / (one - other);
            const double from = one >= 0.0 ? 0.0 : crossing, to = other >= 0.0 ? 1.0 : crossing;
            const WorldVector way = corners[next] - corners[k];
            const auto start = seenAt(corners[k] + way * from), end = seenAt(corners[k] + way * to);
            if (!start || !end)
                continue;
            // The nearest share in the view, converted to the share of the edge: nearer parts are drawn
            // larger.
            const glm::dvec2 drawn = end->coordinates() - start->coordinates();
            const double square = glm::dot(drawn, drawn);
            const double share =
                square > 0.0
                    ? std::clamp(glm::dot(m_position.coordinates() - start->coordinates(), drawn) / square, 0.0, 1.0)
                    : 0.0;
            const double a = m_nearW + one + from * (other - one), b = m_nearW + one + to * (other - one);
            const double along = from + (to - from) * (share * a / (share * a + (1.0 - share) * b));
            addPlace(target, triangle, k, along, corners[k] + way * along, pixels, places);
        }
    }

    const SceneRays &m_rays;
    DevicePoint m_position;
    std::optional<glm::dmat4> m_clipFromWorld;
    double m_nearW = 1.0;     ///< of clip space, on the near plane
    std::vector<Seen> m_seen; ///< nearest first, each triangle once
};

} // namespace

std::optional<SceneHit> snapped(const SceneRays &rays, const DevicePoint &position, Snap snap)
{
    const SnapSearch search(rays, position);
    return snap == Snap::Face ? search.face() : search.nearest(snap == Snap::Vertex);
}

std::string nothingText(Snap snap)
{
    switch (snap) {
    case Snap::Surface: break;
    case Snap::Vertex: return base::tr("no vertex is visible within %1 pixels", int(kSnapPixels));
    case Snap::Edge: return base::tr("no edge is visible within %1 pixels", int(kSnapPixels));
    case Snap::Face: return base::tr("no face is visible within %1 pixels", int(kSnapPixels));
    }
    return base::tr("no hit");
}

} // namespace unprojector::ray
