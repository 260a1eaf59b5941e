#include "core/images/number_image.h"

#include "core/base/translation.h"
#include "core/images/formats.h"

#include <cmath>
#include <utility>

namespace unprojector::images {
using base::Error;
using base::Expected;
using base::tr;
using namespace std::string_view_literals;
namespace {

constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n"sv, kJpeg = "\xff\xd8\xff"sv, kExr = "\x76\x2f\x31\x01"sv;

/// The formats of numbers whose files tell their byte order, by their first bytes.
struct Format {
    std::string_view start;
    NumberImage (*read)(ImageBytes &, const ImageRequest &);
};
constexpr std::array<Format, 7> kFormats{{{kPng, readPng},
                                          {"\x93NUMPY"sv, readNpy},
                                          {kExr, readExr},
                                          {"II*\0"sv, readTiff},
                                          {"MM\0*"sv, readTiff},
                                          {"II+\0"sv, readTiff},
                                          {"MM\0+"sv, readTiff}}};

/// @param library  "libpng"
/// @param others  formats to convert to
[[noreturn, maybe_unused]] void throwNoLibrary(std::string_view format, std::string_view library,
                                               std::string_view others)
{
    throw Error{
        tr("this is %1, which this program was built without; convert the file to %3, or build the program with %2",
           format, library, others)};
}

} // namespace

#ifndef UNPROJECTOR_PNG
NumberImage readPng(ImageBytes &, const ImageRequest &)
{
    throwNoLibrary("PNG", "libpng", ".npy, PFM");
}
ColorImage readPngColors(ImageBytes &, const ImageRequest &)
{
    throwNoLibrary("PNG", "libpng", "JPEG");
}
#endif
#ifndef UNPROJECTOR_JPEG
ColorImage readJpegColors(ImageBytes &, const ImageRequest &)
{
    throwNoLibrary("JPEG", "libjpeg", "PNG");
}
#endif
#ifndef UNPROJECTOR_TIFF
NumberImage readTiff(ImageBytes &, const ImageRequest &)
{
    throwNoLibrary("TIFF", "libtiff", ".npy, PFM");
}
#endif
#ifndef UNPROJECTOR_OPENEXR
NumberImage readExr(ImageBytes &, const ImageRequest &)
{
    throwNoLibrary("OpenEXR", "OpenEXR", ".npy, PFM");
}
#endif

std::string sizeText(const PixelSize &size)
{
    return std::to_string(size.width) + 'x' + std::to_string(size.height);
}

Error damaged(std::string_view detail)
{
    return {tr("the file is damaged (%1); write it again", detail)};
}

Error tooShort(const PixelSize &size)
{
    return {tr("the file is too short for %1 pixels", sizeText(size))};
}

Error byteOrderRefusal(const ImageRequest &request)
{
    return {
        tr("%1 is for PGM of 16 bits and raw floats, and this is another format; leave it out", request.byteOrderName)};
}

void checkEnd(ImageBytes &bytes, const PixelSize &size)
{
    if (char more = 0; bytes.read(&more, 1))
        throw Error{tr("the file is too long for %1 pixels", sizeText(size))};
}

void checkSize(const PixelSize &size, const ImageRequest &request)
{
    if (size.width == 0 || size.height == 0)
        throw Error{tr("the image has no pixels")};
    if (size.width > kMostSide || size.height > kMostSide)
        throw Error{tr("the image has %1 pixels; %2 a side is the most", sizeText(size), kMostSide)};
    request.check(size);
}

Half::operator float() const
{
    const int exponent = bits >> 10 & 0x1f, fraction = bits & 0x3ff;
    float size = 0.0f;
    if (exponent == 0)
        size = std::ldexp(static_cast<float>(fraction), -24);
    else if (exponent < 0x1f)
        size = std::ldexp(static_cast<float>(fraction + 0x400), exponent - 25);
    else
        size = fraction == 0 ? std::numeric_limits<float>::infinity() : std::numeric_limits<float>::quiet_NaN();
    return (bits & 0x8000) != 0 ? -size : size;
}

std::optional<FileNumber> fileNumber(std::string_view type)
{
    static constexpr std::array<std::pair<std::string_view, FileNumber>, 11> kTypes{{{"u1", std::uint8_t{}},
                                                                                     {"u2", std::uint16_t{}},
                                                                                     {"u4", std::uint32_t{}},
                                                                                     {"u8", std::uint64_t{}},
                                                                                     {"i1", std::int8_t{}},
                                                                                     {"i2", std::int16_t{}},
                                                                                     {"i4", std::int32_t{}},
                                                                                     {"i8", std::int64_t{}},
                                                                                     {"f2", Half{}},
                                                                                     {"f4", 0.0f},
                                                                                     {"f8", 0.0}}};
    for (const auto &[name, number] : kTypes) {
        if (name == type)
            return number;
    }
    return std::nullopt;
}

Expected<NumberImage, Error> readNumberImage(ImageBytes &bytes, const ImageRequest &request)
try {
    const std::string_view first = bytes.first();
    const auto starts = [first](const Format &format) { return first.starts_with(format.start); };
    const auto format = std::ranges::find_if(kFormats, starts);
    const auto read = format != kFormats.end() ? format->read : isColmap(first) ? readColmap : nullptr;
    if (!request.channel.empty() && read != readExr)
        return Error{tr("%1 is for OpenEXR, and this is another format; leave it out", request.channelName)};
    if (request.byteOrder && (read != nullptr || first.starts_with("Pf")))
        return byteOrderRefusal(request);
    if (read != nullptr)
        return read(bytes, request);
    if (isNetpbm(first))
        return readNetpbm(bytes, request);
    if (first.starts_with(kJpeg))
        return Error{tr("a JPEG image holds no exact numbers; give PNG, .npy, OpenEXR, TIFF, PFM or PGM")};
    if (request.rawSize)
        return readRaw(bytes, *request.rawSize, request);
    if (first.starts_with("PK\x03\x04"))
        return Error{tr("this is an archive (.npz or .zip); write the array alone, as by numpy.save")};
    return Error{tr("no depth image: it is neither PNG, .npy, OpenEXR, TIFF, PFM, PGM nor COLMAP's .bin; for raw "
                    "32-bit floats give --size WxH")};
} catch (const Error &error) {
    return error;
}

Expected<ColorImage, Error> readColorImage(ImageBytes &bytes, const ImageRequest &request)
try {
    if (bytes.first().starts_with(kPng))
        return readPngColors(bytes, request);
    if (bytes.first().starts_with(kJpeg))
        return readJpegColors(bytes, request);
    return Error{tr("this is neither PNG nor JPEG; give colors as one of them")};
} catch (const Error &error) {
    return error;
}

} // namespace unprojector::images
