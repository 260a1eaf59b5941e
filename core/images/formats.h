#pragma once

#include "core/base/byte_order.h"
#include "core/images/number_image.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <span>

/// The reader of each format. A build without a library has its stub, which says so.
namespace unprojector::images {

using Numbers = geometry::Result<NumberImage, ImageError>;
using Colors = geometry::Result<ColorImage, ImageError>;

bool isPng(std::string_view first);
bool isJpeg(std::string_view first);
bool isNpy(std::string_view first);
bool isExr(std::string_view first);
bool isTiff(std::string_view first);
bool isNetpbm(std::string_view first); ///< PFM or PGM
bool isColmap(std::string_view first); ///< a map of COLMAP: depths or normals

Numbers readPng(ImageBytes &bytes, const ImageRequest &request);
Numbers readNpy(ImageBytes &bytes, const ImageRequest &request);
Numbers readExr(ImageBytes &bytes, const ImageRequest &request);
Numbers readTiff(ImageBytes &bytes, const ImageRequest &request);
Numbers readNetpbm(ImageBytes &bytes, const ImageRequest &request);
Numbers readColmap(ImageBytes &bytes, const ImageRequest &request);
/// @param size  of the image
Numbers readRaw(ImageBytes &bytes, const PixelSize &size, const ImageRequest &request);

Colors readPngColors(ImageBytes &bytes, const ImageRequest &request);
Colors readJpegColors(ImageBytes &bytes, const ImageRequest &request);

/// The messages that several formats share.
ImageError damaged(std::string_view detail);
ImageError tooShort(const PixelSize &size);
/// A byte order was given for a format that tells its own.
ImageError byteOrderRefusal(const ImageRequest &request);
/// @param library  "libpng"
/// @param others  formats to convert to
ImageError noLibrary(std::string_view format, std::string_view library, std::string_view others);
/// @return the reason to refuse a size: too large, none, or request.refusal's
std::optional<ImageError> sizeRefusal(const PixelSize &size, const ImageRequest &request);

/// Returns whether any byte follows the image.
bool hasMore(ImageBytes &bytes);
ImageError tooLong(const PixelSize &size);

/// The number of values read at a time.
constexpr std::size_t kBlock = std::size_t{1} << 16;

/// The value of 16 bits: 1 of sign, 5 of exponent, 10 of fraction (IEEE 754).
float floatFromHalf(std::uint16_t half);

} // namespace unprojector::images
