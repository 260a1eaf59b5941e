#include "core/cli/rows/depth_image.h"

#include "core/cli/rows/byte_stream.h"
#include "core/text/number_text.h"
#include "core/text/translation.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace unprojector::cli {
using text::tr;
namespace {

constexpr std::size_t kMostSide = 65536;
constexpr std::size_t kBlock = std::size_t{1} << 16; ///< number of depths read at a time

struct Size {
    std::size_t width = 0, height = 0;
};

bool isSpace(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

std::optional<std::size_t> sideOf(std::string_view text)
{
    std::size_t side = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
    if (error != std::errc{} || end != text.data() + text.size() || side == 0 || side > kMostSide)
        return std::nullopt;
    return side;
}

std::optional<Size> sizeOf(const std::string &text)
{
    const std::size_t cross = text.find('x');
    if (cross == std::string::npos)
        return std::nullopt;
    const auto width = sideOf(std::string_view(text).substr(0, cross));
    const auto height = sideOf(std::string_view(text).substr(cross + 1));
    if (!width || !height)
        return std::nullopt;
    return Size{*width, *height};
}

/// The words of a PFM's or PGM's header; comments, from # to the line's end, are skipped.
class Header {
public:
    explicit Header(const std::string &bytes) : m_bytes(bytes) {}

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
        return std::string_view(m_bytes).substr(start, m_at - start);
    }
    /// The start of the pixels: one blank after the last word.
    std::size_t end() const { return std::min(m_at + 1, m_bytes.size()); }

private:
    const std::string &m_bytes;
    std::size_t m_at = 0;
};

/// A file's bytes in order; the first ones were read beforehand.
class Bytes {
public:
    explicit Bytes(ByteSource &source) : m_source(source)
    {
        constexpr std::size_t kMostHeader = 4096;
        m_first.resize(kMostHeader);
        m_first.resize(m_source.read(m_first.data(), kMostHeader));
    }

    const std::string &first() const { return m_first; }
    void skip(std::size_t count) { m_at = count; }
    bool read(char *target, std::size_t count)
    {
        const std::size_t seen = std::min(count, m_first.size() - m_at);
        std::memcpy(target, m_first.data() + m_at, seen);
        m_at += seen;
        return seen == count || m_source.read(target + seen, count - seen) == count - seen;
    }

private:
    ByteSource &m_source;
    std::string m_first;
    std::size_t m_at = 0;
};

/// The format of the pixels according to a header.
struct Layout {
    enum class Kind { Raw, Pfm, Pgm } kind = Kind::Raw;
    Size size;
    bool isLittleEndian = true;
    double greatest = 0.0; ///< PGM: the value of 1; PFM: the scale, negative for little-endian
};

/// The layout; empty if the header is broken. Without a header, the layout is raw and has no size.
std::optional<Layout> layoutOf(Bytes &bytes)
{
    const std::string_view magic = std::string_view(bytes.first()).substr(0, 2);
    const bool hasHeader = bytes.first().size() > 2 && isSpace(bytes.first()[2]) && (magic == "Pf" || magic == "P5");
    Layout layout;
    if (!hasHeader)
        return layout;
    layout.kind = magic == "Pf" ? Layout::Kind::Pfm : Layout::Kind::Pgm;
    Header header(bytes.first());
    header.word();
    const auto width = sideOf(header.word()), height = sideOf(header.word());
    const std::string_view last = header.word();
    const auto [end, error] = std::from_chars(last.data(), last.data() + last.size(), layout.greatest);
    if (!width || !height || error != std::errc{} || end != last.data() + last.size())
        return std::nullopt;
    const double greatest = layout.greatest;
    const bool isMeant = layout.kind == Layout::Kind::Pfm
                             ? greatest != 0.0 && std::isfinite(greatest)
                             : greatest >= 1.0 && greatest <= 65535.0 && greatest == std::floor(greatest);
    if (!isMeant)
        return std::nullopt;
    layout.size = {*width, *height};
    layout.isLittleEndian = greatest < 0.0;
    bytes.skip(header.end());
    return layout;
}

template <class Number>
void swapEach(std::span<Number> values)
{
    for (Number &value : values) {
        auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(value);
        std::ranges::reverse(bytes);
        value = std::bit_cast<Number>(bytes);
    }
}

double stretched(double number, const DepthEnds &ends)
{
    return ends.low + number * (ends.high - ends.low);
}

bool readFloats(Bytes &bytes, const Layout &layout, const std::optional<DepthEnds> &ends, std::span<float> depths)
{
    if (!bytes.read(reinterpret_cast<char *>(depths.data()), depths.size_bytes()))
        return false;
    if (layout.isLittleEndian != (std::endian::native == std::endian::little))
        swapBytes(depths);
    if (ends) {
        for (float &depth : depths)
            depth = static_cast<float>(stretched(static_cast<double>(depth), *ends));
    }
    return true;
}

/// A pixel whose value exceeds the header's limit.
struct Excess {
    std::size_t pixel; ///< index from the first pixel read
    unsigned value;
};

bool readIntegers(Bytes &bytes, const Layout &layout, const DepthEnds &ends, std::span<float> depths,
                  std::optional<Excess> &excess)
{
    const std::size_t pixelBytes = layout.greatest > 255.0 ? 2 : 1;
    std::string pixels(depths.size() * pixelBytes, '\0');
    if (!bytes.read(pixels.data(), pixels.size()))
        return false;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        unsigned value = static_cast<unsigned char>(pixels[i * pixelBytes]);
        if (pixelBytes == 2)
            value = value << 8 | static_cast<unsigned char>(pixels[i * pixelBytes + 1]);
        if (value > layout.greatest && !excess)
            excess = {i, value};
        depths[i] = static_cast<float>(stretched(value / layout.greatest, ends));
    }
    return true;
}

std::string shown(const Size &size)
{
    return std::to_string(size.width) + 'x' + std::to_string(size.height);
}

} // namespace

void swapBytes(std::span<float> values)
{
    swapEach(values);
}

void swapBytes(std::span<double> values)
{
    swapEach(values);
}

std::optional<DepthImage> readDepthImage(const std::string &file, const std::string &sizeText,
                                         std::size_t expectedWidth, std::size_t expectedHeight,
                                         const std::optional<DepthEnds> &stretchedOver,
                                         const std::function<void(std::span<const float>)> &onRead)
{
    std::optional<Size> given;
    if (!sizeText.empty()) {
        given = sizeOf(sizeText);
        if (!given) {
            complain(tr("%1: give width and height in pixels, as in 1920x1080", "--size " + sizeText));
            return std::nullopt;
        }
    }
    ByteSource source(file);
    if (!source.isOpen())
        return std::nullopt;
    const auto refuse = [&](const std::string &what) {
        complain(source.name() + ": " + (source.hasFailed() ? tr("reading stopped at an error") : what));
        return std::nullopt;
    };
    Bytes bytes(source);
    std::optional<Layout> layout = layoutOf(bytes);
    if (!layout)
        return refuse(tr("the header is damaged"));
    if (layout->kind == Layout::Kind::Raw) {
        if (!given)
            return refuse(tr("neither PFM nor PGM; for raw 32-bit floats give --size WxH"));
        layout->size = *given;
    }
    const Size size = layout->size;
    if (given && (given->width != size.width || given->height != size.height))
        return refuse(tr("the image has %1 pixels, not %2", shown(size), sizeText));
    if (size.width != expectedWidth || size.height != expectedHeight)
        return refuse(tr("the image has %1 pixels, the scene's window %2 pixels", shown(size),
                         shown({expectedWidth, expectedHeight})));

    DepthImage image{size.width, size.height, std::make_unique_for_overwrite<float[]>(size.width * size.height),
                     layout->kind == Layout::Kind::Pfm};
    if (layout->kind == Layout::Kind::Pfm && std::abs(layout->greatest) != 1.0)
        complain(source.name() + ": "
                 + tr("the header has the scale %1, which is not applied: the depths are used unchanged",
                      text::shortestText(std::abs(layout->greatest))));
    std::optional<Excess> excess;
    const std::span<float> all(image.depths.get(), size.width * size.height);
    for (std::size_t start = 0; start < all.size(); start += kBlock) {
        const std::span<float> block = all.subspan(start, std::min(kBlock, all.size() - start));
        if (!(layout->kind == Layout::Kind::Pgm
                  ? readIntegers(bytes, *layout, stretchedOver.value_or(DepthEnds()), block, excess)
                  : readFloats(bytes, *layout, stretchedOver, block)))
            return refuse(tr("the file is too short for %1 pixels", shown(size)));
        if (excess)
            return refuse(tr("the pixel in column %1 and row %2 has the value %3, and the header says that %4 is the "
                             "greatest (both counted from 0, from the upper left)",
                             (start + excess->pixel) % size.width, (start + excess->pixel) / size.width, excess->value,
                             text::shortestText(layout->greatest)));
        onRead(block);
    }
    char more = 0;
    if (bytes.read(&more, 1))
        return refuse(tr("the file is too long for %1 pixels", shown(size)));
    return image;
}

} // namespace unprojector::cli
