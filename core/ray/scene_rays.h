#pragma once

#include "core/ray/click_ray.h"
#include "core/ray/scene_hit.h"
#include "core/scene/scene.h"

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace unprojector::ray {

/// The target that a click takes.
enum class Snap {
    Surface, ///< the hit of its own ray
    Vertex,  ///< the visible vertex nearest to it in the view, within kSnapPixels; its exact coordinate
    Edge,    ///< the nearest visible edge in the same radius; its nearest point in the view
    Face,    ///< the hit of its own ray, else the nearest visible triangle in the same radius
};
/// The snap radius in device pixels.
constexpr double kSnapPixels = 8.0;

/// The triangle that a ray hits first, without the details of a SceneHit.
struct FirstTriangle {
    std::size_t object = 0; ///< index in the scene's list
    TriangleHit hit;        ///< its t is the ray's
};

/// Casts the rays of clicks into a scene: its visible objects, inside the view volume and on the
/// positive side of every clip plane. Immutable: any thread may query it.
class SceneRays {
public:
    /// @param objects     of the scene, in its order
    /// @param casters     of their models, one an object; an object whose caster is null (not built
    ///         yet) is never hit, nor is one whose transform has no inverse
    /// @param clipPlanes  see SceneSettings::clipPlanes
    SceneRays(const unproject::Unprojector &unprojector, std::span<const scene::SceneObject> objects,
              std::span<const std::shared_ptr<const RayCaster>> casters, std::span<const glm::dvec4> clipPlanes);

    /// The hit of a click. A point of a point cloud within kSnapPixels counts as a hit in every
    /// mode; PointCloud selects it. If a triangle is hit too: the nearer of both if the position is
    /// on the point's dot, else the triangle.
    /// @param position  continuous device pixels, origin top-left; outside the viewport nothing is
    ///         hit
    /// @return nothing without a hit; the errors of ClickRays::at
    geometry::Result<std::optional<SceneHit>> at(const geometry::DevicePoint &position,
                                                 Snap snap = Snap::Surface) const;

    /// The surface that a ray hits first, ignoring point clouds; for many rays. Converts to object
    /// space in plain double, see Placement::plainObjectRay.
    /// @param ray  in world space, one of the setup's rays
    std::optional<FirstTriangle> firstTriangle(const Ray<geometry::WorldSpace> &ray) const;
    /// Returns whether an object that can be hit has points of a cloud.
    bool hasPoints() const { return m_hasPoints; }

    const ClickRays &rays() const { return m_rays; }
    /// The objects that can be hit.
    const std::vector<Target> &targets() const { return m_targets; }
    /// The one with an index in the scene's list.
    const Target &target(std::size_t object) const;
    const std::vector<glm::dvec4> &clipPlanes() const { return m_clipPlanes; }
    /// The corners of the hit triangle, in the order of its ids.
    /// @pre a hit of these rays, on a triangle
    std::array<geometry::WorldPoint, 3> corners(const SceneHit &hit) const;

    /// The part that is in the view volume and not clipped of the ray through a position; nothing outside the viewport.
    std::optional<Ray<geometry::WorldSpace>> shownAt(const geometry::DevicePoint &position) const;
    /// The first hit of a part that is shown.
    std::optional<SceneHit> nearest(const Ray<geometry::WorldSpace> &part) const;
    /// An object's triangles in a square of the view, and others near them; none where rays cannot be computed.
    /// @param half  of the square's side, device pixels
    /// @param high  the largest t of the rays
    std::vector<std::uint32_t> trianglesAbout(const Target &target, const geometry::DevicePoint &position, double half,
                                              double high = std::numeric_limits<double>::infinity()) const;

private:
    std::optional<Ray<geometry::WorldSpace>> shown(Ray<geometry::WorldSpace> ray) const;
    /// @param isPrecise  converts rays as Placement::objectRay does, else in plain double
    std::optional<FirstTriangle> first(const Ray<geometry::WorldSpace> &part, bool isPrecise) const;
    struct TakenPoint {
        SceneHit hit;
        bool isOnDot = false; ///< the position is on the dot of the point
    };
    /// The point of a point cloud that a click takes within kSnapPixels.
    std::optional<TakenPoint> nearestPoint(const geometry::DevicePoint &position,
                                           const Ray<geometry::WorldSpace> &ray) const;
    ClickRays m_rays;
    std::vector<Target> m_targets;
    std::vector<glm::dvec4> m_clipPlanes;
    bool m_hasPoints = false;
};

} // namespace unprojector::ray
