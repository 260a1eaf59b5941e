#pragma once

#include "core/cli/rows/byte_stream.h"
#include "core/images/number_image.h"

#include <bit>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace unprojector::cli {

struct DepthImageChoices {
    std::optional<images::PixelSize> size; ///< needed for raw floats, otherwise checked against the file's
    std::string channel;                   ///< of OpenEXR; empty: by its name
    std::optional<std::endian> byteOrder;  ///< of PGM and raw floats; empty: the usual one
};

/// Reads a depth image, see images::readNumberImage; prints notes on stderr, refuses on errors.
/// @param window  size of the scene's window; an image of another size is refused before memory is
///         allocated
/// @param onRead  receives the number of pixels read since the last call
images::NumberImage readDepthImage(const std::string &file, const DepthImageChoices &choices,
                                   const images::PixelSize &window, const std::function<void(std::size_t)> &onRead);

/// Reads the colors of the same pixels, see images::readColorImage.
images::ColorImage readColors(const std::string &file, const images::PixelSize &window);

} // namespace unprojector::cli
