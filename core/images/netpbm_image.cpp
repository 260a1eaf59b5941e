// PFM, PGM and raw floats.

#include "core/images/formats.h"
#include "core/text/number_text.h"
#include "core/text/translation.h"

#include <charconv>
#include <cmath>

namespace unprojector::images {
using text::tr;
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

/// The first pixel above the greatest value that the header declares.
template <class Number>
std::optional<ImageError> excess(const NumberImage &image)
{
    const Number *numbers = std::get<std::unique_ptr<Number[]>>(image.numbers).get();
    const std::size_t count = image.size.pixels();
    const Number *found = std::find_if(numbers, numbers + count, [&](Number n) { return n > image.greatest; });
    if (found == numbers + count)
        return std::nullopt;
    const auto pixel = static_cast<std::size_t>(found - numbers);
    return ImageError{tr("the pixel in column %1 and row %2 has the value %3, and the header says that %4 is the "
                         "greatest (both counted from 0, from the upper left)",
                         pixel % image.size.width, pixel / image.size.width, unsigned{*found},
                         text::shortestText(image.greatest))};
}

constexpr bool kIsLittle = std::endian::native == std::endian::little;

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
    if (auto refused = sizeRefusal(image.size, request))
        return *refused;
    bytes.moveTo(header.end());
    std::optional<ImageError> error;
    if (isPfm) {
        image.isBottomFirst = true;
        if (std::abs(*last) != 1.0)
            image.notes.push_back(tr("the header has the scale %1, which is not applied: the depths are used unchanged",
                                     text::shortestText(std::abs(*last))));
        error = readAll<float>(bytes, image, (*last < 0.0) != kIsLittle, request);
    } else if (image.greatest = *last; image.greatest > 255.0) {
        error = readAll<std::uint16_t>(bytes, image, kIsLittle, request);
        error = error ? error : excess<std::uint16_t>(image);
    } else {
        error = readAll<std::uint8_t>(bytes, image, false, request);
        error = error ? error : excess<std::uint8_t>(image);
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
    if (auto error = readAll<float>(bytes, image, !kIsLittle, request))
        return *error;
    return image;
}

} // namespace unprojector::images
