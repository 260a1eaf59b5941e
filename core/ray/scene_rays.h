#pragma once

#include "core/ray/click_ray.h"
#include "core/ray/scene_hit.h"
#include "core/scene/scene.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace unprojector::ray {

/// What a click takes.
enum class Snap {
    Surface, ///< what its own ray meets
    Vertex,  ///< the vertex in sight that is nearest to it in the picture, within kSnapPixels; its very coordinate
    Edge,    ///< the edge in sight, as well; its nearest point in the picture
    Face,    ///< what its own ray meets, else the triangle in sight that is nearest to it, as well
};
/// Device pixels.
constexpr double kSnapPixels = 8.0;

/// The triangle that a ray meets first, without all that a SceneHit says of it.
struct FirstTriangle {
    std::size_t object = 0; ///< place in the scene's list
    TriangleHit hit;        ///< its t is the ray's
};

/// What the clicks on a picture of a scene meet: the objects that are not hidden, what of them lies in the view volume and on
/// the positive side of every clip plane. Immutable: any thread may ask.
class SceneRays {
public:
    /// @param objects     of the scene, with their places in the list
    /// @param casters     of their models, one an object; an object whose caster is null (not built yet) is not met, and
    ///                    neither is one whose transform has no inverse
    /// @param clipPlanes  see SceneSettings::clipPlanes
    SceneRays(const unproject::Unprojector &unprojector, std::span<const scene::SceneObject> objects,
              std::span<const std::shared_ptr<const RayCaster>> casters, std::span<const glm::dvec4> clipPlanes);

    /// A point of a point cloud within kSnapPixels counts as met, whatever the mode; see PointCloud for which. Where a
    /// triangle is met too: if the position is on the point's dot the nearer of both, else the triangle.
    /// @param position  continuous device pixels, origin top-left; outside the viewport nothing is met
    /// @return nothing where nothing is met; the errors of ClickRays::at
    geometry::Result<std::optional<SceneHit>> at(const geometry::DevicePoint &position,
                                                 Snap snap = Snap::Surface) const;

    /// Of many rays: the surface that a ray meets first, points of clouds passed over. The way into the objects' spaces is in
    /// plain double, see Placement::plainObjectRay.
    /// @param ray  in world space, of the picture's rays
    std::optional<FirstTriangle> firstTriangle(const Ray<geometry::WorldSpace> &ray) const;
    /// Whether an object that can be met has points of a cloud.
    bool hasPoints() const { return m_hasPoints; }

    const ClickRays &rays() const { return m_rays; }
    /// The corners of the triangle that was hit, in the order of its ids. @pre a hit of these rays, on a triangle
    std::array<geometry::WorldPoint, 3> corners(const SceneHit &hit) const;

private:
    friend class SnapSearch;
    struct Object {
        std::size_t index;
        std::shared_ptr<const RayCaster> caster;
        Placement placement;
    };

    /// Whether no clip plane takes a point away.
    bool isOnShownSide(const geometry::WorldPoint &point) const;
    /// A ray's part that is in the picture and not clipped away.
    std::optional<Ray<geometry::WorldSpace>> shown(Ray<geometry::WorldSpace> ray) const;
    /// The same of the ray through a position; nothing outside the picture.
    std::optional<Ray<geometry::WorldSpace>> shownAt(const geometry::DevicePoint &position) const;
    std::optional<SceneHit> nearest(const Ray<geometry::WorldSpace> &ray) const;
    struct TakenPoint {
        SceneHit hit;
        bool isOnDot = false; ///< the position is on the dot that the point is drawn as
    };
    /// The point of a point cloud that is taken within kSnapPixels.
    std::optional<TakenPoint> nearestPoint(const geometry::DevicePoint &position,
                                           const Ray<geometry::WorldSpace> &ray) const;
    /// @param index  in the scene's list, of one that can be met
    const Object &object(std::size_t index) const;

    ClickRays m_rays;
    std::vector<Object> m_objects;
    std::vector<glm::dvec4> m_clipPlanes;
    bool m_hasPoints = false;
};

} // namespace unprojector::ray
