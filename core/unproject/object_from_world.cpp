#include "core/unproject/object_from_world.h"

#include "core/geometry/condition_number.h"
#include "core/geometry/finite.h"

namespace unprojector::unproject {
using namespace geometry;
namespace {

/// Counted from the object's origin, where the digits of both cancel before they are multiplied.
Result<glm::dvec3> solved(const PreciseMatrix &objectFromWorld, const DoubleDouble3 &fromOrigin)
{
    const DoubleDouble3 p = objectFromWorld.turned(fromOrigin);
    const glm::dvec3 point(p[0].value, p[1].value, p[2].value);
    if (!isFinite(point))
        return Error{ErrorCode::PointAtInfinity};
    return point;
}

} // namespace

ObjectFromWorld::ObjectFromWorld(const PreciseMatrix &worldFromObject)
    : m_worldFromObject(worldFromObject), m_objectFromWorld(worldFromObject.affineInverse())
{
}

Result<ObjectFromWorld> ObjectFromWorld::of(const PreciseMatrix &worldFromObject)
{
    const glm::dmat4 rounded = worldFromObject.rounded();
    if (const auto value = firstNotFinite(rounded))
        return Error{ErrorCode::NotFinite, *value};
    if (isSingular(rounded))
        return Error{ErrorCode::SingularMatrix};
    return ObjectFromWorld(worldFromObject);
}

Result<ObjectPoint> ObjectFromWorld::at(const PrecisePoint<WorldSpace> &world) const
{
    if (const auto value = firstNotFinite(world.rounded()))
        return Error{ErrorCode::NotFinite, *value};
    const auto &origin = m_worldFromObject.columns[3];
    const Result<glm::dvec3> point =
        solved(m_objectFromWorld, {world.x - origin[0], world.y - origin[1], world.z - origin[2]});
    if (!point)
        return point.error();
    return ObjectPoint(*point);
}

Result<Vector<ObjectSpace>> ObjectFromWorld::at(const WorldVector &world) const
{
    if (const auto value = firstNotFinite(world))
        return Error{ErrorCode::NotFinite, *value};
    const Result<glm::dvec3> vector = solved(m_objectFromWorld, {world.x, world.y, world.z});
    if (!vector)
        return vector.error();
    return Vector<ObjectSpace>(*vector);
}

Result<ObjectPoint> objectFromWorld(const PreciseMatrix &worldFromObject, const PrecisePoint<WorldSpace> &world)
{
    const Result<ObjectFromWorld> prepared = ObjectFromWorld::of(worldFromObject);
    if (!prepared)
        return prepared.error();
    return prepared->at(world);
}

} // namespace unprojector::unproject
