#include "core/maps/pixel_rays.h"

#include <cmath>
#include <limits>

namespace unprojector::maps {
using namespace geometry;
using namespace unproject;

namespace {

/// Room for a row of points.
struct Points {
    std::vector<double> px, py, depth, x, y, z;

    explicit Points(std::size_t count) : px(count), py(count), depth(count), x(count), y(count), z(count) {}
    BatchInput<double> input() const { return {px.data(), py.data(), depth.data()}; }
    BatchOutput<double> output() { return {x.data(), y.data(), z.data()}; }
    WorldPoint point(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

} // namespace

PixelRays::PixelRays(const BatchUnprojection &unprojection, const Setup &setup, const DepthRange &depths)
    : m_unprojection(unprojection), m_width(static_cast<std::size_t>(setup.surface.widthPixels)), m_depths(depths),
      m_high(1.0)
{
    Points middle(1);
    const Viewport &v = setup.viewport;
    const DevicePoint at = deviceFromWindow(setup.surface, WindowPoint(v.x + v.width / 2.0, v.y + v.height / 2.0, 0.0));
    middle.px[0] = at.x;
    middle.py[0] = at.y;
    middle.depth[0] = depths.atFar;
    m_unprojection(middle.input(), middle.output(), 1);
    if (!std::isfinite(middle.x[0] + middle.y[0] + middle.z[0])) {
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

void PixelRays::ofRow(int row, std::vector<ray::Ray<WorldSpace>> &rays) const
{
    Points from(m_width);
    for (std::size_t i = 0; i < m_width; ++i) {
        const DevicePoint center = pixelCenter({static_cast<int>(i), row});
        from.px[i] = center.x;
        from.py[i] = center.y;
        from.depth[i] = m_depths.atNear;
    }
    Points to = from;
    to.depth.assign(m_width, m_depths.atFar);
    m_unprojection(from.input(), from.output(), m_width);
    m_unprojection(to.input(), to.output(), m_width);
    rays.resize(m_width);
    for (std::size_t i = 0; i < m_width; ++i)
        rays[i] = {from.point(i), to.point(i) - from.point(i), 0.0, m_high};
}

} // namespace unprojector::maps
