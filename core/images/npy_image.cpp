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

/// The value of a key in the dictionary of a header, {'descr': '<f4', 'fortran_order': False, 'shape': (480, 640), };
/// nothing without it.
std::optional<std::string_view> valueOf(std::string_view header, std::string_view key)
{
    const std::size_t at = header.find('\'' + std::string(key) + '\'');
    const std::size_t colon = std::min(header.find(':', at), header.size());
    const std::string_view value = base::trimmed(header.substr(std::min(colon + 1, header.size())));
    const char closing = value.starts_with('(') ? ')' : value.starts_with('[') ? ']' : '\0';
    const std::size_t end = closing != '\0' ? value.find(closing) : value.find_first_of(",}");
    if (end == value.npos)
        return std::nullopt;
    return value.substr(0, closing != '\0' ? end + 1 : end);
}

/// The sides of an array: "(480, 640)". Nothing for another text.
std::optional<std::vector<std::size_t>> shapeOf(std::string_view text)
{
    if (!text.starts_with('('))
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
    const bool isRead = bytes.read(start.data(), 4) && (start[0] == 1 || bytes.read(start.data() + 4, 2));
    const auto *length = reinterpret_cast<const std::uint8_t *>(start.data()) + 2;
    std::string text(start[0] == 1 ? base::numberAt<std::uint16_t>(length) : base::numberAt<std::uint32_t>(length),
                     ' ');
    if (!isRead || start[0] < 1 || start[0] > 3 || text.size() > kMostText || !bytes.read(text.data(), text.size()))
        return {};
    return text;
}

} // namespace

NumberImage readNpy(ImageBytes &bytes, const ImageRequest &request)
{
    std::string text = headerText(bytes);
    std::ranges::replace(text, '"', '\'');
    const auto type = valueOf(text, "descr"), order = valueOf(text, "fortran_order"), sides = valueOf(text, "shape");
    const auto shape = sides ? shapeOf(*sides) : std::nullopt;
    if (!type || !shape || (order != "True" && order != "False"))
        throw Error{tr("the header is damaged")};
    NumberImage image;
    image.size = sizeOf(*shape, *sides);
    // "<f4"
    const std::string_view name = type->starts_with('\'') ? type->substr(1, type->size() - 2) : *type;
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
            if (order == "True")
                readNumbers<File>(bytes, image, byteOrder, request, columnByColumn);
            else
                readNumbers<File>(bytes, image, byteOrder, request);
            image.greatest = kGreatest<File>;
        },
        *number);
    return image;
}

} // namespace unprojector::images
