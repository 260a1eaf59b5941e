#include "core/scene/reach.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace unprojector::scene {
using namespace geometry;

Check reachable(const SceneObject &object)
{
    const Box own = object.model ? object.model->bounds : Box();
    if (own.isEmpty() || object.transform.empty()) // single precision cannot reach that far
        return std::monostate{};
    const Box box = boundsOf(object);
    for (const glm::dvec3 &corner : {box.lowest, box.highest}) {
        for (int axis = 0; axis < 3; ++axis) {
            if (!(std::abs(corner[axis]) <= kFarthestWorld))
                return Error{ErrorCode::ObjectTooFar, corner[axis]};
        }
    }
    const glm::dvec3 size = box.highest - box.lowest;
    const double largest = std::max({size.x, size.y, size.z});
    const bool isPoint = own.highest == own.lowest;
    // Far away, an object's size may be lost in its coordinates; this does not depend on its scale.
    const bool isLost = largest == 0.0 && box.lowest != glm::dvec3(0.0);
    if (!isPoint && !isLost && largest < 1.0 / kFarthestWorld)
        return Error{ErrorCode::ObjectTooSmall, std::max(largest, std::numeric_limits<double>::denorm_min())};
    return std::monostate{};
}

} // namespace unprojector::scene
