#include "core/cli/rows/depth_cloud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace unprojector::cli {
using namespace geometry;
using namespace unproject;

namespace {

/// True if a corner of the window, at either end of the depth range, has a coordinate near the
/// limit of Scalar. The numbers of all other pixels and depths lie between the corners'.
template <class Scalar>
bool someCornerIsHuge(const BatchUnprojection &unprojection, const Setup &g)
{
    const double w = g.surface.widthPixels, h = g.surface.heightPixels, n = g.depthRange.atNear, f = g.depthRange.atFar;
    const std::array<double, 8> px{0, w, 0, w, 0, w, 0, w}, py{0, 0, h, h, 0, 0, h, h}, depth{n, n, n, n, f, f, f, f};
    std::array<double, 8> x, y, z;
    unprojection(BatchInput<double>{px.data(), py.data(), depth.data()},
                 BatchOutput<double>{x.data(), y.data(), z.data()}, px.size());
    constexpr double kSafe = std::numeric_limits<Scalar>::max() / 4.0;
    for (const auto &column : {x, y, z}) {
        for (const double value : column) {
            if (!(std::abs(value) < kSafe))
                return true;
        }
    }
    return false;
}

} // namespace

Surfaces::Surfaces(const DepthRange &range)
{
    const auto atNear = static_cast<float>(range.atNear), atFar = static_cast<float>(range.atFar);
    const float beforeFar = std::nextafter(atFar, atNear);
    m_low = std::min(atNear, beforeFar);
    m_high = std::max(atNear, beforeFar);
}

std::size_t Surfaces::countIn(std::span<const float> depths) const
{
    const float low = m_low, high = m_high;
    std::uint32_t count = 0; // 32 bits and no branch, so that the compiler compares many depths at once
    for (const float depth : depths)
        count += std::uint32_t(depth >= low) & std::uint32_t(depth <= high);
    return count;
}

template <class Scalar>
DepthCloud<Scalar>::DepthCloud(const BatchUnprojection &unprojection, const Setup &setup, const DepthImage &image)
    : m_unprojection(unprojection), m_image(image), m_surfaces(setup.depthRange),
      m_canOverflow(someCornerIsHuge<Scalar>(unprojection, setup))
{
}

template <class Scalar>
std::size_t DepthCloud<Scalar>::row(std::size_t j, Scalar *points) const
{
    const DevicePoint first = pixelCenter({0, static_cast<int>(j)});
    return m_unprojection(batch::DepthRow{m_image.row(j), m_image.width, first.x, first.y, m_surfaces.lowest(),
                                          m_surfaces.highest(), m_canOverflow},
                          points);
}

template class DepthCloud<float>;
template class DepthCloud<double>;

} // namespace unprojector::cli
