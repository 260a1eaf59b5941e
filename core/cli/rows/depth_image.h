#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace unprojector::cli {

/// Depths of a whole picture in the depth range, as read: NaN where the file has one.
struct DepthImage {
    std::size_t width = 0, height = 0;
    std::unique_ptr<float[]> depths; ///< all of them, row after row in the file's order
    bool isBottomFirst = false;      ///< that order

    /// The row j, counted from the top.
    const float *row(std::size_t j) const { return depths.get() + (isBottomFirst ? height - 1 - j : j) * width; }
};

/// From one byte order to the other.
void swapBytes(std::span<float> values);
void swapBytes(std::span<double> values);

/// The ends of a depth range, the lower number first.
struct DepthEnds {
    double low = 0.0, high = 1.0;
};

/// Reads a depth image; what is wrong is said on stderr.
///
///   PFM ("Pf")         floats, either byte order, rows from the bottom
///   PGM ("P5")         8 or 16 bits, rows from the top; the numbers are those of the file over its greatest value
///   anything else      raw 32-bit floats, little-endian, rows from the top, of the size given
///
/// @param stretchedOver  where 0 and 1 of the numbers lie; nothing: the numbers are depths as they are
/// @param onRead  gets all depths, some at a time as they come, while they are still in the processor's cache
/// @param size  "WxH"; needed for raw floats, otherwise checked against the file's where it is given
/// @param expectedWidth, expectedHeight  of the window; a picture of another size is refused before its memory is taken
std::optional<DepthImage> readDepthImage(const std::string &file, const std::string &size, std::size_t expectedWidth,
                                         std::size_t expectedHeight, const std::optional<DepthEnds> &stretchedOver,
                                         const std::function<void(std::span<const float>)> &onRead);

} // namespace unprojector::cli
