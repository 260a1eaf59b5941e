#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace unprojector::images {

/// The orientation of an Exif segment: 1 is upright, 2 to 8 are turned or mirrored.
/// @param segment  the content of a JPEG's APP1, beginning with "Exif"
/// @return nothing for another segment, one without an orientation, or a damaged one
std::optional<int> exifOrientation(std::span<const std::uint8_t> segment);

} // namespace unprojector::images
