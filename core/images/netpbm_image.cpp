// PFM, PGM, COLMAP's maps and raw floats.

#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/images/formats.h"

#include <cmath>

namespace unprojector::images {
using base::Error;
using base::tr;
using base::withSwappedBytes;
namespace {

/// The next word of a header; comments, from # to the line's end, are skipped.
std::string_view nextWord(base::TextScanner &header)
{
    std::string_view word = header.nextWord();
    for (; word.starts_with('#'); word = header.nextWord())
        header.skipLine();
    return word;
}

/// "640&480&1&": width, height and numbers a pixel of COLMAP's maps.
struct ColmapHeader {
    std::array<std::size_t, 3> numbers{};
    std::size_t end = 0; ///< where the pixels begin
};

std::optional<ColmapHeader> colmapHeader(std::string_view bytes)
{
    ColmapHeader header;
    for (std::size_t &number : header.numbers) {
        const std::size_t end = std::min(bytes.find('&', header.end), bytes.size());
        const auto found = base::numberIn<std::size_t>(bytes.substr(header.end, end - header.end));
        if (!found || end == bytes.size())
            return std::nullopt;
        number = *found;
        header.end = end + 1;
    }
    return header;
}

template <class Number>
std::span<const Number> numbersOf(const NumberImage &image)
{
    return {std::get<std::unique_ptr<Number[]>>(image.numbers).get(), image.size.pixels()};
}

/// How much neighbours differ, compared with pixels half an image apart: near 0 for depths, near 1 for noise.
struct Roughness {
    double beside = 0.0, apart = 0.0;
    std::size_t count = 0;

    /// @param next  the right neighbour
    /// @param other  half an image away
    void add(double number, double next, double other)
    {
        // Numbers that mean no measurement are the same in both byte orders.
        constexpr double kSaturated = 65535.0;
        for (const double each : {number, next, other}) {
            if (!std::isfinite(each) || each == 0.0 || each == kSaturated)
                return;
        }
        beside += std::abs(number - next);
        apart += std::abs(number - other);
        ++count;
    }
    double relative() const { return apart > 0.0 ? beside / apart : 0.0; }
};

/// True if the numbers in the other byte order make a far smoother image. Numbers that use only one of their bytes
/// are as smooth in both orders.
template <class Number>
bool isSmootherSwapped(const NumberImage &image)
{
    constexpr double kFarSmoother = 3.0;
    constexpr std::size_t kFew = 64, kRows = 512; // as many rows tell it
    const std::span<const Number> all = numbersOf<Number>(image);
    const auto [width, height] = image.size;
    const auto swapped = [](Number number) { return static_cast<double>(withSwappedBytes(number)); };
    Roughness own, other;
    for (std::size_t j = 0; j < height; j += std::max(std::size_t{1}, height / kRows)) {
        const std::span<const Number> row = all.subspan(j * width, width),
                                      away = all.subspan((j + height / 2) % height * width, width);
        for (std::size_t i = 0; i + 1 < width; ++i) {
            const Number a = row[i], b = row[i + 1], c = away[(i + width / 2) % width];
            own.add(static_cast<double>(a), static_cast<double>(b), static_cast<double>(c));
            other.add(swapped(a), swapped(b), swapped(c));
        }
    }
    return other.count >= kFew && 2 * other.count >= own.count && kFarSmoother * other.relative() < own.relative();
}

/// Throws for a pixel above the greatest value that the header declares.
template <class Number>
void checkGreatest(const NumberImage &image, const ImageRequest &request)
{
    const std::span<const Number> numbers = numbersOf<Number>(image);
    const auto isExcess = [&](Number n) { return n > image.greatest; };
    const auto found = std::ranges::find_if(numbers, isExcess);
    if (found == numbers.end())
        return;
    if (!request.byteOrder && std::ranges::none_of(numbers, isExcess, withSwappedBytes<Number>))
        throw Error{tr("numbers are above %1, the greatest one of the header, and none is in the other byte "
                       "order; give little by %2",
                       base::shortestText(image.greatest), request.byteOrderName)};
    const auto pixel = static_cast<std::size_t>(found - numbers.begin());
    throw Error{tr("the pixel in column %1 and row %2 has the value %3, and the header says that %4 is the "
                   "greatest (both counted from 0, from the upper left)",
                   pixel % image.size.width, pixel / image.size.width, unsigned{*found},
                   base::shortestText(image.greatest))};
}

/// Reads numbers whose byte order the file does not tell.
/// @param usual  the format's byte order
template <class Number>
void readInByteOrder(ImageBytes &bytes, NumberImage &image, std::endian usual, const ImageRequest &request)
{
    readNumbers<Number>(bytes, image, request.byteOrder.value_or(usual), request);
    if (!request.byteOrder && isSmootherSwapped<Number>(image))
        image.notes.push_back(tr("in the other byte order the image is far smoother; if the depths are wrong, give "
                                 "%1 by %2",
                                 usual == std::endian::big ? "little" : "big", request.byteOrderName));
}

} // namespace

bool isNetpbm(std::string_view first)
{
    return (first.starts_with("Pf") || first.starts_with("P5")) && first.find_first_of(" \t\n\r") == 2;
}

NumberImage readNetpbm(ImageBytes &bytes, const ImageRequest &request)
{
    const bool isPfm = bytes.first().starts_with("Pf");
    base::TextScanner header(bytes.first(), 2);
    const auto width = base::numberIn<std::size_t>(nextWord(header)),
               height = base::numberIn<std::size_t>(nextWord(header));
    // PGM: the greatest value; PFM: the scale, below 0: little-endian
    const double last = base::numberIn<double>(nextWord(header)).value_or(0.0);
    const bool isMeant =
        isPfm ? last != 0.0 && std::isfinite(last) : last >= 1.0 && last <= 65535.0 && last == std::floor(last);
    if (!width || !height || !isMeant)
        throw Error{tr("the header is damaged")};
    NumberImage image;
    image.size = {*width, *height};
    image.greatest = isPfm ? 0.0 : last;
    checkSize(image.size, request);
    if (request.byteOrder && image.greatest <= 255.0)
        throw byteOrderRefusal(request);
    bytes.moveTo(std::min(header.offset() + 1, bytes.first().size())); // a blank is before the pixels
    if (isPfm) {
        image.isBottomFirst = true;
        if (std::abs(last) != 1.0)
            image.notes.push_back(tr("the header has the scale %1, which is not applied: the depths are used unchanged",
                                     base::shortestText(std::abs(last))));
        readNumbers<float>(bytes, image, last < 0.0 ? std::endian::little : std::endian::big, request);
    } else if (image.greatest > 255.0) {
        readInByteOrder<std::uint16_t>(bytes, image, std::endian::big, request);
        checkGreatest<std::uint16_t>(image, request);
    } else {
        readNumbers<std::uint8_t>(bytes, image, std::endian::native, request);
        checkGreatest<std::uint8_t>(image, request);
    }
    return image;
}

NumberImage readRaw(ImageBytes &bytes, const PixelSize &size, const ImageRequest &request)
{
    checkSize(size, request);
    NumberImage image;
    image.size = size;
    readInByteOrder<float>(bytes, image, std::endian::little, request);
    return image;
}

bool isColmap(std::string_view first)
{
    return colmapHeader(first).has_value();
}

NumberImage readColmap(ImageBytes &bytes, const ImageRequest &request)
{
    const auto [numbers, end] = *colmapHeader(bytes.first());
    if (numbers[2] != 1)
        throw Error{tr("the map of COLMAP has %1 numbers a pixel; give its map of depths, not of normals", numbers[2])};
    NumberImage image;
    image.size = {numbers[0], numbers[1]};
    checkSize(image.size, request);
    bytes.moveTo(end);
    readNumbers<float>(bytes, image, std::endian::little, request);
    return image;
}

} // namespace unprojector::images
