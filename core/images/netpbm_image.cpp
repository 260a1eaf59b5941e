// PFM, PGM, COLMAP's maps and raw floats.

#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/images/formats.h"

#include <charconv>
#include <cmath>

namespace unprojector::images {
using base::tr;
using base::withSwappedBytes;
namespace {

bool isSpace(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// The words of a header; comments, from # to the line's end, are skipped.
class Header {
public:
    explicit Header(std::string_view bytes) : m_bytes(bytes) {}

    std::string_view word()
    {
        while (m_at < m_bytes.size() && (isSpace(m_bytes[m_at]) || m_bytes[m_at] == '#')) {
            if (m_bytes[m_at] == '#')
                m_at = std::min(m_bytes.find('\n', m_at), m_bytes.size());
            else
                ++m_at;
        }
        const std::size_t start = m_at;
        while (m_at < m_bytes.size() && !isSpace(m_bytes[m_at]))
            ++m_at;
        return m_bytes.substr(start, m_at - start);
    }
    /// The start of the pixels: one blank after the last word.
    std::size_t end() const { return std::min(m_at + 1, m_bytes.size()); }

private:
    std::string_view m_bytes;
    std::size_t m_at = 0;
};

template <class Number>
std::optional<Number> numberOf(std::string_view text)
{
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return number;
}

/// "640&480&1&": width, height and numbers a pixel of COLMAP's maps.
class ColmapHeader {
public:
    explicit ColmapHeader(std::string_view bytes)
    {
        for (std::size_t &number : m_numbers) {
            const std::size_t start = m_at;
            m_at = std::min(bytes.find('&', start), bytes.size());
            const auto found = numberOf<std::size_t>(bytes.substr(start, m_at - start));
            m_isWhole = m_isWhole && found && m_at < bytes.size();
            number = found.value_or(0);
            m_at = std::min(m_at + 1, bytes.size());
        }
    }
    bool isWhole() const { return m_isWhole; }
    PixelSize size() const { return {m_numbers[0], m_numbers[1]}; }
    std::size_t channels() const { return m_numbers[2]; }
    std::size_t end() const { return m_at; }

private:
    std::array<std::size_t, 3> m_numbers{};
    std::size_t m_at = 0;
    bool m_isWhole = true;
};

/// Reads the values of all pixels as the file has them.
/// @param isSwapped  the file's byte order is not this machine's
template <class Number>
std::optional<ImageError> readAll(ImageBytes &bytes, NumberImage &image, bool isSwapped, const ImageRequest &request)
{
    auto numbers = std::make_unique_for_overwrite<Number[]>(image.size.pixels());
    const std::span<Number> all(numbers.get(), image.size.pixels());
    for (std::size_t start = 0; start < all.size(); start += kBlock) {
        const std::span<Number> block = all.subspan(start, std::min(kBlock, all.size() - start));
        if (!bytes.read(reinterpret_cast<char *>(block.data()), block.size_bytes()))
            return tooShort(image.size);
        if (isSwapped)
            std::ranges::transform(block, block.begin(), withSwappedBytes<Number>);
        request.onRead(block.size());
    }
    if (hasMore(bytes))
        return tooLong(image.size);
    image.numbers = std::move(numbers);
    return std::nullopt;
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

/// The first pixel above the greatest value that the header declares.
template <class Number>
std::optional<ImageError> excess(const NumberImage &image, const ImageRequest &request)
{
    const std::span<const Number> numbers = numbersOf<Number>(image);
    const auto isExcess = [&](Number n) { return n > image.greatest; };
    const auto found = std::ranges::find_if(numbers, isExcess);
    if (found == numbers.end())
        return std::nullopt;
    if (!request.byteOrder && std::ranges::none_of(numbers, isExcess, withSwappedBytes<Number>))
        return ImageError{tr("numbers are above %1, the greatest one of the header, and none is in the other byte "
                             "order; give little by %2",
                             base::shortestText(image.greatest), request.byteOrderName)};
    const auto pixel = static_cast<std::size_t>(found - numbers.begin());
    return ImageError{tr("the pixel in column %1 and row %2 has the value %3, and the header says that %4 is the "
                         "greatest (both counted from 0, from the upper left)",
                         pixel % image.size.width, pixel / image.size.width, unsigned{*found},
                         base::shortestText(image.greatest))};
}

constexpr bool kIsLittle = std::endian::native == std::endian::little;

/// Reads numbers whose byte order the file does not tell.
/// @param usual  the format's byte order
template <class Number>
std::optional<ImageError> readInOrder(ImageBytes &bytes, NumberImage &image, std::endian usual,
                                      const ImageRequest &request)
{
    const std::endian order = request.byteOrder.value_or(usual);
    if (auto error = readAll<Number>(bytes, image, order != std::endian::native, request))
        return error;
    if (!request.byteOrder && isSmootherSwapped<Number>(image))
        image.notes.push_back(tr("in the other byte order the image is far smoother; if the depths are wrong, give "
                                 "%1 by %2",
                                 usual == std::endian::big ? "little" : "big", request.byteOrderName));
    return std::nullopt;
}

} // namespace

bool isNetpbm(std::string_view first)
{
    return first.size() > 2 && isSpace(first[2]) && (first.starts_with("Pf") || first.starts_with("P5"));
}

Numbers readNetpbm(ImageBytes &bytes, const ImageRequest &request)
{
    const bool isPfm = bytes.first().starts_with("Pf");
    Header header(bytes.first());
    header.word();
    const auto width = numberOf<std::size_t>(header.word()), height = numberOf<std::size_t>(header.word());
    const auto last =
        numberOf<double>(header.word()); // PGM: the greatest value; PFM: the scale, below 0: little-endian
    if (!width || !height || !last)
        return ImageError{tr("the header is damaged")};
    const bool isMeant =
        isPfm ? *last != 0.0 && std::isfinite(*last) : *last >= 1.0 && *last <= 65535.0 && *last == std::floor(*last);
    if (!isMeant)
        return ImageError{tr("the header is damaged")};
    NumberImage image;
    image.size = {*width, *height};
    image.greatest = isPfm ? 0.0 : *last;
    if (auto refused = sizeRefusal(image.size, request))
        return *refused;
    if (request.byteOrder && image.greatest <= 255.0)
        return byteOrderRefusal(request);
    bytes.moveTo(header.end());
    std::optional<ImageError> error;
    if (isPfm) {
        image.isBottomFirst = true;
        if (std::abs(*last) != 1.0)
            image.notes.push_back(tr("the header has the scale %1, which is not applied: the depths are used unchanged",
                                     base::shortestText(std::abs(*last))));
        error = readAll<float>(bytes, image, (*last < 0.0) != kIsLittle, request);
    } else if (image.greatest > 255.0) {
        error = readInOrder<std::uint16_t>(bytes, image, std::endian::big, request);
        error = error ? error : excess<std::uint16_t>(image, request);
    } else {
        error = readAll<std::uint8_t>(bytes, image, false, request);
        error = error ? error : excess<std::uint8_t>(image, request);
    }
    if (error)
        return *error;
    return image;
}

Numbers readRaw(ImageBytes &bytes, const PixelSize &size, const ImageRequest &request)
{
    if (auto refused = sizeRefusal(size, request))
        return *refused;
    NumberImage image;
    image.size = size;
    if (auto error = readInOrder<float>(bytes, image, std::endian::little, request))
        return *error;
    return image;
}

bool isColmap(std::string_view first)
{
    return ColmapHeader(first).isWhole();
}

Numbers readColmap(ImageBytes &bytes, const ImageRequest &request)
{
    const ColmapHeader header(bytes.first());
    if (header.channels() != 1)
        return ImageError{
            tr("the map of COLMAP has %1 numbers a pixel; give its map of depths, not of normals", header.channels())};
    NumberImage image;
    image.size = header.size();
    if (auto refused = sizeRefusal(image.size, request))
        return *refused;
    bytes.moveTo(header.end());
    if (auto error = readAll<float>(bytes, image, !kIsLittle, request))
        return *error;
    return image;
}

} // namespace unprojector::images
