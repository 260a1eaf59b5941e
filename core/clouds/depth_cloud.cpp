#include "core/clouds/depth_cloud.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

namespace unprojector::clouds {
using namespace geometry;
using namespace unproject;

namespace {

/// True if a corner of the window has a coordinate near the limit of Scalar.
/// @param at  the point of a device position at an end of the range
template <class Scalar, class PointAt>
bool reachesLimit(const Setup &setup, std::initializer_list<double> ends, const PointAt &at)
{
    constexpr double kSafe = std::numeric_limits<Scalar>::max() / 4.0;
    for (const double px : {0.0, double(setup.surface.widthPixels)}) {
        for (const double py : {0.0, double(setup.surface.heightPixels)}) {
            for (const double end : ends) {
                const glm::dvec3 point = at(px, py, end);
                if (!glm::all(glm::lessThan(glm::abs(point), glm::dvec3(kSafe))))
                    return true;
            }
        }
    }
    return false;
}

} // namespace

template <class Scalar>
bool canOverflow(const BatchUnprojection &unprojection, const Setup &setup)
{
    return reachesLimit<Scalar>(
        setup, {setup.depthRange.atNear, setup.depthRange.atFar}, [&](double px, double py, double depth) {
            glm::dvec3 p;
            unprojection(BatchInput<double>{&px, &py, &depth}, BatchOutput<double>{&p.x, &p.y, &p.z}, 1);
            return p;
        });
}

template <class Scalar>
bool canOverflow(const PixelLines &lines, const Setup &setup, const ClipDistances &clip)
{
    return reachesLimit<Scalar>(setup, {clip.atNear, clip.atFar}, [&](double px, double py, double distance) {
        const PixelLine line = lines.at(px, py);
        return line.start + distance * line.ahead;
    });
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
    points.coordinates.resize(3 * distances.size());
    const DevicePoint first = pixelCenter({0, static_cast<int>(j)});
    const batch::DepthLine line{distances.data(), distances.size(), first.x, first.y};
    if (m_rows.isOfWindow())
        m_unprojection.line(line, points.coordinates.data());
    else
        m_lines.line(line, points.coordinates.data());
}

template class DepthCloud<float>;
template class DepthCloud<double>;

} // namespace unprojector::clouds
