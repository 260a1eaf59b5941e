// TIFF, by libtiff.

#include "core/base/translation.h"
#include "core/images/formats.h"

#include <tiffio.h>

#include <cstdarg>
#include <cstdio>
#include <limits>
#include <utility>

namespace unprojector::images {
using base::tr;
namespace {

/// What libtiff's callbacks need.
struct Source {
    ImageBytes &bytes;
    std::string error = "libtiff"; ///< the first message
};

Source &sourceOf(thandle_t handle)
{
    return *static_cast<Source *>(handle);
}

int keepError(TIFF *, void *handle, const char *, const char *format, va_list values)
{
    auto &source = sourceOf(handle);
    if (source.error != "libtiff")
        return 1;
    std::array<char, 256> message{};
    std::vsnprintf(message.data(), message.size(), format, values);
    source.error = message.data();
    return 1;
}

toff_t moved(thandle_t handle, toff_t offset, int from)
{
    ImageBytes &bytes = sourceOf(handle).bytes;
    const std::uint64_t base = from == SEEK_SET ? 0 : from == SEEK_CUR ? bytes.position() : bytes.size();
    bytes.moveTo(base + offset);
    return bytes.position();
}

/// An open TIFF.
class TiffReader {
public:
    explicit TiffReader(ImageBytes &bytes) : m_source{bytes}
    {
        constexpr tmsize_t kMostAllocation = tmsize_t{1} << 30;
        TIFFOpenOptions *options = TIFFOpenOptionsAlloc();
        TIFFOpenOptionsSetMaxSingleMemAlloc(options, kMostAllocation);
        TIFFOpenOptionsSetErrorHandlerExtR(options, keepError, &m_source);
        TIFFOpenOptionsSetWarningHandlerExtR(
            options, [](TIFF *, void *, const char *, const char *, va_list) { return 1; }, nullptr);
        m_tiff = TIFFClientOpenExt(
            "", "rm", &m_source,
            [](thandle_t handle, void *target, tmsize_t count) {
                return static_cast<tmsize_t>(
                    sourceOf(handle).bytes.readSome(static_cast<char *>(target), static_cast<std::size_t>(count)));
            },
            [](thandle_t, void *, tmsize_t) { return tmsize_t{0}; }, moved, [](thandle_t) { return 0; },
            [](thandle_t handle) { return toff_t{sourceOf(handle).bytes.size()}; }, nullptr, nullptr, options);
        TIFFOpenOptionsFree(options);
    }
    ~TiffReader()
    {
        if (m_tiff != nullptr)
            TIFFClose(m_tiff);
    }
    TiffReader(const TiffReader &) = delete;
    TiffReader &operator=(const TiffReader &) = delete;

    TIFF *get() const { return m_tiff; }
    ImageError error() const { return damaged(m_source.error); }

    template <class Value>
    Value field(ttag_t tag) const
    {
        Value value{};
        TIFFGetFieldDefaulted(m_tiff, tag, &value);
        return value;
    }

private:
    Source m_source;
    TIFF *m_tiff = nullptr;
};

/// Reads all rows of tiles or strips.
/// @param put  receives row, first column, count and bytes of some pixels of a row
template <class Put>
bool readPixels(const TiffReader &reader, const PixelSize &size, std::size_t pixelBytes, const Put &put)
{
    TIFF *const tiff = reader.get();
    if (TIFFIsTiled(tiff) == 0) {
        std::vector<char> row(static_cast<std::size_t>(std::max<tmsize_t>(TIFFScanlineSize(tiff), 0)));
        if (row.size() < size.width * pixelBytes)
            return false;
        for (std::size_t j = 0; j < size.height; ++j) {
            if (TIFFReadScanline(tiff, row.data(), static_cast<std::uint32_t>(j), 0) != 1)
                return false;
            put(j, 0, size.width, row.data());
        }
        return true;
    }
    const std::size_t width = reader.field<std::uint32_t>(TIFFTAG_TILEWIDTH),
                      height = reader.field<std::uint32_t>(TIFFTAG_TILELENGTH);
    std::vector<char> tile(static_cast<std::size_t>(std::max<tmsize_t>(TIFFTileSize(tiff), 0)));
    if (width == 0 || height == 0 || width > 4 * kMostSide || height > 4 * kMostSide
        || tile.size() < width * height * pixelBytes)
        return false;
    for (std::size_t top = 0; top < size.height; top += height) {
        for (std::size_t left = 0; left < size.width; left += width) {
            if (TIFFReadTile(tiff, tile.data(), static_cast<std::uint32_t>(left), static_cast<std::uint32_t>(top), 0, 0)
                < 0)
                return false;
            for (std::size_t j = top; j < std::min(top + height, size.height); ++j)
                put(j, left, std::min(width, size.width - left), tile.data() + (j - top) * width * pixelBytes);
        }
    }
    return true;
}

/// @tparam File, Stored  as in the file, and in the image
template <class File, class Stored>
Numbers readAs(const TiffReader &reader, NumberImage image, const ImageRequest &request, Stored (*stored)(File))
{
    auto numbers = std::make_unique_for_overwrite<Stored[]>(image.size.pixels());
    const bool isRead = readPixels(reader, image.size, sizeof(File),
                                   [&](std::size_t j, std::size_t left, std::size_t count, const char *bytes) {
                                       for (std::size_t i = 0; i < count; ++i) {
                                           File value;
                                           std::memcpy(&value, bytes + i * sizeof(File), sizeof(File));
                                           numbers[j * image.size.width + left + i] = stored(value);
                                       }
                                       request.onRead(count);
                                   });
    if (!isRead)
        return reader.error();
    if constexpr (std::is_integral_v<File>)
        image.greatest = static_cast<double>(std::numeric_limits<File>::max());
    image.numbers = std::move(numbers);
    return image;
}

template <class File, class Stored>
Stored converted(File value)
{
    return static_cast<Stored>(value);
}

/// @return nothing where numbers of this kind are not read
std::optional<Numbers> readOf(const TiffReader &reader, unsigned bits, unsigned format, NumberImage &&image,
                              const ImageRequest &request)
{
    const auto read = [&](auto stored) { return readAs(reader, std::move(image), request, stored); };
    if (format == SAMPLEFORMAT_IEEEFP) {
        switch (bits) {
        case 16: return readAs<std::uint16_t, float>(reader, std::move(image), request, floatFromHalf);
        case 32: return read(converted<float, float>);
        case 64: return read(converted<double, double>);
        default: return std::nullopt;
        }
    }
    const bool isSigned = format == SAMPLEFORMAT_INT;
    if (format != SAMPLEFORMAT_UINT && format != SAMPLEFORMAT_VOID && !isSigned)
        return std::nullopt;
    switch (bits) {
    case 8: return isSigned ? read(converted<std::int8_t, float>) : read(converted<std::uint8_t, std::uint8_t>);
    case 16: return isSigned ? read(converted<std::int16_t, float>) : read(converted<std::uint16_t, std::uint16_t>);
    case 32: return isSigned ? read(converted<std::int32_t, double>) : read(converted<std::uint32_t, double>);
    default: return std::nullopt;
    }
}

} // namespace

Numbers readTiff(ImageBytes &bytes, const ImageRequest &request)
{
    bytes.allowPositions();
    const TiffReader reader(bytes);
    if (reader.get() == nullptr)
        return reader.error();
    const auto channels = reader.field<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL);
    const auto bits = reader.field<std::uint16_t>(TIFFTAG_BITSPERSAMPLE);
    const auto format = reader.field<std::uint16_t>(TIFFTAG_SAMPLEFORMAT);
    std::uint16_t meaning = PHOTOMETRIC_MINISBLACK;
    const bool hasMeaning = TIFFGetField(reader.get(), TIFFTAG_PHOTOMETRIC, &meaning) == 1;
    const auto orientation = reader.field<std::uint16_t>(TIFFTAG_ORIENTATION);
    if (channels != 1)
        return ImageError{tr("the TIFF has %1 channels; a depth image has one", channels)};
    if (meaning == PHOTOMETRIC_PALETTE || meaning == PHOTOMETRIC_MINISWHITE)
        return ImageError{tr("the TIFF has a palette of colors, or 0 for white; a depth image has plain numbers")};
    if (orientation != ORIENTATION_TOPLEFT && orientation != ORIENTATION_BOTLEFT)
        return ImageError{tr("the TIFF is turned or mirrored (orientation %1); write it upright", orientation)};
    NumberImage image;
    image.size = {reader.field<std::uint32_t>(TIFFTAG_IMAGEWIDTH), reader.field<std::uint32_t>(TIFFTAG_IMAGELENGTH)};
    image.isBottomFirst = orientation == ORIENTATION_BOTLEFT;
    if (auto refused = sizeRefusal(image.size, request))
        return *refused;
    if (!hasMeaning)
        image.notes.push_back(tr("the TIFF does not tell the meaning of 0 (no photometric interpretation); its numbers "
                                 "are used as they are"));
    if (TIFFLastDirectory(reader.get()) == 0)
        image.notes.push_back(tr("the TIFF has several pages; the first one is used"));
    if (TIFFIsCODECConfigured(reader.field<std::uint16_t>(TIFFTAG_COMPRESSION)) == 0)
        return ImageError{tr("the TIFF is compressed in a way (number %1) that this program's libtiff does not know; "
                             "write it without compression",
                             reader.field<std::uint16_t>(TIFFTAG_COMPRESSION))};
    std::optional<Numbers> read = readOf(reader, bits, format, std::move(image), request);
    if (!read)
        return ImageError{
            tr("the TIFF has numbers of %1 bits; give floats, or whole numbers of 8, 16 or 32 bits", bits)};
    return std::move(*read);
}

} // namespace unprojector::images
