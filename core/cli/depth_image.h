#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace unprojector {

/// Depths of a whole picture in the depth range, row by row from the top, as read: NaN where the file has one.
struct DepthImage {
    std::size_t width = 0, height = 0;
    std::vector<float> depths;
};

/// Reads a depth image; what is wrong is said on stderr.
///
///   PFM ("Pf")         floats, either byte order, rows from the bottom
///   PGM ("P5")         8 or 16 bits, rows from the top; 0 is depthLow and the file's greatest value depthHigh
///   anything else      raw 32-bit floats, little-endian, rows from the top, of the size given
///
/// @param size  "WxH"; needed for raw floats, otherwise checked against the file's where it is given
/// @param expectedWidth, expectedHeight  of the window; a picture of another size is refused before its memory is taken
std::optional<DepthImage> readDepthImage(const std::string &file, const std::string &size, std::size_t expectedWidth,
                                         std::size_t expectedHeight, double depthLow, double depthHigh);

} // namespace unprojector
