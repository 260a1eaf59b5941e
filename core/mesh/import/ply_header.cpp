#include "core/mesh/import/ply_header.h"

#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/mesh/import/mesh_reader.h"

#include <algorithm>
#include <optional>

namespace unprojector::mesh::reader {
using base::integerFromWord;
using base::quoted;
using base::TextScanner;
using base::tr;

namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};

constexpr TypeName kTypeNames[] = {
    {"char", PlyType::Int8},       {"int8", PlyType::Int8},       {"uchar", PlyType::Uint8},
    {"uint8", PlyType::Uint8},     {"short", PlyType::Int16},     {"int16", PlyType::Int16},
    {"ushort", PlyType::Uint16},   {"uint16", PlyType::Uint16},   {"int", PlyType::Int32},
    {"int32", PlyType::Int32},     {"uint", PlyType::Uint32},     {"uint32", PlyType::Uint32},
    {"float", PlyType::Float32},   {"float32", PlyType::Float32}, {"double", PlyType::Float64},
    {"float64", PlyType::Float64},
};

PlyType typeNamed(std::string_view name, std::size_t line)
{
    for (const TypeName &candidate : kTypeNames) {
        if (candidate.name == name)
            return candidate.type;
    }
    failAtLine(line, tr("%1 is not a PLY type", quoted(name)));
}

PlyFormat formatNamed(std::string_view name, std::size_t line)
{
    if (name == "ascii")
        return PlyFormat::Ascii;
    if (name == "binary_little_endian")
        return PlyFormat::LittleEndian;
    if (name == "binary_big_endian")
        return PlyFormat::BigEndian;
    failAtLine(line, tr("%1 is not a PLY format", quoted(name)));
}

PlyProperty readProperty(TextScanner &scanner)
{
    PlyProperty property;
    std::string_view type = scanner.nextWordInLine();
    if (type == "list") {
        property.isList = true;
        property.countType = typeNamed(scanner.nextWordInLine(), scanner.line());
        if (isFloating(property.countType))
            failAtLine(scanner.line(), tr("a list's length must be an integer"));
        type = scanner.nextWordInLine();
    }
    property.type = typeNamed(type, scanner.line());
    property.name = scanner.nextWordInLine();
    return property;
}

void checkSizes(const PlyHeader &header, std::size_t fileBytes)
{
    // One byte more than available: the last line of an ASCII file may lack its end.
    const std::size_t available = fileBytes - header.bodyOffset + 1;
    for (const PlyElement &element : header.elements) {
        const std::size_t least = element.leastBytes(header.format);
        if (least > 0 && element.count > available / least)
            failMalformed(tr("the header declares %1 of element \"%2\", the file is too short for them", element.count,
                             element.name));
    }
}

} // namespace

std::size_t byteCount(PlyType type)
{
    switch (type) {
    case PlyType::Int8:
    case PlyType::Uint8: return 1;
    case PlyType::Int16:
    case PlyType::Uint16: return 2;
    case PlyType::Int32:
    case PlyType::Uint32:
    case PlyType::Float32: return 4;
    case PlyType::Float64: return 8;
    }
    return 0;
}

int PlyElement::find(std::string_view property) const
{
    const auto found = std::find_if(properties.begin(), properties.end(),
                                    [property](const PlyProperty &candidate) { return candidate.name == property; });
    return found == properties.end() ? -1 : static_cast<int>(found - properties.begin());
}

bool PlyElement::hasLists() const
{
    return std::any_of(properties.begin(), properties.end(), [](const PlyProperty &p) { return p.isList; });
}

std::size_t PlyElement::leastBytes(PlyFormat format) const
{
    std::size_t bytes = 0;
    for (const PlyProperty &property : properties)
        bytes += format == PlyFormat::Ascii ? 2 : byteCount(property.isList ? property.countType : property.type);
    return bytes;
}

const PlyElement *PlyHeader::find(std::string_view element) const
{
    const auto found = std::find_if(elements.begin(), elements.end(),
                                    [element](const PlyElement &candidate) { return candidate.name == element; });
    return found == elements.end() ? nullptr : &*found;
}

PlyHeader readPlyHeader(std::string_view file)
{
    PlyHeader header;
    TextScanner scanner(file);
    if (scanner.nextWordInLine() != "ply")
        failMalformed(tr("the file does not begin with \"ply\""));
    scanner.skipLine();
    bool hasFormat = false;
    for (;;) {
        const std::string_view word = scanner.nextWordInLine();
        if (word.empty() && scanner.isAtEnd())
            failMalformed(tr("the header has no \"end_header\""));
        if (word == "end_header") {
            scanner.skipLine();
            break;
        }
        if (word == "format") {
            header.format = formatNamed(scanner.nextWordInLine(), scanner.line());
            hasFormat = true;
        } else if (word == "element") {
            PlyElement element;
            element.name = scanner.nextWordInLine();
            const std::string_view count = scanner.nextWordInLine();
            const std::optional<long long> value = integerFromWord(count);
            if (!value || *value < 0)
                failAtLine(scanner.line(), tr("%1 is not a number of elements", quoted(count)));
            element.count = static_cast<std::size_t>(*value);
            if (header.find(element.name))
                failAtLine(scanner.line(), tr("the element %1 is there twice", quoted(std::string_view(element.name))));
            header.elements.push_back(std::move(element));
        } else if (word == "property") {
            if (header.elements.empty())
                failAtLine(scanner.line(), tr("a property before the first element"));
            PlyProperty property = readProperty(scanner);
            if (header.elements.back().find(property.name) >= 0)
                failAtLine(scanner.line(),
                           tr("the property %1 is twice in its element", quoted(std::string_view(property.name))));
            header.elements.back().properties.push_back(std::move(property));
        } else if (word == "comment") {
            if (scanner.nextWordInLine() == "TextureFile" && header.textureFile.empty()) {
                header.textureFile = scanner.restOfLine();
                continue;
            }
        } else if (!word.empty() && word != "obj_info") {
            failAtLine(scanner.line(), tr("%1 does not belong in a PLY header", quoted(word)));
        }
        scanner.skipLine();
    }
    if (!hasFormat)
        failMalformed(tr("the header has no \"format\""));
    header.bodyOffset = scanner.offset();
    header.bodyLine = scanner.line();
    checkSizes(header, file.size());
    return header;
}

} // namespace unprojector::mesh::reader
