#include "core/geometry/box.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace unprojector::geometry {

void Box::add(const glm::dvec3 &point)
{
    if (isEmpty()) {
        lowest = point;
        highest = point;
        return;
    }
    lowest = glm::min(lowest, point);
    highest = glm::max(highest, point);
}

void Box::add(const Box &other)
{
    if (other.isEmpty())
        return;
    add(other.lowest);
    add(other.highest);
}

double Box::diagonal() const
{
    return isEmpty() ? 0.0 : glm::length(highest - lowest);
}

Box Box::transformed(const glm::dmat4 &targetFromSource) const
{
    Box box;
    if (isEmpty())
        return box;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 point(corner & 1 ? highest.x : lowest.x, corner & 2 ? highest.y : lowest.y,
                               corner & 4 ? highest.z : lowest.z, 1.0);
        const glm::dvec4 target = targetFromSource * point;
        box.add(glm::dvec3(target) / target.w);
    }
    return box;
}

} // namespace unprojector::geometry
