#include "core/ray/scene_rays.h"

#include "core/ray/snap.h"
#include "core/scene/point_size.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cassert>

namespace unprojector::ray {
using namespace geometry;
using namespace scene;
using namespace unproject;

SceneRays::SceneRays(const Unprojector &unprojector, std::span<const SceneObject> objects,
                     std::span<const std::shared_ptr<const RayCaster>> casters, std::span<const glm::dvec4> clipPlanes)
    : m_rays(unprojector), m_clipPlanes(clipPlanes.begin(), clipPlanes.end())
{
    assert(objects.size() == casters.size());
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (objects[i].isHidden || casters[i] == nullptr)
            continue;
        if (const Result<Placement> placement = Placement::of(worldFromObject(objects[i].transform)))
            m_targets.push_back({i, casters[i], *placement});
        m_hasPoints = m_hasPoints || casters[i]->hasPoints();
    }
}

std::optional<Ray<WorldSpace>> SceneRays::shown(Ray<WorldSpace> ray) const
{
    // The signed distance of a ray's point from a plane is linear in t.
    for (const glm::dvec4 &plane : m_clipPlanes) {
        const double start = glm::dot(glm::dvec3(plane), ray.from.coordinates()) + plane.w;
        const double rise = glm::dot(glm::dvec3(plane), ray.along.coordinates());
        if (rise > 0.0)
            ray.low = std::max(ray.low, -start / rise);
        else if (rise < 0.0)
            ray.high = std::min(ray.high, -start / rise);
        else if (start < 0.0)
            return std::nullopt;
    }
    if (!(ray.low <= ray.high))
        return std::nullopt;
    return ray;
}

std::optional<Ray<WorldSpace>> SceneRays::shownAt(const DevicePoint &position) const
{
    if (!m_rays.isInPicture(position))
        return std::nullopt;
    const Result<Ray<WorldSpace>> ray = m_rays.at(position);
    return ray ? shown(*ray) : std::nullopt;
}

std::optional<FirstTriangle> SceneRays::first(const Ray<WorldSpace> &part, bool isPrecise) const
{
    std::optional<FirstTriangle> first;
    for (const Target &target : m_targets) {
        const Result<Ray<ObjectSpace>> own =
            isPrecise ? target.placement.objectRay(part) : target.placement.plainObjectRay(part);
        const std::optional<TriangleHit> hit = own ? target.caster->nearestTriangle(*own) : std::nullopt;
        if (hit && (!first || hit->t < first->hit.t))
            first = FirstTriangle{target.object, *hit};
    }
    return first;
}

std::optional<FirstTriangle> SceneRays::firstTriangle(const Ray<WorldSpace> &ray) const
{
    const std::optional<Ray<WorldSpace>> part = shown(ray);
    return part ? first(*part, false) : std::nullopt;
}

std::optional<SceneHit> SceneRays::nearest(const Ray<WorldSpace> &part) const
{
    const std::optional<FirstTriangle> hit = first(part, true);
    if (!hit)
        return std::nullopt;
    const Target &own = target(hit->object);
    const ElementNumbers::Place place = own.caster->triangleNumbers().place(hit->hit.triangle);
    const glm::dvec3 barycentric =
        preciseBarycentric(own.caster->model().meshes[place.mesh], place.element, *own.placement.objectRay(part));
    return hitOnTriangle(own, hit->hit.triangle, barycentric, part, m_rays.eye());
}

std::vector<std::uint32_t> SceneRays::trianglesAbout(const Target &target, const DevicePoint &position, double half,
                                                     double high) const
{
    std::array<Ray<ObjectSpace>, 5> rays;
    constexpr std::array<glm::dvec2, 5> kPlaces{{{0, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const auto ray = m_rays.at(DevicePoint(position.x + half * kPlaces[k].x, position.y + half * kPlaces[k].y));
        if (!ray)
            return {};
        rays[k] = target.placement.plainObjectRay(*ray);
    }
    rays[0].high = std::min(rays[0].high, high);
    return target.caster->trianglesAbout({rays[0], {rays[1], rays[2], rays[3], rays[4]}});
}

const Target &SceneRays::target(std::size_t object) const
{
    return *std::ranges::find(m_targets, object, &Target::object);
}

std::array<WorldPoint, 3> SceneRays::corners(const SceneHit &hit) const
{
    return worldCorners(target(hit.object), hit.triangle->triangle);
}

std::optional<SceneRays::TakenPoint> SceneRays::nearestPoint(const DevicePoint &position,
                                                             const Ray<WorldSpace> &ray) const
{
    const Setup &setup = m_rays.setup();
    const std::optional<glm::dmat4> &matrix = m_rays.clipFromWorld();
    if (!matrix)
        return std::nullopt;
    const WindowPoint window = windowFromDevice(setup.surface, position, setup.depthRange.atNear);
    const NdcPoint ndc = ndcFromWindow(setup.viewport, setup.depthRange, window, ndcDepthOf(setup));
    PointAim aim;
    aim.position = {ndc.x, ndc.y};
    aim.ndcOfPixel = {2.0 / setup.viewport.width, 2.0 / setup.viewport.height};
    aim.dotPixels = pointPixels(setup.surface);
    aim.pixels = std::max(kSnapPixels, aim.dotPixels);
    const Target *taken = nullptr;
    std::optional<PointHit> first;
    for (const Target &candidate : m_targets) {
        const Result<Ray<ObjectSpace>> own = candidate.placement.objectRay(ray);
        if (!candidate.caster->hasPoints() || !own)
            continue;
        const glm::dmat4 &worldFromObject = candidate.placement.worldFromObject();
        aim.clipFromObject = *matrix * worldFromObject;
        aim.ray = *own;
        aim.clipPlanes.clear();
        for (const glm::dvec4 &plane : m_clipPlanes)
            aim.clipPlanes.push_back(plane * worldFromObject);
        const std::optional<PointHit> hit = candidate.caster->nearestPoint(aim);
        const bool isBefore = hit && (!first || (hit->isOnDot == first->isOnDot ? hit->t < first->t : hit->isOnDot));
        if (isBefore) {
            first = hit;
            taken = &candidate;
        }
    }
    if (!first)
        return std::nullopt;
    return TakenPoint{hitOnPoint(*taken, first->vertex, ray, m_rays.eye()), first->isOnDot};
}

Result<std::optional<SceneHit>> SceneRays::at(const DevicePoint &position, Snap snap) const
{
    if (!m_rays.isInPicture(position))
        return std::optional<SceneHit>();
    const Result<Ray<WorldSpace>> ray = m_rays.at(position);
    if (!ray)
        return ray.error();
    std::optional<SceneHit> hit;
    if (snap != Snap::Surface)
        hit = snapped(*this, position, snap);
    else if (const std::optional<Ray<WorldSpace>> part = shown(*ray))
        hit = nearest(*part);
    if (m_hasPoints) {
        const std::optional<TakenPoint> point = nearestPoint(position, *ray);
        if (point && (!hit || (point->isOnDot && point->hit.t < hit->t)))
            return std::optional(point->hit);
    }
    return hit;
}

} // namespace unprojector::ray
