#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace unprojector::cli {

/// Depths of all pixels of a view in the depth range, as read: NaN where the file has one.
struct DepthImage {
    std::size_t width = 0, height = 0;
    std::unique_ptr<float[]> depths; ///< all of them, row after row in the file's order
    bool isBottomFirst = false;      ///< rows are stored from the bottom

    /// The row j, counted from the top.
    const float *row(std::size_t j) const { return depths.get() + (isBottomFirst ? height - 1 - j : j) * width; }
};

/// Converts from one byte order to the other.
void swapBytes(std::span<float> values);
void swapBytes(std::span<double> values);

/// The ends of a depth range, the lower number first.
struct DepthEnds {
    double low = 0.0, high = 1.0;
};

/// Reads a depth image; prints errors on stderr.
///
///   PFM ("Pf")         floats, either byte order, rows from the bottom
///   PGM ("P5")         8 or 16 bits, rows from the top; the file's numbers over its greatest value
///   anything else      raw 32-bit floats, little-endian, rows from the top, of the given size
///
/// @param stretchedOver  the depths of the numbers 0 and 1; empty: the numbers are depths already
/// @param onRead  receives all depths in portions, while they are still in the processor's cache
/// @param size  "WxH"; needed for raw floats, otherwise checked against the file's if given
/// @param expectedWidth, expectedHeight  of the window; an image of another size is rejected before
///         memory is allocated
std::optional<DepthImage> readDepthImage(const std::string &file, const std::string &size, std::size_t expectedWidth,
                                         std::size_t expectedHeight, const std::optional<DepthEnds> &stretchedOver,
                                         const std::function<void(std::span<const float>)> &onRead);

} // namespace unprojector::cli
