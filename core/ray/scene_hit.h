#pragma once

#include "core/ray/ray.h"
#include "core/ray/ray_caster.h"
#include "core/unproject/object_from_world.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace unprojector::ray {

struct NearVertex {
    std::uint32_t id = 0; ///< its number in the file, see Model::vertexNumber
    geometry::WorldPoint world;
    double distance = 0.0; ///< from the hit, world units
    /// The largest deviation of each coordinate from the file's, due to double arithmetic.
    geometry::WorldVector uncertainty = {};
};

/// An edge of the triangle that was hit.
struct NearEdge {
    std::array<std::uint32_t, 2> ids{};     ///< of its vertices, see NearVertex::id
    geometry::WorldPoint world;             ///< its point nearest to the hit
    double distance = 0.0;                  ///< from the hit, world units
    geometry::WorldVector uncertainty = {}; ///< of that point: the edge's largest deviation from the file's
};

/// The details of a hit triangle.
struct TriangleDetail {
    /// Numbered across all meshes of its model from 0, in the order of the meshes: the file's
    /// order, with the triangles of a polygon in its position. If faces are grouped by material,
    /// material after material.
    std::uint32_t triangle = 0;
    glm::dvec3 barycentric{0.0};        ///< of the hit; their sum is 1
    std::array<std::uint32_t, 3> ids{}; ///< of the corners' vertices
    /// World space, length 1: the side from which the corners are counter-clockwise in the file. As
    /// for normals, the outside stays outside if a transform mirrors the object.
    geometry::WorldVector normal;
    NearEdge edge; ///< the nearest
};

/// The hit of a ray on an object of a scene.
struct SceneHit {
    std::size_t object = 0; ///< index in the scene's list
    double t = 0.0;         ///< of the ray in world space
    geometry::ObjectPoint objectPoint;
    geometry::WorldPoint world;
    /// The distance from the eye along the ray, world units. Without an eye (a box, a matrix that
    /// is no known projection), from the near plane.
    double distance = 0.0;
    std::optional<TriangleDetail> triangle; ///< nothing for a point of a point cloud
    NearVertex vertex;                      ///< the nearest of the triangle's; or the point itself
    /// The largest deviation of each coordinate of `world` from the file's, to first order: double
    /// arithmetic, carried along the ray to the surface. It is large if the surface is nearly edge
    /// on. The position in the view counts as exact: the surface area that a pixel covers is not
    /// included.
    geometry::WorldVector uncertainty;
};

/// An object's position in the world, prepared for hits.
class Placement {
public:
    /// @param worldFromObject  affine
    /// @return NotFinite; SingularMatrix
    static geometry::Result<Placement> of(const glm::dmat4 &worldFromObject);

    /// The ray in object space, with the same t.
    /// @return NotFinite, PointAtInfinity
    geometry::Result<Ray<geometry::ObjectSpace>> objectRay(const Ray<geometry::WorldSpace> &ray) const;
    /// The same in plain double, for many rays: the error is a few units in the last place of the
    /// world's coordinates.
    Ray<geometry::ObjectSpace> plainObjectRay(const Ray<geometry::WorldSpace> &ray) const;
    const glm::dmat4 &worldFromObject() const { return m_worldFromObject; }

private:
    Placement(const glm::dmat4 &worldFromObject, const unproject::ObjectFromWorld &objectFromWorld);

    glm::dmat4 m_worldFromObject;
    unproject::ObjectFromWorld m_objectFromWorld;
    glm::dmat3 m_plainInverse; ///< of the linear part
};

/// A placed model that rays can hit.
struct Target {
    std::size_t object; ///< index in the scene's list
    std::shared_ptr<const RayCaster> caster;
    Placement placement;
};

/// The corners of a triangle.
/// @param triangle  number in the model
std::array<geometry::WorldPoint, 3> worldCorners(const Target &target, std::uint32_t triangle);

/// The full hit at a location on a triangle.
/// @param triangle     number in the model
/// @param barycentric  of the location
/// @param ray          through it
/// @param eye          see SceneHit::distance
SceneHit hitOnTriangle(const Target &target, std::uint32_t triangle, const glm::dvec3 &barycentric,
                       const Ray<geometry::WorldSpace> &ray, const std::optional<geometry::WorldPoint> &eye);

/// The full hit at a point of a point cloud, see hitOnTriangle.
/// @param vertex  its number among the vertices of all meshes
SceneHit hitOnPoint(const Target &target, std::uint32_t vertex, const Ray<geometry::WorldSpace> &ray,
                    const std::optional<geometry::WorldPoint> &eye);

} // namespace unprojector::ray
