#include "core/clouds/depth_cloud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace unprojector::clouds {
using namespace geometry;
using namespace unproject;

namespace {

template <class Scalar>
bool isSafe(double number)
{
    return std::abs(number) < std::numeric_limits<Scalar>::max() / 4.0;
}

} // namespace

template <class Scalar>
bool canOverflow(const BatchUnprojection &unprojection, const Setup &g)
{
    const double w = g.surface.widthPixels, h = g.surface.heightPixels, n = g.depthRange.atNear, f = g.depthRange.atFar;
    const std::array<double, 8> px{0, w, 0, w, 0, w, 0, w}, py{0, 0, h, h, 0, 0, h, h}, depth{n, n, n, n, f, f, f, f};
    std::array<double, 8> x, y, z;
    unprojection(BatchInput<double>{px.data(), py.data(), depth.data()},
                 BatchOutput<double>{x.data(), y.data(), z.data()}, px.size());
    for (const auto &column : {x, y, z}) {
        for (const double value : column) {
            if (!isSafe<Scalar>(value))
                return true;
        }
    }
    return false;
}

template <class Scalar>
bool canOverflow(const PixelLines &lines, const Setup &setup, const ClipDistances &clip)
{
    for (const double px : {0.0, double(setup.surface.widthPixels)}) {
        for (const double py : {0.0, double(setup.surface.heightPixels)}) {
            const PixelLine line = lines.at(px, py);
            for (const double distance : {clip.atNear, clip.atFar}) {
                const glm::dvec3 point = line.start + distance * line.ahead;
                if (!isSafe<Scalar>(point.x) || !isSafe<Scalar>(point.y) || !isSafe<Scalar>(point.z))
                    return true;
            }
        }
    }
    return false;
}

template bool canOverflow<float>(const BatchUnprojection &, const Setup &);
template bool canOverflow<double>(const BatchUnprojection &, const Setup &);
template bool canOverflow<float>(const PixelLines &, const Setup &, const ClipDistances &);
template bool canOverflow<double>(const PixelLines &, const Setup &, const ClipDistances &);

Surfaces::Surfaces(const DepthRange &range)
{
    const auto atNear = static_cast<float>(range.atNear), atFar = static_cast<float>(range.atFar);
    const float beforeFar = std::nextafter(atFar, atNear);
    m_low = std::min(atNear, beforeFar);
    m_high = std::max(atNear, beforeFar);
    m_background = atFar;
}

void Surfaces::count(std::span<const float> depths, PixelCounts &counts) const
{
    const float low = m_low, high = m_high, background = m_background;
    std::uint32_t kept = 0, atFar = 0; // 32 bits and no branch, so that the compiler compares many depths at once
    for (const float depth : depths) {
        kept += std::uint32_t(depth >= low) & std::uint32_t(depth <= high);
        atFar += std::uint32_t(depth == background);
    }
    const auto add = [&](PixelKind kind, std::size_t count) { counts[static_cast<std::size_t>(kind)] += count; };
    add(PixelKind::Kept, kept);
    add(PixelKind::AtFar, atFar);
    if (kept + atFar == depths.size())
        return;
    for (const float depth : depths) {
        if (std::isnan(depth))
            add(PixelKind::NotANumber, 1);
        else if (std::isinf(depth))
            add(PixelKind::Infinite, 1);
        else if (!(depth >= low && depth <= high) && depth != background)
            add(PixelKind::OutsideRange, 1);
    }
}

template <class Scalar>
DepthCloud<Scalar>::DepthCloud(const BatchUnprojection &unprojection, const Setup &setup,
                               const images::NumberImage &image)
    : m_unprojection(unprojection), m_image(image), m_depths(std::get<std::unique_ptr<float[]>>(image.numbers).get()),
      m_surfaces(setup.depthRange), m_canOverflow(clouds::canOverflow<Scalar>(unprojection, setup))
{
}

template <class Scalar>
std::size_t DepthCloud<Scalar>::row(std::size_t j, Scalar *points) const
{
    const DevicePoint first = pixelCenter({0, static_cast<int>(j)});
    return m_unprojection(batch::DepthRow{m_depths + m_image.start(j), m_image.size.width, first.x, first.y,
                                          m_surfaces.lowest(), m_surfaces.highest(), m_canOverflow},
                          points);
}

template <class Scalar>
bool DistanceCloud::canOverflow(const Setup &setup, const ClipDistances &clip) const
{
    return m_rows.isOfWindow() ? clouds::canOverflow<Scalar>(m_unprojection, setup)
                               : clouds::canOverflow<Scalar>(m_lines, setup, clip);
}

template bool DistanceCloud::canOverflow<float>(const Setup &, const ClipDistances &) const;
template bool DistanceCloud::canOverflow<double>(const Setup &, const ClipDistances &) const;

void DistanceCloud::row(std::size_t j, PointRow &points) const
{
    m_rows.read(j, points.distances);
    const std::vector<double> &distances = points.distances.values;
    const std::size_t width = distances.size();
    for (std::vector<double> *column : {&points.px, &points.py, &points.x, &points.y, &points.z})
        column->resize(width);
    for (std::size_t i = 0; i < width; ++i) {
        const DevicePoint center = pixelCenter({static_cast<int>(i), static_cast<int>(j)});
        points.px[i] = center.x;
        points.py[i] = center.y;
    }
    if (m_rows.isOfWindow()) {
        m_unprojection(BatchInput<double>{points.px.data(), points.py.data(), distances.data()},
                       BatchOutput<double>{points.x.data(), points.y.data(), points.z.data()}, width);
        return;
    }
    for (std::size_t i = 0; i < width; ++i) {
        const PixelLine line = m_lines.at(points.px[i], points.py[i]);
        const glm::dvec3 point = line.start + distances[i] * line.ahead;
        points.x[i] = point.x;
        points.y[i] = point.y;
        points.z[i] = point.z;
    }
}

template class DepthCloud<float>;
template class DepthCloud<double>;

} // namespace unprojector::clouds
