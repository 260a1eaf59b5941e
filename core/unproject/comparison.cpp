#include "core/unproject/comparison.h"

#include "core/unproject/picture_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace unprojector::unproject {

Comparison compareUnprojections(const ViewGeometry &g, const WindowPoint &window)
{
    return compareUnprojections(PictureGeometry{g.surface, g.viewport, g.depthRange, g.projection, g.camera}, window);
}

double ulpOfLargest(const glm::dvec3 &point)
{
    const double largest = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    return std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
}

} // namespace unprojector::unproject
