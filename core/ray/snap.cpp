#include "core/ray/snap.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace unprojector::ray {
SnapSearch::SnapSearch(const SceneRays &rays, const DevicePoint &position) : m_rays(rays), m_position(position)
{
    if (const Result<glm::dmat4> matrix = clipFromWorld(rays.rays().picture()))
        m_clipFromWorld = *matrix;
    if (const Result<Ray<WorldSpace>> ray = rays.rays().at(position); ray && m_clipFromWorld)
        m_nearW = (*m_clipFromWorld * glm::dvec4(ray->from.coordinates(), 1.0)).w;
    std::vector<std::pair<double, DevicePoint>> positions;
    // Somewhat farther out, since a triangle may end at what it is taken for.
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
        const std::optional<SceneHit> met = ray ? m_rays.nearest(*ray) : std::nullopt;
        if (met && known.insert({met->object, met->triangle->triangle}).second)
            m_seen.push_back({*met, pixels});
    }
}

std::optional<DevicePoint> SnapSearch::seenAt(const WorldPoint &point) const
{
    if (!m_clipFromWorld)
        return std::nullopt;
    const glm::dvec4 clip = *m_clipFromWorld * glm::dvec4(point.coordinates(), 1.0);
    if (!(clip.w > 0.0))
        return std::nullopt;
    const Picture &picture = m_rays.rays().picture();
    const NdcPoint ndc(clip.x / clip.w, clip.y / clip.w, clip.z / clip.w);
    return deviceFromWindow(picture.surface,
                            windowFromNdc(picture.viewport, picture.depthRange, ndc, ndcDepthOf(picture)));
}

std::optional<SceneHit> SnapSearch::inSight(const Place &place) const
{
    const std::optional<DevicePoint> at = seenAt(place.world);
    const std::optional<Ray<WorldSpace>> part = at ? m_rays.shownAt(*at) : std::nullopt;
    if (!part)
        return std::nullopt;
    const SceneRays::Object &object = m_rays.object(place.object);
    SceneHit hit =
        hitOnTriangle(*object.caster, object.placement, place.triangle, place.barycentric, *part, m_rays.rays().eye());
    hit.object = place.object;
    // On the rim of what is hidden or cut off, rounding decides.
    constexpr double kRounding = 1e-9;
    if (hit.t < part->low - kRounding || hit.t > part->high * (1.0 + kRounding))
        return std::nullopt;
    const std::optional<SceneHit> first = m_rays.nearest(*part);
    const bool isHidden = first && first->t < hit.t * (1.0 - kRounding) - kRounding
                          && distance(first->world, hit.world) > 4.0 * length(first->uncertainty + hit.uncertainty);
    return isHidden ? std::nullopt : std::optional(hit);
}

std::optional<SceneHit> SnapSearch::nearestInSight(std::vector<Place> places) const
{
    std::stable_sort(places.begin(), places.end(), [](const Place &a, const Place &b) { return a.pixels < b.pixels; });
    for (const Place &place : places) {
        if (std::optional<SceneHit> hit = inSight(place))
            return hit;
    }
    return std::nullopt;
}

std::optional<SceneHit> SnapSearch::vertex() const
{
    std::vector<Place> places;
    for (const Seen &seen : m_seen) {
        const SceneRays::Object &object = m_rays.object(seen.hit.object);
        const auto corners = worldCorners(*object.caster, object.placement, seen.hit.triangle->triangle);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::optional<DevicePoint> at = seenAt(corners[k]);
            if (!at || distance(*at, m_position) > kSnapPixels)
                continue;
            glm::dvec3 barycentric(0.0);
            barycentric[static_cast<int>(k)] = 1.0;
            places.push_back(
                {seen.hit.object, seen.hit.triangle->triangle, barycentric, corners[k], distance(*at, m_position)});
        }
    }
    std::optional<SceneHit> hit = nearestInSight(std::move(places));
    if (hit)
        hit->uncertainty = hit->vertex.uncertainty; // it is no place where a ray meets a plane
    return hit;
}

std::optional<SceneHit> SnapSearch::edge() const
{
    if (!m_clipFromWorld)
        return std::nullopt;
    std::vector<Place> places;
    for (const Seen &seen : m_seen) {
        const SceneRays::Object &object = m_rays.object(seen.hit.object);
        const auto corners = worldCorners(*object.caster, object.placement, seen.hit.triangle->triangle);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            // The part behind the near plane, in shares of the edge.
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
            // The nearest share in the picture, and from it that of the edge: what is nearer is drawn larger.
            const glm::dvec2 drawn = end->coordinates() - start->coordinates();
            const double square = glm::dot(drawn, drawn);
            const double share =
                square > 0.0
                    ? std::clamp(glm::dot(m_position.coordinates() - start->coordinates(), drawn) / square, 0.0, 1.0)
                    : 0.0;
            const double a = m_nearW + one + from * (other - one), b = m_nearW + one + to * (other - one);
            const double along = from + (to - from) * (share * a / (share * a + (1.0 - share) * b));
            const WorldPoint world = corners[k] + way * along;
            const std::optional<DevicePoint> at = seenAt(world);
            if (!at || distance(*at, m_position) > kSnapPixels)
                continue;
            glm::dvec3 barycentric(0.0);
            barycentric[static_cast<int>(k)] = 1.0 - along;
            barycentric[static_cast<int>(next)] = along;
            places.push_back(
                {seen.hit.object, seen.hit.triangle->triangle, barycentric, world, distance(*at, m_position)});
        }
    }
    std::optional<SceneHit> hit = nearestInSight(std::move(places));
    if (hit)
        hit->uncertainty = hit->triangle->edge.uncertainty;
    return hit;
}

std::optional<SceneHit> SnapSearch::face() const
{
    return m_seen.empty() || m_seen.front().pixels > kSnapPixels ? std::nullopt : std::optional(m_seen.front().hit);
}

} // namespace unprojector::ray
