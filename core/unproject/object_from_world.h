#pragma once

#include "core/geometry/result.h"
#include "core/geometry/spaces.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

namespace unprojector::unproject {

/// Converts from world space to an object's space, prepared once for the object.
class ObjectFromWorld {
public:
    /// @param worldFromObject  affine
    /// @return NotFinite; SingularMatrix
    static geometry::Result<ObjectFromWorld> of(const glm::dmat4 &worldFromObject);

    /// The solution x of worldFromObject x = world, refined with about 30 digits and rounded once.
    /// @return NotFinite; PointAtInfinity if it leaves the range of doubles
    geometry::Result<geometry::ObjectPoint> at(const geometry::WorldPoint &world) const;
    /// The same for a vector, without the translation.
    geometry::Result<geometry::Vector<geometry::ObjectSpace>> at(const geometry::WorldVector &world) const;

private:
    explicit ObjectFromWorld(const glm::dmat4 &worldFromObject);
    geometry::Result<glm::dvec3> solved(const glm::dvec3 &world, const glm::dvec3 &translation) const;

    glm::dmat4 m_worldFromObject;
    glm::dmat3 m_inverse;
};

/// ObjectFromWorld::of and at, for a single point.
geometry::Result<geometry::ObjectPoint> objectFromWorld(const glm::dmat4 &worldFromObject,
                                                        const geometry::WorldPoint &world);

} // namespace unprojector::unproject
