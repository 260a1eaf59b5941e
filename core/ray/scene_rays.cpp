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
            m_objects.push_back({i, casters[i], *placement});
        m_hasPoints = m_hasPoints || casters[i]->hasPoints();
    }
}

bool SceneRays::isOnShownSide(const WorldPoint &point) const
{
    return std::all_of(m_clipPlanes.begin(), m_clipPlanes.end(), [&point](const glm::dvec4 &plane) {
        return glm::dot(plane, glm::dvec4(point.coordinates(), 1.0)) >= 0.0;
    });
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

std::optional<FirstTriangle> SceneRays::firstTriangle(const Ray<WorldSpace> &ray) const
{
    const std::optional<Ray<WorldSpace>> part = shown(ray);
    std::optional<FirstTriangle> first;
    for (std::size_t k = 0; part && k < m_objects.size(); ++k) {
        const Object &candidate = m_objects[k];
        const std::optional<TriangleHit> hit =
            candidate.caster->nearestTriangle(candidate.placement.plainObjectRay(*part));
        if (hit && (!first || hit->t < first->hit.t))
            first = FirstTriangle{candidate.index, *hit};
    }
    return first;
}

std::optional<SceneHit> SceneRays::nearest(const Ray<WorldSpace> &ray) const
{
    const Object *object = nullptr;
    std::optional<TriangleHit> first;
    Ray<ObjectSpace> firstRay;
    for (const Object &candidate : m_objects) {
        const Result<Ray<ObjectSpace>> own = candidate.placement.objectRay(ray);
        if (!own)
            continue;
        const std::optional<TriangleHit> hit = candidate.caster->nearestTriangle(*own);
        if (hit && (!first || hit->t < first->t)) {
            first = hit;
            firstRay = *own;
            object = &candidate;
        }
    }
    if (!first)
        return std::nullopt;
    const ElementNumbers::Place place = object->caster->triangleNumbers().place(first->triangle);
    const glm::dvec3 barycentric =
        preciseBarycentric(object->caster->model().meshes[place.mesh], place.element, firstRay);
    SceneHit hit = hitOnTriangle(*object->caster, object->placement, first->triangle, barycentric, ray, m_rays.eye());
    hit.object = object->index;
    return hit;
}

const SceneRays::Object &SceneRays::object(std::size_t index) const
{
    return *std::find_if(m_objects.begin(), m_objects.end(), [index](const Object &one) { return one.index == index; });
}

std::array<WorldPoint, 3> SceneRays::corners(const SceneHit &hit) const
{
    const Object &hitObject = object(hit.object);
    return worldCorners(*hitObject.caster, hitObject.placement, hit.triangle->triangle);
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
    const Object *object = nullptr;
    std::optional<PointHit> first;
    for (const Object &candidate : m_objects) {
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
            object = &candidate;
        }
    }
    if (!first)
        return std::nullopt;
    TakenPoint taken{hitOnPoint(*object->caster, object->placement, first->vertex, ray, m_rays.eye()), first->isOnDot};
    taken.hit.object = object->index;
    return taken;
}

Result<std::optional<SceneHit>> SceneRays::at(const DevicePoint &position, Snap snap) const
{
    if (!m_rays.isInPicture(position))
        return std::optional<SceneHit>();
    const Result<Ray<WorldSpace>> ray = m_rays.at(position);
    if (!ray)
        return ray.error();
    std::optional<SceneHit> hit;
    switch (snap) {
    case Snap::Surface:
        if (const std::optional<Ray<WorldSpace>> part = shown(*ray))
            hit = nearest(*part);
        break;
    case Snap::Vertex: hit = SnapSearch(*this, position).vertex(); break;
    case Snap::Edge: hit = SnapSearch(*this, position).edge(); break;
    case Snap::Face: hit = SnapSearch(*this, position).face(); break;
    }
    if (m_hasPoints) {
        const std::optional<TakenPoint> point = nearestPoint(position, *ray);
        if (point && (!hit || (point->isOnDot && point->hit.t < hit->t)))
            return std::optional(point->hit);
    }
    return hit;
}

} // namespace unprojector::ray
