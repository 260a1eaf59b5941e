#pragma once

#include "core/clouds/depth_numbers.h"
#include "core/images/number_image.h"
#include "core/unproject/batch/batch_unproject.h"

#include <cstddef>
#include <span>
#include <vector>

namespace unprojector::clouds {

/// Selects the depths of surfaces: inside the range, and not the clear value, which is the far
/// end's.
class Surfaces {
public:
    explicit Surfaces(const geometry::DepthRange &range);

    float lowest() const { return m_low; }
    float highest() const { return m_high; }
    /// Adds the depths of a row to the counts of their kinds.
    void count(std::span<const float> depths, PixelCounts &counts) const;

private:
    float m_low, m_high, m_background;
};

/// True if a corner of the window, at either end of the depth range, has a coordinate near the limit
/// of Scalar. The numbers of all other pixels and depths lie between the corners'.
template <class Scalar>
bool canOverflow(const unproject::BatchUnprojection &unprojection, const geometry::Setup &setup);
/// The same for distances.
template <class Scalar>
bool canOverflow(const unproject::PixelLines &lines, const geometry::Setup &setup,
                 const unproject::ClipDistances &clip);

/// Computes the points under the pixels of an image of window depths in single precision, a row at
/// a time, so that all data stays in the processor's cache.
/// @tparam Scalar  float or double
template <class Scalar>
class DepthCloud {
public:
    /// @param image  floats; kept by reference; has the size of the setup's surface
    DepthCloud(const unproject::BatchUnprojection &unprojection, const geometry::Setup &setup,
               const images::NumberImage &image);

    /// True if the numbers of some pixel could exceed the range of Scalar.
    bool canOverflow() const { return m_canOverflow; }

    /// @param j  row index from the top
    /// @param points  room for as many points as the row has pixels: x, y, z one after the other.
    ///         Space behind the last point kept is scratch.
    /// @return how many points of the row are on a surface and have finite coordinates
    std::size_t row(std::size_t j, Scalar *points) const;

private:
    unproject::BatchUnprojection m_unprojection;
    const images::NumberImage &m_image;
    const float *m_depths;
    Surfaces m_surfaces;
    bool m_canOverflow;
};

/// The points of a row of pixels, one a pixel.
struct PointRow {
    DistanceRow distances;
    std::vector<double> coordinates; ///< x, y, z of each pixel; scratch where it is not kept
};

/// Computes the points under the pixels of an image of any numbers, a row at a time, in double
/// precision.
class DistanceCloud {
public:
    /// @param rows, lines  kept by reference
    DistanceCloud(const unproject::BatchUnprojection &unprojection, const unproject::PixelLines &lines,
                  const DepthRows &rows)
        : m_unprojection(unprojection), m_lines(lines), m_rows(rows)
    {
    }

    /// True if the numbers of some pixel could exceed the range of Scalar.
    /// @param clip  of the setup; not used for window depths
    template <class Scalar>
    bool canOverflow(const geometry::Setup &setup, const unproject::ClipDistances &clip) const;

    /// @param j  row index from the top
    void row(std::size_t j, PointRow &points) const;

private:
    unproject::BatchUnprojection m_unprojection;
    const unproject::PixelLines &m_lines;
    const DepthRows &m_rows;
};

} // namespace unprojector::clouds
