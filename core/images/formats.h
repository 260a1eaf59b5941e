#pragma once

#include "core/base/byte_order.h"
#include "core/base/error.h"
#include "core/images/number_image.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>

/// The reader of each format. They throw base::Error. A build without a library has a stub of its reader, which
/// says so.
namespace unprojector::images {

NumberImage readPng(ImageBytes &bytes, const ImageRequest &request);
NumberImage readNpy(ImageBytes &bytes, const ImageRequest &request);
NumberImage readExr(ImageBytes &bytes, const ImageRequest &request);
NumberImage readTiff(ImageBytes &bytes, const ImageRequest &request);
NumberImage readNetpbm(ImageBytes &bytes, const ImageRequest &request);
NumberImage readColmap(ImageBytes &bytes, const ImageRequest &request);
/// @param size  of the image
NumberImage readRaw(ImageBytes &bytes, const PixelSize &size, const ImageRequest &request);

ColorImage readPngColors(ImageBytes &bytes, const ImageRequest &request);
ColorImage readJpegColors(ImageBytes &bytes, const ImageRequest &request);

bool isNetpbm(std::string_view first); ///< PFM or PGM
bool isColmap(std::string_view first); ///< a map of COLMAP: depths or normals

/// The messages that several formats share.
base::Error damaged(std::string_view detail);
base::Error tooShort(const PixelSize &size);
/// A byte order was given for a format that tells its own.
base::Error byteOrderRefusal(const ImageRequest &request);
/// Throws where bytes follow the image.
void checkEnd(ImageBytes &bytes, const PixelSize &size);
/// Throws where the size is too large, none, or refused by request.check.
void checkSize(const PixelSize &size, const ImageRequest &request);

/// A number of 16 bits that is a float: 1 of sign, 5 of exponent, 10 of fraction (IEEE 754).
struct Half {
    std::uint16_t bits;
    operator float() const;
};

/// A number as a file stores it.
using FileNumber = std::variant<std::uint8_t, std::uint16_t, std::uint32_t, std::uint64_t, std::int8_t, std::int16_t,
                                std::int32_t, std::int64_t, Half, float, double>;
/// @param type  kind and bytes as NumPy writes them: "u1", "i8", "f4"
/// @return of no value; nothing for other numbers
std::optional<FileNumber> fileNumber(std::string_view type);

/// The type of an image that holds the numbers of a file: exact for all but whole numbers beyond 2^53.
template <class File>
using Stored = std::conditional_t<std::is_unsigned_v<File> && sizeof(File) <= 2, File,
                                  std::conditional_t<sizeof(File) <= 2 || std::is_same_v<File, float>, float, double>>;

template <class File>
constexpr double kGreatest = std::is_integral_v<File> ? static_cast<double>(std::numeric_limits<File>::max()) : 0.0;

/// Reads the numbers of all pixels, to the end of the bytes.
/// @param pixelOf  the pixel of the number with an index in the file
template <class File, class PixelOf>
void readNumbers(ImageBytes &bytes, NumberImage &image, std::endian order, const ImageRequest &request,
                 const PixelOf &pixelOf)
{
    constexpr std::size_t kBlock = std::size_t{1} << 16;
    const std::size_t count = image.size.pixels();
    auto numbers = std::make_unique_for_overwrite<Stored<File>[]>(count);
    std::vector<File> block(std::min(kBlock, count));
    for (std::size_t start = 0; start < count; start += block.size()) {
        block.resize(std::min(block.size(), count - start));
        if (!bytes.read(reinterpret_cast<char *>(block.data()), block.size() * sizeof(File)))
            throw tooShort(image.size);
        if (order != std::endian::native)
            std::ranges::transform(block, block.begin(), base::withSwappedBytes<File>);
        for (std::size_t i = 0; i < block.size(); ++i)
            numbers[pixelOf(start + i)] = static_cast<Stored<File>>(block[i]);
        request.onRead(block.size());
    }
    checkEnd(bytes, image.size);
    image.numbers = std::move(numbers);
}

/// The same for a file with the numbers in the order of the image.
template <class File>
void readNumbers(ImageBytes &bytes, NumberImage &image, std::endian order, const ImageRequest &request)
{
    readNumbers<File>(bytes, image, order, request, [](std::size_t index) { return index; });
}

} // namespace unprojector::images
