// NumPy's arrays: https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html

#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/images/formats.h"

#include <string>
#include <vector>

namespace unprojector::images {
using base::Error;
using base::tr;
namespace {

/// The dictionary of a header: {'descr': '<f4', 'fortran_order': False, 'shape': (480, 640), }
struct Header {
    std::string_view type, order, sides;
};

/// Iterates over the parts of a dictionary.
class HeaderScanner {
public:
    explicit HeaderScanner(std::string_view text) : m_text(text) {}

    /// Moves past blanks and a character. Returns whether it is there.
    bool take(char c)
    {
        m_text = base::trimmed(m_text);
        const bool isThere = m_text.starts_with(c);
        m_text.remove_prefix(isThere ? 1 : 0);
        return isThere;
    }
    /// The text up to one of some characters outside quotes and brackets, or to the end; without blanks around it.
    std::string_view textBefore(std::string_view ends)
    {
        std::size_t at = 0;
        char quote = '\0';
        for (int depth = 0; at < m_text.size(); ++at) {
            const char c = m_text[at];
            if (quote != '\0')
                quote = c == quote ? '\0' : quote;
            else if (depth == 0 && ends.find(c) != ends.npos)
                break;
            else if (c == '\'' || c == '"')
                quote = c;
            else
                depth += c == '[' || c == '(' ? 1 : c == ']' || c == ')' ? -1 : 0;
        }
        const std::string_view text = m_text.substr(0, at);
        m_text.remove_prefix(at);
        return base::trimmed(text);
    }

private:
    std::string_view m_text;
};

/// The text between quotes; nothing without the same quote at both ends.
std::optional<std::string_view> unquoted(std::string_view text)
{
    const bool isQuoted =
        text.size() >= 2 && (text[0] == '\'' || text[0] == '"') && text.find(text[0], 1) == text.size() - 1;
    return isQuoted ? std::optional(text.substr(1, text.size() - 2)) : std::nullopt;
}

/// Nothing for a damaged text.
std::optional<Header> headerIn(std::string_view text)
{
    HeaderScanner scanner(text);
    Header header;
    if (!scanner.take('{'))
        return std::nullopt;
    while (!scanner.take('}')) {
        const auto key = unquoted(scanner.textBefore(":"));
        if (!scanner.take(':'))
            return std::nullopt;
        const std::string_view value = scanner.textBefore(",}");
        scanner.take(',');
        if (key == "descr")
            header.type = unquoted(value).value_or(value.starts_with('[') ? value : "");
        else if (key == "fortran_order")
            header.order = value;
        else if (key == "shape")
            header.sides = value;
        else
            return std::nullopt;
    }
    return header;
}

/// The sides of an array: "(480, 640)". Nothing for another text.
std::optional<std::vector<std::size_t>> shapeOf(std::string_view text)
{
    if (!text.starts_with('(') || !text.ends_with(')'))
        return std::nullopt;
    std::string words(text.substr(1, text.size() - 2));
    std::ranges::replace(words, ',', ' ');
    base::TextScanner scanner(words);
    std::vector<std::size_t> shape;
    for (std::string_view word = scanner.nextWord(); !word.empty(); word = scanner.nextWord()) {
        const auto side = base::numberIn<std::size_t>(word);
        if (!side)
            return std::nullopt;
        shape.push_back(*side);
    }
    return shape;
}

/// (H, W), (H, W, 1) or (1, H, W).
PixelSize sizeOf(const std::vector<std::size_t> &shape, std::string_view text)
{
    if (shape.size() == 2 || (shape.size() == 3 && shape[2] == 1))
        return {shape[1], shape[0]};
    if (shape.size() == 3 && shape[0] == 1)
        return {shape[2], shape[1]};
    throw Error{tr("the array has the shape %1; give one number a pixel: (height, width)", text)};
}

/// The header's text; the bytes stand behind it then. Empty where it is damaged.
std::string headerText(ImageBytes &bytes)
{
    constexpr std::size_t kMagic = 6, kMostText = 65536;
    std::array<char, 6> start{}; // version and length
    bytes.moveTo(kMagic);
    if (!bytes.read(start.data(), 4) || start[0] < 1 || start[0] > 3
        || (start[0] > 1 && !bytes.read(start.data() + 4, 2)))
        return {};
    const auto *at = reinterpret_cast<const std::uint8_t *>(start.data()) + 2;
    const std::size_t length = start[0] == 1 ? base::numberAt<std::uint16_t>(at) : base::numberAt<std::uint32_t>(at);
    if (length > kMostText)
        return {};
    std::string text(length, ' ');
    if (!bytes.read(text.data(), text.size()))
        return {};
    return text;
}

} // namespace

NumberImage readNpy(ImageBytes &bytes, const ImageRequest &request)
{
    const std::string text = headerText(bytes);
    const std::optional<Header> header = headerIn(text);
    const auto shape = header ? shapeOf(header->sides) : std::nullopt;
    if (!shape || header->type.empty() || (header->order != "True" && header->order != "False"))
        throw Error{tr("the header is damaged")};
    NumberImage image;
    image.size = sizeOf(*shape, header->sides);
    const std::string_view name = header->type; // "<f4"
    const bool hasOrder = name.find_first_of("<>=|") == 0;
    const std::optional<FileNumber> number = hasOrder ? fileNumber(name.substr(1)) : std::nullopt;
    if (!number)
        throw Error{tr("the array has numbers of type %1; give whole numbers or floats, as by "
                       "array.astype(numpy.float32)",
                       name)};
    checkSize(image.size, request);
    const std::endian byteOrder = name[0] == '>'   ? std::endian::big
                                  : name[0] == '<' ? std::endian::little
                                                   : std::endian::native;
    const auto columnByColumn = [size = image.size](std::size_t index) {
        return index % size.height * size.width + index / size.height;
    };
    std::visit(
        [&]<class File>(File) {
            if (header->order == "True")
                readNumbers<File>(bytes, image, byteOrder, request, columnByColumn);
            else
                readNumbers<File>(bytes, image, byteOrder, request);
            image.greatest = kGreatest<File>;
        },
        *number);
    return image;
}

} // namespace unprojector::images
