#include "core/maps/pixel_rays.h"

#include "core/geometry/finite.h"
#include "core/maps/map_points.h"

#include <cmath>
#include <limits>

namespace unprojector::maps {
using namespace geometry;
using namespace unproject;

PixelRays::PixelRays(const BatchUnprojection &unprojection, const Setup &setup, const DepthRange &depths)
    : m_unprojection(unprojection), m_width(static_cast<std::size_t>(setup.surface.widthPixels)), m_depths(depths),
      m_high(1.0)
{
    const Viewport &v = setup.viewport;
    const DevicePoint at = deviceFromWindow(setup.surface, WindowPoint(v.x + v.width / 2.0, v.y + v.height / 2.0, 0.0));
    ElementArrays middle;
    middle.add(at, depths.atFar);
    if (!isFinite(middle.unprojected(m_unprojection).world(0))) {
        m_depths.atFar = depths.atNear / 2.0 + depths.atFar / 2.0;
        m_high = std::numeric_limits<double>::infinity();
    }
}

Result<PixelRays> PixelRays::of(const ray::ClickRays &rays)
{
    const Setup &setup = rays.setup();
    const Result<BatchUnprojection> unprojection = rays.method() == Method::Formula
                                                       ? BatchUnprojection::byFormula(setup, {})
                                                       : BatchUnprojection::byMatrix(setup, {});
    if (!unprojection)
        return unprojection.error();
    return PixelRays(*unprojection, setup, rays.depths());
}

std::vector<ray::Ray<WorldSpace>> PixelRays::ofRow(int row) const
{
    ElementArrays elements;
    for (std::size_t i = 0; i < m_width; ++i)
        elements.add(pixelCenter({static_cast<int>(i), row}), m_depths.atNear);
    const PointArrays from = elements.unprojected(m_unprojection);
    elements.depth.assign(m_width, m_depths.atFar);
    const PointArrays to = elements.unprojected(m_unprojection);
    std::vector<ray::Ray<WorldSpace>> rays(m_width);
    for (std::size_t i = 0; i < m_width; ++i)
        rays[i] = {from.world(i), to.world(i) - from.world(i), 0.0, m_high};
    return rays;
}

} // namespace unprojector::maps
