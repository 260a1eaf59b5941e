#pragma once

#include "core/base/error.h"
#include "core/base/expected.h"
#include "core/images/image_bytes.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// Readers of images of numbers (depths, distances) and of colors.
namespace unprojector::images {

struct PixelSize {
    std::size_t width = 0, height = 0;
    std::size_t pixels() const { return width * height; }
    friend bool operator==(const PixelSize &, const PixelSize &) = default;
};

/// "640x480".
std::string sizeText(const PixelSize &size);

/// The longest side of an image that is read.
constexpr std::size_t kMostSide = 65536;

/// One number a pixel, in the type of the file.
struct NumberImage {
    /// The numbers of all pixels, row after row.
    using Numbers = std::variant<std::unique_ptr<std::uint8_t[]>, std::unique_ptr<std::uint16_t[]>,
                                 std::unique_ptr<float[]>, std::unique_ptr<double[]>>;

    PixelSize size;
    Numbers numbers;
    double greatest = 0.0;          ///< of whole numbers: the greatest possible one; 0: fractions
    bool isBottomFirst = false;     ///< rows are stored from the bottom
    std::vector<std::string> notes; ///< what was chosen or ignored, in the language of base::tr()

    /// The index of the first number of row j, counted from the top.
    std::size_t start(std::size_t j) const { return (isBottomFirst ? size.height - 1 - j : j) * size.width; }
};

/// Red, green, blue of each pixel, row after row from the top, 8 bits each.
struct ColorImage {
    PixelSize size;
    std::unique_ptr<std::uint8_t[]> colors;
    std::vector<std::string> notes;
};

/// The caller's functions, which a reader calls while it reads.
struct ImageRequest {
    /// The size of raw floats; empty: a file that is of no known format is refused.
    std::optional<PixelSize> rawSize;
    /// The channel of an OpenEXR image; empty: the one with a name of depths.
    std::string channel;
    /// The byte order of a PGM of 16 bits and of raw floats; empty: big for PGM, little for raw floats, and a
    /// note if the other one gives a far smoother image.
    std::optional<std::endian> byteOrder;
    /// The caller's names of these two, for errors and notes.
    const char *channelName = "--channel", *byteOrderName = "--byte-order";
    /// Called with the size of an image before memory is allocated for it. Throws base::Error to refuse it.
    std::function<void(const PixelSize &)> check = [](const PixelSize &) {};
    /// Receives the number of pixels read since the last call.
    std::function<void(std::size_t)> onRead = [](std::size_t) {};
};

/// Reads an image of numbers. Its content tells the format, not its name:
///
///   PFM ("Pf")     floats of either byte order, rows from the bottom
///   PGM ("P5")     8 or 16 bits
///   PNG            8 or 16 bits of gray, by libpng
///   NumPy (.npy)   whole numbers and floats of 8 to 64 bits, both byte orders and layouts
///   OpenEXR        one channel: the given one, else the one named Z or depth, else the only one; several count
///                  as one where they have the same numbers. Pixels outside the data window are NaN
///   COLMAP (.bin)  "W&H&1&", then 32-bit floats, little-endian, rows from the top
///   TIFF           one channel: whole numbers of 8, 16 or 32 bits, floats of 16, 32 or 64 bits
///   anything else  raw 32-bit floats, little-endian, rows from the top, of the given size
///
base::Expected<NumberImage, base::Error> readNumberImage(ImageBytes &bytes, const ImageRequest &request);

/// Reads colors: PNG of any kind, or JPEG. Pixels are in stored order; a note reports an Exif
/// orientation that is not upright.
base::Expected<ColorImage, base::Error> readColorImage(ImageBytes &bytes, const ImageRequest &request);

} // namespace unprojector::images
