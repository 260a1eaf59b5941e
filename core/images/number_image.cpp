#include "core/images/number_image.h"

#include "core/base/translation.h"
#include "core/images/formats.h"

#include <cmath>
#include <limits>

namespace unprojector::images {
using base::tr;

std::string sizeText(const PixelSize &size)
{
    return std::to_string(size.width) + 'x' + std::to_string(size.height);
}

bool isPng(std::string_view first)
{
    return first.starts_with("\x89PNG\r\n\x1a\n");
}

bool isJpeg(std::string_view first)
{
    return first.starts_with("\xff\xd8\xff");
}

bool isNpy(std::string_view first)
{
    return first.starts_with("\x93NUMPY");
}

bool isExr(std::string_view first)
{
    return first.starts_with("\x76\x2f\x31\x01");
}

bool isTiff(std::string_view first)
{
    using namespace std::string_view_literals;
    for (const std::string_view start : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}) {
        if (first.starts_with(start))
            return true;
    }
    return false;
}

ImageError damaged(std::string_view detail)
{
    return {tr("the file is damaged (%1); write it again", detail)};
}

ImageError tooShort(const PixelSize &size)
{
    return {tr("the file is too short for %1 pixels", sizeText(size))};
}

ImageError tooLong(const PixelSize &size)
{
    return {tr("the file is too long for %1 pixels", sizeText(size))};
}

ImageError noLibrary(std::string_view format, std::string_view library, std::string_view others)
{
    return {tr("this is %1, which this program was built without; convert the file to %3, or build the program with %2",
               format, library, others)};
}

std::optional<ImageError> sizeRefusal(const PixelSize &size, const ImageRequest &request)
{
    if (size.width == 0 || size.height == 0)
        return ImageError{tr("the image has no pixels")};
    if (size.width > kMostSide || size.height > kMostSide)
        return ImageError{tr("the image has %1 pixels; %2 a side is the most", sizeText(size), kMostSide)};
    return request.refusal(size);
}

bool hasMore(ImageBytes &bytes)
{
    char more = 0;
    return bytes.read(&more, 1);
}

float floatFromHalf(std::uint16_t half)
{
    const int exponent = half >> 10 & 0x1f, fraction = half & 0x3ff;
    float size = 0.0f;
    if (exponent == 0)
        size = std::ldexp(static_cast<float>(fraction), -24);
    else if (exponent < 0x1f)
        size = std::ldexp(static_cast<float>(fraction + 0x400), exponent - 25);
    else
        size = fraction == 0 ? std::numeric_limits<float>::infinity() : std::numeric_limits<float>::quiet_NaN();
    return (half & 0x8000) != 0 ? -size : size;
}

namespace {

/// True for a format whose files do not tell their byte order.
bool hasFreeByteOrder(std::string_view first)
{
    const bool isKnown = isPng(first) || isNpy(first) || isExr(first) || isTiff(first) || isColmap(first);
    return !isKnown && !first.starts_with("Pf");
}

} // namespace

ImageError byteOrderRefusal(const ImageRequest &request)
{
    return ImageError{
        tr("%1 is for PGM of 16 bits and raw floats, and this is another format; leave it out", request.byteOrderName)};
}

geometry::Result<NumberImage, ImageError> readNumberImage(ImageBytes &bytes, const ImageRequest &request)
{
    const std::string_view first = bytes.first();
    if (!request.channel.empty() && !isExr(first))
        return ImageError{tr("%1 is for OpenEXR, and this is another format; leave it out", request.channelName)};
    if (request.byteOrder && !hasFreeByteOrder(first))
        return byteOrderRefusal(request);
    if (isPng(first))
        return readPng(bytes, request);
    if (isNpy(first))
        return readNpy(bytes, request);
    if (isExr(first))
        return readExr(bytes, request);
    if (isTiff(first))
        return readTiff(bytes, request);
    if (isNetpbm(first))
        return readNetpbm(bytes, request);
    if (isColmap(first))
        return readColmap(bytes, request);
    if (isJpeg(first))
        return ImageError{tr("a JPEG image holds no exact numbers; give PNG, .npy, OpenEXR, TIFF, PFM or PGM")};
    if (request.rawSize)
        return readRaw(bytes, *request.rawSize, request);
    if (first.starts_with("PK\x03\x04"))
        return ImageError{tr("this is an archive (.npz or .zip); write the array alone, as by numpy.save")};
    return ImageError{tr("no depth image: it is neither PNG, .npy, OpenEXR, TIFF, PFM, PGM nor COLMAP's .bin; for raw "
                         "32-bit floats give --size WxH")};
}

geometry::Result<ColorImage, ImageError> readColorImage(ImageBytes &bytes, const ImageRequest &request)
{
    if (isPng(bytes.first()))
        return readPngColors(bytes, request);
    if (isJpeg(bytes.first()))
        return readJpegColors(bytes, request);
    return ImageError{tr("this is neither PNG nor JPEG; give colors as one of them")};
}

} // namespace unprojector::images
