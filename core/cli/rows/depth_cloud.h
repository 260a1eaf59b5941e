#pragma once

#include "core/cli/rows/depth_image.h"
#include "core/unproject/batch/batch_unproject.h"

#include <span>

namespace unprojector::cli {

/// Selects the depths of surfaces: inside the range, and not the clear value, which is the far
/// end's.
class Surfaces {
public:
    explicit Surfaces(const geometry::DepthRange &range);

    float lowest() const { return m_low; }
    float highest() const { return m_high; }
    std::size_t countIn(std::span<const float> depths) const;

private:
    float m_low, m_high;
};

/// Computes the points under the pixels of a depth image, a row at a time, so that all data stays
/// in the processor's cache.
/// @tparam Scalar  float or double
template <class Scalar>
class DepthCloud {
public:
    /// @param image  kept by reference; has the size of the setup's surface
    DepthCloud(const unproject::BatchUnprojection &unprojection, const geometry::Setup &setup, const DepthImage &image);

    /// True if the numbers of some pixel could exceed the range of Scalar.
    bool canOverflow() const { return m_canOverflow; }

    /// @param j  row index from the top
    /// @param points  room for as many points as the row has pixels: x, y, z one after the other.
    ///         Space behind the last point kept is scratch.
    /// @return how many points of the row are on a surface and have finite coordinates
    std::size_t row(std::size_t j, Scalar *points) const;

private:
    unproject::BatchUnprojection m_unprojection;
    const DepthImage &m_image;
    Surfaces m_surfaces;
    bool m_canOverflow;
};

} // namespace unprojector::cli
