// NumPy's arrays: https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html

#include "core/base/translation.h"
#include "core/images/formats.h"

#include <charconv>
#include <limits>
#include <type_traits>

namespace unprojector::images {
using base::tr;
using base::withSwappedBytes;
namespace {

/// The dictionary of a header: {'descr': '<f4', 'fortran_order': False, 'shape': (480, 640), }
struct Header {
    std::string type;
    bool isFortranOrder = false;
    std::vector<std::size_t> shape;
};

/// The parser of that dictionary, in any order and with any blanks.
class HeaderParser {
public:
    explicit HeaderParser(std::string_view text) : m_text(text) {}

    std::optional<Header> header()
    {
        Header result;
        unsigned known = 0;
        if (!take('{'))
            return std::nullopt;
        while (!take('}')) {
            const std::optional<std::string> key = quoted();
            if (!key || !take(':'))
                return std::nullopt;
            if (*key == "descr") {
                result.type = quoted().value_or(std::string(value()));
                known |= 1;
            } else if (*key == "fortran_order") {
                const std::string_view word = value();
                if (word != "True" && word != "False")
                    return std::nullopt;
                result.isFortranOrder = word == "True";
                known |= 2;
            } else if (*key == "shape") {
                if (!readShape(result.shape))
                    return std::nullopt;
                known |= 4;
            } else {
                return std::nullopt;
            }
            take(',');
        }
        if (known != 7)
            return std::nullopt;
        return result;
    }

private:
    void skipBlanks()
    {
        while (m_at < m_text.size() && (m_text[m_at] == ' ' || m_text[m_at] == '\n' || m_text[m_at] == '\t'))
            ++m_at;
    }
    bool take(char c)
    {
        skipBlanks();
        if (m_at == m_text.size() || m_text[m_at] != c)
            return false;
        ++m_at;
        return true;
    }
    std::optional<std::string> quoted()
    {
        skipBlanks();
        const char quote = m_at < m_text.size() ? m_text[m_at] : '\0';
        const std::size_t end = quote == '\'' || quote == '"' ? m_text.find(quote, m_at + 1) : std::string_view::npos;
        if (end == std::string_view::npos)
            return std::nullopt;
        const std::string word(m_text.substr(m_at + 1, end - m_at - 1));
        m_at = end + 1;
        return word;
    }
    /// Everything up to the comma or brace that ends a value outside brackets.
    std::string_view value()
    {
        skipBlanks();
        const std::size_t start = m_at;
        for (int depth = 0; m_at < m_text.size(); ++m_at) {
            const char c = m_text[m_at];
            if (depth == 0 && (c == ',' || c == '}'))
                break;
            depth += c == '[' || c == '(' ? 1 : c == ']' || c == ')' ? -1 : 0;
        }
        return m_text.substr(start, m_at - start);
    }
    bool readShape(std::vector<std::size_t> &shape)
    {
        if (!take('('))
            return false;
        while (!take(')')) {
            skipBlanks();
            std::size_t side = 0;
            const auto [end, error] = std::from_chars(m_text.data() + m_at, m_text.data() + m_text.size(), side);
            if (error != std::errc{})
                return false;
            shape.push_back(side);
            m_at = static_cast<std::size_t>(end - m_text.data());
            take(',');
        }
        return true;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
};

std::string shapeText(const std::vector<std::size_t> &shape)
{
    std::string text;
    for (const std::size_t side : shape)
        text += (text.empty() ? "" : ", ") + std::to_string(side);
    return '(' + text + (shape.size() == 1 ? ",)" : ")");
}

/// (H, W), (H, W, 1) or (1, H, W).
std::optional<PixelSize> sizeOf(const std::vector<std::size_t> &shape)
{
    if (shape.size() == 2)
        return PixelSize{shape[1], shape[0]};
    if (shape.size() == 3 && shape[2] == 1)
        return PixelSize{shape[1], shape[0]};
    if (shape.size() == 3 && shape[0] == 1)
        return PixelSize{shape[2], shape[1]};
    return std::nullopt;
}

/// A number of 16 bits that is a float.
struct Half {
    std::uint16_t bits;
};

/// Reads all numbers, and stores them row after row.
/// @tparam Stored  the type of the image: exact for every File but whole numbers beyond 2^53
template <class File, class Stored>
std::optional<ImageError> readAs(ImageBytes &bytes, const Header &header, bool isSwapped, NumberImage &image,
                                 const ImageRequest &request)
{
    const auto [width, height] = image.size;
    auto numbers = std::make_unique_for_overwrite<Stored[]>(image.size.pixels());
    std::vector<File> block(std::min(kBlock, image.size.pixels()));
    for (std::size_t start = 0; start < image.size.pixels(); start += block.size()) {
        block.resize(std::min(block.size(), image.size.pixels() - start));
        if (!bytes.read(reinterpret_cast<char *>(block.data()), block.size() * sizeof(File)))
            return tooShort(image.size);
        for (std::size_t i = 0; i < block.size(); ++i) {
            const File value = isSwapped ? withSwappedBytes(block[i]) : block[i];
            const std::size_t at = start + i;
            const std::size_t pixel = header.isFortranOrder ? at % height * width + at / height : at;
            if constexpr (std::is_same_v<File, Half>)
                numbers[pixel] = floatFromHalf(value.bits);
            else
                numbers[pixel] = static_cast<Stored>(value);
        }
        request.onRead(block.size());
    }
    if (hasMore(bytes))
        return tooLong(image.size);
    if constexpr (std::is_integral_v<File>)
        image.greatest = static_cast<double>(std::numeric_limits<File>::max());
    image.numbers = std::move(numbers);
    return std::nullopt;
}

using Reader = std::optional<ImageError> (*)(ImageBytes &, const Header &, bool, NumberImage &, const ImageRequest &);

/// The reader of a type such as "f4".
Reader readerOf(std::string_view type)
{
    struct Row {
        std::string_view type;
        Reader reader;
    };
    static constexpr std::array<Row, 11> kReaders{{{"u1", readAs<std::uint8_t, std::uint8_t>},
                                                   {"u2", readAs<std::uint16_t, std::uint16_t>},
                                                   {"u4", readAs<std::uint32_t, double>},
                                                   {"u8", readAs<std::uint64_t, double>},
                                                   {"i1", readAs<std::int8_t, float>},
                                                   {"i2", readAs<std::int16_t, float>},
                                                   {"i4", readAs<std::int32_t, double>},
                                                   {"i8", readAs<std::int64_t, double>},
                                                   {"f2", readAs<Half, float>},
                                                   {"f4", readAs<float, float>},
                                                   {"f8", readAs<double, double>}}};
    const auto found = std::ranges::find(kReaders, type, &Row::type);
    return found == kReaders.end() ? nullptr : found->reader;
}

/// The header's text; the bytes stand behind it then.
std::optional<std::string> headerText(ImageBytes &bytes)
{
    constexpr std::size_t kMagic = 6, kMostText = 65536;
    std::array<unsigned char, 6> start{}; // version and length
    bytes.moveTo(kMagic);
    if (!bytes.read(reinterpret_cast<char *>(start.data()), 4))
        return std::nullopt;
    std::size_t length = base::numberAt<std::uint16_t>(start.data() + 2);
    if (start[0] >= 2) {
        if (!bytes.read(reinterpret_cast<char *>(start.data()) + 4, 2))
            return std::nullopt;
        length = base::numberAt<std::uint32_t>(start.data() + 2);
    }
    if (start[0] < 1 || start[0] > 3 || length > kMostText)
        return std::nullopt;
    std::string text(length, '\0');
    if (!bytes.read(text.data(), length))
        return std::nullopt;
    return text;
}

} // namespace

Numbers readNpy(ImageBytes &bytes, const ImageRequest &request)
{
    const std::optional<std::string> text = headerText(bytes);
    const std::optional<Header> header = text ? HeaderParser(*text).header() : std::nullopt;
    if (!header)
        return ImageError{tr("the header is damaged")};
    const std::optional<PixelSize> size = sizeOf(header->shape);
    if (!size)
        return ImageError{
            tr("the array has the shape %1; give one number a pixel: (height, width)", shapeText(header->shape))};
    const bool hasOrder = !header->type.empty() && std::string_view("<>=|").find(header->type[0]) != std::string::npos;
    const Reader reader = hasOrder ? readerOf(std::string_view(header->type).substr(1)) : nullptr;
    if (reader == nullptr)
        return ImageError{tr("the array has numbers of type %1; give whole numbers or floats, as by "
                             "array.astype(numpy.float32)",
                             header->type)};
    NumberImage image;
    image.size = *size;
    if (auto refused = sizeRefusal(image.size, request))
        return *refused;
    constexpr bool isLittle = std::endian::native == std::endian::little;
    const bool isSwapped = header->type[0] == (isLittle ? '>' : '<') && header->type.back() != '1';
    if (auto error = reader(bytes, *header, isSwapped, image, request))
        return *error;
    return image;
}

} // namespace unprojector::images
