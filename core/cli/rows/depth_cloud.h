#pragma once

#include "core/cli/rows/depth_image.h"
#include "core/unproject/batch/batch_unproject.h"

#include <span>

namespace unprojector::cli {

/// Which depths are of a surface: inside the range, and not the one that the buffer was cleared to, the far end's.
class Surfaces {
public:
    explicit Surfaces(const geometry::DepthRange &range);

    float lowest() const { return m_low; }
    float highest() const { return m_high; }
    std::size_t countIn(std::span<const float> depths) const;

private:
    float m_low, m_high;
};

/// The points under the pixels of a depth image, a row at a time, so that everything stays in the processor's cache.
/// @tparam Scalar  float or double
template <class Scalar>
class DepthCloud {
public:
    /// @param image  kept by reference; as large as the picture's surface
    DepthCloud(const unproject::BatchUnprojection &unprojection, const geometry::Setup &setup, const DepthImage &image);

    /// Whether the numbers of some pixel could leave the range of Scalar.
    bool canOverflow() const { return m_canOverflow; }

    /// @param j  from the top
    /// @param points  room for as many points as the row has pixels: x, y, z one after the other. Those behind the
    ///        last one kept are scratch.
    /// @return how many points of the row are of a surface and have finite coordinates
    std::size_t row(std::size_t j, Scalar *points) const;

private:
    unproject::BatchUnprojection m_unprojection;
    const DepthImage &m_image;
    Surfaces m_surfaces;
    bool m_canOverflow;
};

} // namespace unprojector::cli
