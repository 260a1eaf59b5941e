// TIFF, by libtiff.

#include "core/base/translation.h"
#include "core/images/formats.h"

#include <tiffio.h>

#include <cstdarg>
#include <cstdio>
#include <string>
#include <utility>

namespace unprojector::images {
using base::Error;
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
    Error error() const { return damaged(m_source.error); }

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

/// Reads the numbers of an image whose size is known.
template <class File>
void readNumbers(const TiffReader &reader, NumberImage &image, const ImageRequest &request)
{
    auto numbers = std::make_unique_for_overwrite<Stored<File>[]>(image.size.pixels());
    const bool isRead = readPixels(reader, image.size, sizeof(File),
                                   [&](std::size_t j, std::size_t left, std::size_t count, const char *bytes) {
                                       for (std::size_t i = 0; i < count; ++i) {
                                           File value;
                                           std::memcpy(&value, bytes + i * sizeof(File), sizeof(File));
                                           numbers[j * image.size.width + left + i] = static_cast<Stored<File>>(value);
                                       }
                                       request.onRead(count);
                                   });
    if (!isRead)
        throw reader.error();
    image.greatest = kGreatest<File>;
    image.numbers = std::move(numbers);
}

/// @return of no value; nothing where numbers of this kind are not read
std::optional<FileNumber> numberOf(unsigned bits, unsigned format)
{
    const bool isFloat = format == SAMPLEFORMAT_IEEEFP, isSigned = format == SAMPLEFORMAT_INT;
    const bool isWhole = format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_VOID || isSigned;
    if (bits % 8 != 0 || !(isFloat || (isWhole && bits <= 32)))
        return std::nullopt;
    return fileNumber((isFloat ? "f" : isSigned ? "i" : "u") + std::to_string(bits / 8));
}

} // namespace

NumberImage readTiff(ImageBytes &bytes, const ImageRequest &request)
{
    bytes.allowPositions();
    const TiffReader reader(bytes);
    if (reader.get() == nullptr)
        throw reader.error();
    const auto channels = reader.field<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL);
    const auto bits = reader.field<std::uint16_t>(TIFFTAG_BITSPERSAMPLE);
    const auto format = reader.field<std::uint16_t>(TIFFTAG_SAMPLEFORMAT);
    std::uint16_t meaning = PHOTOMETRIC_MINISBLACK;
    const bool hasMeaning = TIFFGetField(reader.get(), TIFFTAG_PHOTOMETRIC, &meaning) == 1;
    const auto orientation = reader.field<std::uint16_t>(TIFFTAG_ORIENTATION);
    if (channels != 1)
        throw Error{tr("the TIFF has %1 channels; a depth image has one", channels)};
    if (meaning == PHOTOMETRIC_PALETTE || meaning == PHOTOMETRIC_MINISWHITE)
        throw Error{tr("the TIFF has a palette of colors, or 0 for white; a depth image has plain numbers")};
    if (orientation != ORIENTATION_TOPLEFT && orientation != ORIENTATION_BOTLEFT)
        throw Error{tr("the TIFF is turned or mirrored (orientation %1); write it upright", orientation)};
    NumberImage image;
    image.size = {reader.field<std::uint32_t>(TIFFTAG_IMAGEWIDTH), reader.field<std::uint32_t>(TIFFTAG_IMAGELENGTH)};
    image.isBottomFirst = orientation == ORIENTATION_BOTLEFT;
    checkSize(image.size, request);
    if (!hasMeaning)
        image.notes.push_back(tr("the TIFF does not tell the meaning of 0 (no photometric interpretation); its numbers "
                                 "are used as they are"));
    if (TIFFLastDirectory(reader.get()) == 0)
        image.notes.push_back(tr("the TIFF has several pages; the first one is used"));
    if (const auto codec = reader.field<std::uint16_t>(TIFFTAG_COMPRESSION); TIFFIsCODECConfigured(codec) == 0)
        throw Error{tr("the TIFF is compressed in a way (number %1) that this program's libtiff does not know; "
                       "write it without compression",
                       codec)};
    const std::optional<FileNumber> number = numberOf(bits, format);
    if (!number)
        throw Error{tr("the TIFF has numbers of %1 bits; give floats, or whole numbers of 8, 16 or 32 bits", bits)};
    std::visit([&]<class File>(File) { readNumbers<File>(reader, image, request); }, *number);
    return image;
}

} // namespace unprojector::images
