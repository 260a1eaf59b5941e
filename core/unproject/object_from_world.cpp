#include "core/unproject/object_from_world.h"

#include "core/geometry/condition_number.h"
#include "core/geometry/double_double.h"
#include "core/geometry/finite.h"

#include <glm/matrix.hpp>

namespace unprojector::unproject {
using namespace geometry;

ObjectFromWorld::ObjectFromWorld(const glm::dmat4 &worldFromObject)
    : m_worldFromObject(worldFromObject), m_inverse(glm::inverse(glm::dmat3(worldFromObject)))
{
}

Result<ObjectFromWorld> ObjectFromWorld::of(const glm::dmat4 &worldFromObject)
{
    if (const auto value = firstNotFinite(worldFromObject))
        return Error{ErrorCode::NotFinite, *value};
    if (isSingular(worldFromObject))
        return Error{ErrorCode::SingularMatrix};
    return ObjectFromWorld(worldFromObject);
}

Result<glm::dvec3> ObjectFromWorld::solved(const glm::dvec3 &world, const glm::dvec3 &translation) const
{
    if (const auto value = firstNotFinite(world))
        return Error{ErrorCode::NotFinite, *value};
    const glm::dmat4 &m = m_worldFromObject;
    DoubleDouble3 p;
    for (int i = 0; i < 3; ++i) { // each step multiplies the error by the inverse's relative error
        glm::dvec3 left;
        for (int row = 0; row < 3; ++row) {
            const DoubleDouble3 entries{m[0][row], m[1][row], m[2][row]};
            left[row] = (DoubleDouble(world[row]) - translation[row] - dot(entries, p)).value;
        }
        const glm::dvec3 step = m_inverse * left;
        for (int k = 0; k < 3; ++k)
            p[std::size_t(k)] = p[std::size_t(k)] + DoubleDouble(step[k]);
    }
    const glm::dvec3 point(p[0].value, p[1].value, p[2].value);
    if (!isFinite(point))
        return Error{ErrorCode::PointAtInfinity};
    return point;
}

Result<ObjectPoint> ObjectFromWorld::at(const WorldPoint &world) const
{
    const Result<glm::dvec3> point = solved(world.coordinates(), glm::dvec3(m_worldFromObject[3]));
    if (!point)
        return point.error();
    return ObjectPoint(*point);
}

Result<Vector<ObjectSpace>> ObjectFromWorld::at(const WorldVector &world) const
{
    const Result<glm::dvec3> vector = solved(world.coordinates(), glm::dvec3(0.0));
    if (!vector)
        return vector.error();
    return Vector<ObjectSpace>(*vector);
}

Result<ObjectPoint> objectFromWorld(const glm::dmat4 &worldFromObject, const WorldPoint &world)
{
    const Result<ObjectFromWorld> prepared = ObjectFromWorld::of(worldFromObject);
    if (!prepared)
        return prepared.error();
    return prepared->at(world);
}

} // namespace unprojector::unproject
