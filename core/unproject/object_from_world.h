#pragma once

#include "core/geometry/precise_matrix.h"
#include "core/geometry/result.h"
#include "core/geometry/spaces.h"

namespace unprojector::unproject {

/// Converts from world space to an object's space, prepared once for the object.
class ObjectFromWorld {
public:
    /// @param worldFromObject  affine
    /// @return NotFinite; SingularMatrix
    static geometry::Result<ObjectFromWorld> of(const geometry::PreciseMatrix &worldFromObject);

    /// The solution x of worldFromObject x = world, computed with about 30 digits and rounded once.
    /// @return NotFinite; PointAtInfinity if it leaves the range of doubles
    geometry::Result<geometry::ObjectPoint> at(const geometry::PrecisePoint<geometry::WorldSpace> &world) const;
    /// The same for a vector, without the translation.
    geometry::Result<geometry::Vector<geometry::ObjectSpace>> at(const geometry::WorldVector &world) const;

    const geometry::PreciseMatrix &worldFromObject() const { return m_worldFromObject; }
    const geometry::PreciseMatrix &matrix() const { return m_objectFromWorld; }

private:
    explicit ObjectFromWorld(const geometry::PreciseMatrix &worldFromObject);

    geometry::PreciseMatrix m_worldFromObject, m_objectFromWorld;
};

/// ObjectFromWorld::of and at, for a single point.
geometry::Result<geometry::ObjectPoint> objectFromWorld(const geometry::PreciseMatrix &worldFromObject,
                                                        const geometry::PrecisePoint<geometry::WorldSpace> &world);

} // namespace unprojector::unproject
