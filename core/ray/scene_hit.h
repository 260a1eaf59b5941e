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
#include <optional>

namespace unprojector::ray {

struct NearVertex {
    std::uint32_t id = 0; ///< its number in the file, see Model::vertexNumber
    geometry::WorldPoint world;
    double distance = 0.0; ///< from the hit, world units
    /// How far each coordinate may be off what the file says, at most, for the arithmetic in double.
    geometry::WorldVector uncertainty = {};
};

/// An edge of the triangle that was hit.
struct NearEdge {
    std::array<std::uint32_t, 2> ids{};     ///< of its vertices, as NearVertex has them
    geometry::WorldPoint world;             ///< its point nearest to the hit
    double distance = 0.0;                  ///< from the hit, world units
    geometry::WorldVector uncertainty = {}; ///< of that point, as a vertex's: how far the edge may be off the file's
};

/// Of a triangle that was hit.
struct TriangleDetail {
    /// Counted through all meshes of its model from 0, in the order in which these hold them: that of the file, polygons cut where
    /// they stand; where a file's faces are parted by material, material after material.
    std::uint32_t triangle = 0;
    glm::dvec3 barycentric{0.0};        ///< of the hit, of its three corners; their sum is 1
    std::array<std::uint32_t, 3> ids{}; ///< of the corners' vertices
    /// World space, length 1: the side from which the corners go round counter-clockwise in the file. As normals do, it stays
    /// outside where a transform mirrors the object.
    geometry::WorldVector normal;
    NearEdge edge; ///< the nearest
};

/// Where a ray meets an object of a scene.
struct SceneHit {
    std::size_t object = 0; ///< place in the scene's list
    double t = 0.0;         ///< of the ray in world space
    geometry::ObjectPoint objectPoint;
    geometry::WorldPoint world;
    /// From the eye, along the ray, world units; where there is none (a box, a matrix that is no known projection) from the
    /// near plane.
    double distance = 0.0;
    std::optional<TriangleDetail> triangle; ///< nothing: a point of a point cloud
    NearVertex vertex;                      ///< the triangle's nearest; or the point itself
    /// How far each coordinate of `world` may be off what the file says, at most, to first order: for the arithmetic in double,
    /// carried along the ray to the surface; where that is nearly edge on, little can be said. The position in the picture
    /// counts as exact: how much of the surface a pixel covers is not in it.
    geometry::WorldVector uncertainty;
};

/// How an object lies in the world, prepared for hits.
class Placement {
public:
    /// @param worldFromObject  affine
    /// @return NotFinite; SingularMatrix
    static geometry::Result<Placement> of(const glm::dmat4 &worldFromObject);

    /// The same ray in object space, with the same t.
    /// @return NotFinite, PointAtInfinity
    geometry::Result<Ray<geometry::ObjectSpace>> objectRay(const Ray<geometry::WorldSpace> &ray) const;
    /// The same in plain double, for many rays: off by a few units in the last place of the world's coordinates.
    Ray<geometry::ObjectSpace> plainObjectRay(const Ray<geometry::WorldSpace> &ray) const;
    const glm::dmat4 &worldFromObject() const { return m_worldFromObject; }

private:
    Placement(const glm::dmat4 &worldFromObject, const unproject::ObjectFromWorld &objectFromWorld);

    glm::dmat4 m_worldFromObject;
    unproject::ObjectFromWorld m_objectFromWorld;
    glm::dmat3 m_plainInverse; ///< of its linear part
};

/// The corners of a triangle of a placed model.
/// @param triangle  number in the model
std::array<geometry::WorldPoint, 3> worldCorners(const RayCaster &caster, const Placement &placement,
                                                 std::uint32_t triangle);

/// A place on a triangle of a placed model, all about it.
/// @param triangle     number in the model
/// @param barycentric  of the place
/// @param ray          through it
/// @param eye          see SceneHit::distance
/// `object` is left to the caller.
SceneHit hitOnTriangle(const RayCaster &caster, const Placement &placement, std::uint32_t triangle,
                       const glm::dvec3 &barycentric, const Ray<geometry::WorldSpace> &ray,
                       const std::optional<geometry::WorldPoint> &eye);

/// A point of a point cloud, as hitOnTriangle.
/// @param vertex  place among those of all meshes
SceneHit hitOnPoint(const RayCaster &caster, const Placement &placement, std::uint32_t vertex,
                    const Ray<geometry::WorldSpace> &ray, const std::optional<geometry::WorldPoint> &eye);

} // namespace unprojector::ray
