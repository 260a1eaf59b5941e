#include "core/base/byte_order.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/mesh/import/material.h"
#include "core/mesh/import/mesh_reader.h"
#include "core/mesh/import/polygon_mesh.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace unprojector::mesh::reader {
using namespace base;
using namespace geometry;

namespace {

constexpr std::size_t kElementsBetweenReports = 1 << 14;
/// A few milliseconds of work.
constexpr std::size_t kVerticesInTask = 1 << 16, kFacesInTask = 1 << 17;

/// A type of numbers in the file.
struct PlyType {
    std::string_view name, sizedName;
    std::size_t bytes;
    bool isInteger, fitsFloat;
    double least, most;
    double (*read)(const std::uint8_t *bytes, std::endian order);
};

template <class Number>
constexpr PlyType plyType(std::string_view name, std::string_view sizedName)
{
    return {name,
            sizedName,
            sizeof(Number),
            std::is_integral_v<Number>,
            std::numeric_limits<Number>::digits <= std::numeric_limits<float>::digits,
            static_cast<double>(std::numeric_limits<Number>::lowest()),
            static_cast<double>(std::numeric_limits<Number>::max()),
            [](const std::uint8_t *bytes, std::endian order) {
                return static_cast<double>(numberAt<Number>(bytes, order));
            }};
}

constexpr PlyType kTypes[] = {
    plyType<std::int8_t>("char", "int8"),    plyType<std::uint8_t>("uchar", "uint8"),
    plyType<std::int16_t>("short", "int16"), plyType<std::uint16_t>("ushort", "uint16"),
    plyType<std::int32_t>("int", "int32"),   plyType<std::uint32_t>("uint", "uint32"),
    plyType<float>("float", "float32"),      plyType<double>("double", "float64"),
};

struct PlyProperty {
    std::string name;
    const PlyType *type = nullptr;
    const PlyType *countType = nullptr; ///< of a list's length; null: no list
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;

    /// The index of the first of some properties, or -1.
    int find(std::initializer_list<std::string_view> names, bool isList = false) const
    {
        for (const std::string_view wanted : names) {
            for (std::size_t p = 0; p < properties.size(); ++p) {
                if (properties[p].name == wanted && (properties[p].countType != nullptr) == isList)
                    return static_cast<int>(p);
            }
        }
        return -1;
    }
    bool hasLists() const
    {
        return std::ranges::any_of(properties, [](const PlyProperty &p) { return p.countType != nullptr; });
    }
};

struct PlyHeader {
    bool isText = true;
    std::endian byteOrder = std::endian::little;
    std::vector<PlyElement> elements;
    std::string textureFile; ///< from "comment TextureFile …", or empty
    std::size_t bodyOffset = 0;
    std::size_t bodyLine = 1;

    const PlyElement *find(std::string_view element) const
    {
        const auto found = std::ranges::find(elements, element, &PlyElement::name);
        return found == elements.end() ? nullptr : &*found;
    }
    /// The minimum number of bytes that an element takes in the file.
    std::size_t leastBytes(const PlyElement &element) const
    {
        std::size_t bytes = 0;
        for (const PlyProperty &property : element.properties)
            bytes += isText ? 2 : (property.countType ? property.countType : property.type)->bytes;
        return bytes;
    }
};

const PlyType &typeNamed(std::string_view name, std::size_t line)
{
    for (const PlyType &type : kTypes) {
        if (type.name == name || type.sizedName == name)
            return type;
    }
    failAtLine(line, tr("%1 is not a PLY type", quoted(name)));
}

PlyProperty readProperty(TextScanner &scanner)
{
    PlyProperty property;
    std::string_view type = scanner.nextWordInLine();
    if (type == "list") {
        property.countType = &typeNamed(scanner.nextWordInLine(), scanner.line());
        if (!property.countType->isInteger)
            failAtLine(scanner.line(), tr("a list's length must be an integer"));
        type = scanner.nextWordInLine();
    }
    property.type = &typeNamed(type, scanner.line());
    property.name = scanner.nextWordInLine();
    return property;
}

/// Parses the header. Also checks that the declared elements fit into the file.
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
            const std::string_view format = scanner.nextWordInLine();
            header.isText = format == "ascii";
            header.byteOrder = format == "binary_big_endian" ? std::endian::big : std::endian::little;
            if (!header.isText && format != "binary_little_endian" && format != "binary_big_endian")
                failAtLine(scanner.line(), tr("%1 is not a PLY format", quoted(format)));
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
            const std::vector<PlyProperty> &known = header.elements.back().properties;
            if (std::ranges::find(known, property.name, &PlyProperty::name) != known.end())
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
    // One byte more than available: the last line of a text may lack its end.
    const std::size_t available = file.size() - header.bodyOffset + 1;
    for (const PlyElement &element : header.elements) {
        const std::size_t least = header.leastBytes(element);
        if (least > 0 && element.count > available / least)
            failMalformed(tr("the header declares %1 of element \"%2\", the file is too short for them", element.count,
                             element.name));
    }
    return header;
}

/// The start of the next line.
std::size_t nextLine(std::string_view text, std::size_t from)
{
    TextScanner scanner(text, from);
    scanner.skipLine();
    return scanner.offset();
}

/// Reads the values after the header one by one. Every function throws Damage if the file ends or
/// holds an unexpected value.
class PlyBody {
public:
    PlyBody(const Source &source, const PlyHeader &header)
        : m_source(source), m_header(header), m_bytes(source.bytes), m_at(header.bodyOffset),
          m_scanner(source.unpaddedText(), header.bodyOffset, header.bodyLine)
    {
    }
    const PlyHeader &header() const { return m_header; }
    base::Reporter &progress() const { return m_source.progress; }

    /// Begins an element's values; in text, at the start of a line.
    void beginElement(const PlyElement &element, std::size_t number)
    {
        m_element = &element;
        m_number = number;
        if (!m_isPart && number % kElementsBetweenReports == 0)
            m_source.progress.report(static_cast<double>(offset()) / static_cast<double>(m_bytes.size()));
        if (m_header.isText)
            skipComments();
    }

    double value(const PlyType &type)
    {
        if (m_header.isText)
            return asciiValue(type);
        return type.read(take(type.bytes), m_header.byteOrder);
    }

    /// Reads a vertex number: -1 where a strip restarts, -2 for a number that no file can have.
    std::int64_t corner(const PlyType &type)
    {
        const double number = value(type);
        if (number != std::floor(number))
            failMalformed(tr("%1 refers to vertex %2, which is not a whole number", where(), shortestText(number)));
        return number >= -1.0 && number <= 4294967295.0 ? static_cast<std::int64_t>(number) : -2;
    }

    /// Reads a list's length, checked against the rest of the file.
    std::size_t listLength(const PlyProperty &list)
    {
        const double length = value(*list.countType);
        const std::size_t bytesEach = m_header.isText ? 2 : list.type->bytes;
        if (!(length >= 0.0))
            failMalformed(tr("%1 has a list of negative length", where()));
        const std::size_t most = (bytesLeft() + 1) / bytesEach;
        if (length > static_cast<double>(most))
            failTruncated();
        return static_cast<std::size_t>(length);
    }

    void skip(const PlyProperty &property)
    {
        const std::size_t count = property.countType ? listLength(property) : 1;
        for (std::size_t i = 0; i < count; ++i) {
            if (m_header.isText)
                asciiNumber(*property.type); // unused values may be out of range
            else
                take(property.type->bytes);
        }
    }

    /// Ends an element's values; in text, its line must end here.
    void endElement()
    {
        if (!m_header.isText)
            return;
        if (const std::string_view word = m_scanner.nextWordInLine(); !word.empty())
            failAtLine(m_scanner.line(), tr("%1 follows all that the header declares for %2", quoted(word), where()));
    }

    /// Skips all instances of an element.
    void skipAll(const PlyElement &element)
    {
        // An element without properties takes no space in the file.
        for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            beginElement(element, i);
            for (const PlyProperty &property : element.properties)
                skip(property);
            endElement();
        }
    }

    /// Ends the file after the last element. In text only blanks may follow.
    /// @return the number of bytes that follow in a binary file, 0 if they are blank
    std::size_t end()
    {
        if (m_header.isText) {
            skipComments();
            if (const std::string_view word = m_scanner.nextWordInLine(); !word.empty())
                failAtLine(m_scanner.line(),
                           tr("%1 follows all elements that the header declares; correct their numbers in the header",
                              quoted(word)));
            return 0;
        }
        return bytesThatMean(m_bytes.subspan(m_at));
    }

    /// Reads all instances of an element on all cores, each one a line of a long text, and moves
    /// past them.
    /// @param read  called at once from several threads, each with a body of its own at its first
    ///         instance
    /// @return false if parallel reading does not pay off, or anything is wrong. Then the position
    ///         is unchanged, and sequential reading reports the error. The values that `read` has
    ///         stored must be stored anew
    bool readLines(const PlyElement &element,
                   const std::function<void(PlyBody &part, std::size_t first, std::size_t count)> &read)
    {
        const std::string_view text = m_source.unpaddedText();
        const std::size_t begin = offset();
        const std::vector<std::string_view> pieces = m_header.isText && !element.properties.empty() && element.count > 0
                                                         ? textPieces(text.substr(begin), nextLine)
                                                         : std::vector<std::string_view>();
        if (pieces.size() < 2)
            return false;
        std::vector<Lines> parts(pieces.size());
        inParallel(pieces.size(), {}, [&](std::size_t i) {
            parts[i].text = pieces[i];
            TextScanner scanner(pieces[i]);
            for (; !scanner.isAtEnd(); scanner.skipLine())
                parts[i].filled += scanner.nextWordInLine().empty() ? 0U : 1U;
            parts[i].lines = scanner.line() - 1;
        });
        std::size_t first = 0, line = m_scanner.line(), used = 0;
        for (; used < parts.size() && first < element.count; ++used) {
            Lines &part = parts[used];
            part.line = line;
            part.first = first;
            part.count = std::min(part.filled, element.count - first);
            line += part.lines;
            first += part.count;
        }
        if (first < element.count)
            return false;
        std::vector<PlyBody> bodies(used, *this);
        try {
            const auto share = [&](std::size_t at) {
                return static_cast<double>(at) / static_cast<double>(text.size());
            };
            const auto endOf = [&](const Lines &part) {
                return static_cast<std::size_t>(part.text.data() - text.data()) + part.text.size();
            };
            inParallel(used, progress().part(share(begin), share(endOf(parts[used - 1]))), [&](std::size_t i) {
                PlyBody &body = bodies[i];
                body.m_isPart = true;
                body.m_bytes = m_bytes.first(endOf(parts[i]));
                body.m_scanner =
                    TextScanner(text.substr(0, endOf(parts[i])), endOf(parts[i]) - parts[i].text.size(), parts[i].line);
                read(body, parts[i].first, parts[i].count);
            });
        } catch (const base::Error &) {
            return false;
        }
        m_scanner = TextScanner(text, bodies.back().m_scanner.offset(), bodies.back().m_scanner.line());
        return true;
    }

    /// The position of the next values of a binary file.
    const std::uint8_t *next() const { return m_bytes.data() + m_at; }
    /// The same, and moves past them.
    const std::uint8_t *take(std::size_t size)
    {
        if (m_bytes.size() - m_at < size)
            failTruncated();
        const std::uint8_t *begin = m_bytes.data() + m_at;
        m_at += size;
        return begin;
    }

    std::size_t bytesLeft() const { return m_bytes.size() - offset(); }

private:
    /// Whole lines, to be read in parallel with others.
    struct Lines {
        std::string_view text;
        std::size_t lines = 0, filled = 0; ///< line ends; lines with more than blanks
        std::size_t line = 0;              ///< the number of the first line
        std::size_t first = 0, count = 0;  ///< the elements
    };

    /// Skips comments: some programs write them among the data, as in the header.
    void skipComments()
    {
        m_scanner.skipBlankLines();
        for (TextScanner ahead = m_scanner;; ahead = m_scanner) {
            const std::string_view word = ahead.nextWordInLine();
            if (word != "comment" && word != "obj_info" && !word.starts_with('#'))
                return;
            m_scanner.skipLine();
            m_scanner.skipBlankLines();
        }
    }

    std::size_t offset() const { return m_header.isText ? m_scanner.offset() : m_at; }
    std::string where() const { return m_element->name + ' ' + std::to_string(m_number); }
    [[noreturn]] void failTruncated() const
    {
        failMalformed(tr("the file ends within %1 of %2", where(), m_element->count));
    }

    /// Reads the next number of a line of text; its range is not checked.
    double asciiNumber(const PlyType &type)
    {
        const std::string_view word = m_scanner.nextWordInLine();
        if (word.empty()) {
            if (m_scanner.isAtEnd())
                failTruncated();
            failAtLine(m_scanner.line(), tr("the line ends before all that the header declares for %1", where()));
        }
        const std::optional<long long> integer = type.isInteger ? integerFromWord(word) : std::nullopt;
        const std::optional<double> number =
            integer ? std::optional(static_cast<double>(*integer)) : doubleFromWord(word);
        if (!number)
            failAtLine(m_scanner.line(), tr("%1 is not a number", quoted(word)));
        return *number;
    }

    /// Reads the next number and checks that its type can hold it.
    double asciiValue(const PlyType &type)
    {
        TextScanner ahead = m_scanner;
        const double number = asciiNumber(type);
        if (type.isInteger && (!(number >= type.least && number <= type.most) || number != std::floor(number)))
            failAtLine(m_scanner.line(),
                       tr("%1 is not a whole number from %2 to %3, which the header declares for %4",
                          quoted(ahead.nextWordInLine()), shortestText(type.least), shortestText(type.most), where()));
        return number;
    }

    const Source &m_source;
    const PlyHeader &m_header;
    std::span<const std::uint8_t> m_bytes;
    std::size_t m_at;
    TextScanner m_scanner;
    bool m_isPart = false; ///< read in parallel with others: it reports nothing
    const PlyElement *m_element = nullptr;
    std::size_t m_number = 0;
};

/// The properties that hold an element's colour.
struct PlyColor {
    explicit PlyColor(const PlyElement &element)
        : channels{element.find({"red", "r", "diffuse_red"}), element.find({"green", "g", "diffuse_green"}),
                   element.find({"blue", "b", "diffuse_blue"}), element.find({"alpha", "a", "diffuse_alpha"})}
    {
    }
    bool isComplete() const { return channels[0] >= 0 && channels[1] >= 0 && channels[2] >= 0; }
    /// @param values  of the element, one a property
    glm::u8vec4 color(const PlyElement &element, const std::vector<double> &values) const
    {
        glm::u8vec4 result(255);
        for (int c = 0; c < 4; ++c) {
            if (channels[static_cast<std::size_t>(c)] < 0)
                continue;
            const auto property = static_cast<std::size_t>(channels[static_cast<std::size_t>(c)]);
            const PlyType &type = *element.properties[property].type;
            const double white = !type.isInteger ? 1.0 : type.bytes == 1 ? 255.0 : 65535.0;
            result[c] = byteFromShare(values[property] / white);
        }
        return result;
    }

    std::array<int, 4> channels; ///< indices of properties, or -1
};

/// The meaning of a vertex's properties.
struct VertexLayout {
    explicit VertexLayout(const PlyElement &vertices)
        : element(vertices), position{element.find({"x"}), element.find({"y"}), element.find({"z"})},
          normal{element.find({"nx"}), element.find({"ny"}), element.find({"nz"})},
          texcoord{element.find({"s", "u", "texture_u", "tex_u"}), element.find({"t", "v", "texture_v", "tex_v"})},
          color(element), hasNormals(std::ranges::min(normal) >= 0), hasTexcoords(std::ranges::min(texcoord) >= 0),
          isUsed(element.properties.size())
    {
        if (std::ranges::min(position) < 0)
            failMalformed(tr("the vertices have no x, y and z"));
        const auto use = [this](bool areRead, std::span<const int> properties) {
            for (const int property : properties) {
                if (areRead && property >= 0)
                    isUsed[static_cast<std::size_t>(property)] = true;
            }
        };
        use(true, position);
        use(hasNormals, normal);
        use(hasTexcoords, texcoord);
        use(color.isComplete(), color.channels);
    }

    /// Sets all attributes of a vertex but its position; the arrays must have their sizes.
    void set(Mesh &mesh, std::size_t vertex, const std::vector<double> &values) const
    {
        const auto at = [&values](int property) {
            return static_cast<float>(values[static_cast<std::size_t>(property)]);
        };
        if (hasNormals)
            mesh.normals[vertex] = {at(normal[0]), at(normal[1]), at(normal[2])};
        if (hasTexcoords)
            mesh.texcoords[vertex] = {at(texcoord[0]), at(texcoord[1])};
        if (color.isComplete())
            mesh.colors[vertex] = color.color(element, values);
    }
    glm::dvec3 positionIn(const std::vector<double> &values) const
    {
        return {values[static_cast<std::size_t>(position[0])], values[static_cast<std::size_t>(position[1])],
                values[static_cast<std::size_t>(position[2])]};
    }
    void resize(Mesh &mesh) const
    {
        mesh.normals.resize(hasNormals ? element.count : 0);
        mesh.texcoords.resize(hasTexcoords ? element.count : 0);
        mesh.colors.resize(color.isComplete() ? element.count : 0);
    }

    const PlyElement &element;
    std::array<int, 3> position;
    std::array<int, 3> normal;
    std::array<int, 2> texcoord;
    PlyColor color;
    bool hasNormals, hasTexcoords;
    std::vector<bool> isUsed; ///< by property
};

/// Reads vertices one by one, from text or if lists make their sizes differ; a long text on all
/// cores.
void readOneByOne(const VertexLayout &layout, PlyBody &body, Mesh &mesh)
{
    const PlyElement &element = layout.element;
    std::vector<glm::dvec3> positions(element.count);
    Box box;
    std::mutex mutex;
    const auto read = [&](PlyBody &part, std::size_t first, std::size_t count) {
        Box own;
        std::vector<double> values(element.properties.size());
        for (std::size_t v = first; v < first + count; ++v) {
            part.beginElement(element, v);
            for (std::size_t p = 0; p < values.size(); ++p) {
                if (layout.isUsed[p])
                    values[p] = part.value(*element.properties[p].type);
                else
                    part.skip(element.properties[p]);
            }
            part.endElement();
            positions[v] = layout.positionIn(values);
            own.add(positions[v]);
            layout.set(mesh, v, values);
        }
        const std::lock_guard lock(mutex);
        box.add(own);
    };
    if (!body.readLines(element, read)) {
        box = {};
        read(body, 0, element.count);
    }
    setPositions(mesh, originFor(box), positions);
}

/// Reads vertices of equal size directly from the bytes, on all cores.
void readRecords(const VertexLayout &layout, PlyBody &body, Mesh &mesh)
{
    const PlyElement &element = layout.element;
    const std::size_t size = body.header().leastBytes(element);
    body.beginElement(element, 0);
    const std::uint8_t *records = body.take(size * element.count);
    struct Field {
        std::size_t property, offset;
        const PlyType *type;
    };
    std::array<Field, 3> axes{};
    std::vector<Field> others; // used ones
    std::size_t offset = 0;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const Field field{p, offset, element.properties[p].type};
        const auto axis = std::ranges::find(layout.position, static_cast<int>(p));
        if (axis != layout.position.end())
            axes[static_cast<std::size_t>(axis - layout.position.begin())] = field;
        else if (layout.isUsed[p])
            others.push_back(field);
        offset += field.type->bytes;
    }
    const std::endian order = body.header().byteOrder;
    const auto positionAt = [&](std::size_t v) {
        const std::uint8_t *record = records + v * size;
        return glm::dvec3(axes[0].type->read(record + axes[0].offset, order),
                          axes[1].type->read(record + axes[1].offset, order),
                          axes[2].type->read(record + axes[2].offset, order));
    };

    Box box;
    std::mutex mutex;
    inParallelRanges(element.count, kVerticesInTask, body.progress().part(0.0, 0.2),
                     [&](std::size_t begin, std::size_t end) {
                         Box own;
                         for (std::size_t v = begin; v < end; ++v)
                             own.add(positionAt(v));
                         const std::lock_guard lock(mutex);
                         box.add(own);
                     });
    mesh.origin = originFor(box);
    const bool fitFloats = std::ranges::all_of(axes, [](const Field &axis) { return axis.type->fitsFloat; });
    mesh.remainders.resize(fitFloats ? 0 : element.count);
    fillInParallel(mesh.positions, element.count, body.progress().part(0.2, 0.4),
                   [&](std::size_t begin, std::size_t end) {
                       std::vector<double> values(element.properties.size());
                       for (std::size_t v = begin; v < end; ++v) {
                           if (fitFloats)
                               mesh.positions[v] = glm::vec3(positionAt(v) - mesh.origin);
                           else
                               setPosition(mesh, v, positionAt(v));
                           for (const Field &field : others)
                               values[field.property] = field.type->read(records + v * size + field.offset, order);
                           layout.set(mesh, v, values);
                       }
                   });
    const auto isZero = [](const glm::ivec3 &remainder) { return remainder == glm::ivec3(0); };
    if (std::all_of(mesh.remainders.begin(), mesh.remainders.end(), isZero))
        mesh.remainders = {};
}

void readVertices(const PlyElement &element, PlyBody &body, Mesh &mesh)
{
    const VertexLayout layout(element);
    layout.resize(mesh);
    if (body.header().isText || element.hasLists())
        readOneByOne(layout, body, mesh);
    else
        readRecords(layout, body, mesh);
}

/// Reads faces that are all triangles directly from the bytes, on all cores. Throws Damage.
/// @return false for other faces or text; then nothing is read
bool readTriangleRecords(const PlyElement &element, PlyBody &body, PolygonMesh &polygons)
{
    const PlyProperty &list = element.properties[0];
    if (body.header().isText || element.name != "face" || element.properties.size() != 1 || list.countType->bytes != 1
        || list.type->bytes != 4 || !list.type->isInteger || element.count == 0)
        return false;
    constexpr std::size_t kRecordBytes = 1 + 3 * 4;
    if (element.count > body.bytesLeft() / kRecordBytes)
        return false;
    const std::uint8_t *records = body.next();
    std::atomic<bool> areTriangles = true;
    inParallelRanges(element.count, kFacesInTask, body.progress().part(0.4, 0.5),
                     [&](std::size_t begin, std::size_t end) {
                         for (std::size_t f = begin; f < end && areTriangles; ++f) {
                             if (records[f * kRecordBytes] != 3)
                                 areTriangles = false;
                         }
                     });
    if (!areTriangles)
        return false;
    body.take(element.count * kRecordBytes);
    std::vector<std::uint32_t> &indices = polygons.mesh.indices;
    const std::size_t before = indices.size();
    fillInParallel(indices, before + 3 * element.count, body.progress().part(0.5, 1.0),
                   [&](std::size_t begin, std::size_t end) {
                       for (std::size_t i = begin; i < end; ++i) {
                           const std::size_t corner = i - before;
                           indices[i] = numberAt<std::uint32_t>(
                               records + corner / 3 * kRecordBytes + 1 + corner % 3 * 4, body.header().byteOrder);
                           const std::int64_t vertex = static_cast<std::int32_t>(indices[i]);
                           if (indices[i] >= polygons.vertexCount())
                               polygons.checkPolygon({&vertex, 1}, corner / 3);
                       }
                   });
    return true;
}

/// Some faces as the file has them.
struct Faces {
    std::size_t first = 0;
    std::vector<std::size_t> sizes, texcoordCounts; ///< of each face
    std::vector<std::int64_t> corners;
    std::vector<glm::vec2> texcoords;
    std::vector<glm::u8vec4> colors;
};

/// Reads faces in groups: of a long text on all cores, only triangulation is sequential.
class FaceReader {
public:
    FaceReader(const PlyElement &element, PolygonMesh &polygons)
        : m_element(element), m_polygons(polygons), m_isStrips(element.name == "tristrips"),
          m_vertices(element.find({"vertex_indices", "vertex_index"}, true)),
          m_texcoords(element.find({"texcoord"}, true)), m_colors(element),
          m_usesColors(m_colors.isComplete() && polygons.mesh.colors.empty() && !m_isStrips)
    {
        if (m_vertices < 0)
            failMalformed(tr("the element \"%1\" has no list \"vertex_indices\"", element.name));
    }

    void readAll(PlyBody &body)
    {
        std::vector<Faces> groups;
        std::mutex mutex;
        const bool isRead = body.readLines(m_element, [&](PlyBody &lines, std::size_t first, std::size_t count) {
            Faces faces = read(lines, first, count);
            const std::lock_guard lock(mutex);
            groups.push_back(std::move(faces));
        });
        if (isRead) {
            std::ranges::sort(groups, {}, &Faces::first);
            for (Faces &faces : groups)
                add(std::exchange(faces, {}));
            return;
        }
        groups = {};
        for (std::size_t first = 0; first < m_element.count; first += kElementsBetweenReports)
            add(read(body, first, std::min(kElementsBetweenReports, m_element.count - first)));
    }

private:
    Faces read(PlyBody &body, std::size_t first, std::size_t count) const
    {
        Faces faces;
        faces.first = first;
        std::vector<double> values(m_element.properties.size());
        for (std::size_t f = first; f < first + count; ++f) {
            body.beginElement(m_element, f);
            const std::size_t corners = faces.corners.size(), texcoords = faces.texcoords.size();
            for (std::size_t p = 0; p < values.size(); ++p) {
                const PlyProperty &property = m_element.properties[p];
                if (m_usesColors && std::ranges::count(m_colors.channels, static_cast<int>(p)) > 0) {
                    values[p] = body.value(*property.type);
                } else if (static_cast<int>(p) == m_vertices) {
                    for (std::size_t left = body.listLength(property); left > 0; --left)
                        faces.corners.push_back(body.corner(*property.type));
                } else if (static_cast<int>(p) == m_texcoords) {
                    const std::size_t length = body.listLength(property);
                    for (std::size_t i = 0; i + 1 < length; i += 2) {
                        const auto u = static_cast<float>(body.value(*property.type));
                        faces.texcoords.emplace_back(u, static_cast<float>(body.value(*property.type)));
                    }
                    if (length % 2 != 0)
                        body.value(*property.type);
                } else {
                    body.skip(property);
                }
            }
            body.endElement();
            if (!m_isStrips)
                m_polygons.checkPolygon(std::span(faces.corners).subspan(corners), f);
            faces.sizes.push_back(faces.corners.size() - corners);
            if (m_texcoords >= 0)
                faces.texcoordCounts.push_back(faces.texcoords.size() - texcoords);
            if (m_usesColors)
                faces.colors.push_back(m_colors.color(m_element, values));
        }
        return faces;
    }

    void add(const Faces &faces)
    {
        std::span<const std::int64_t> corners = faces.corners;
        std::span<const glm::vec2> texcoords = faces.texcoords;
        for (std::size_t i = 0; i < faces.sizes.size(); ++i) {
            const auto own = corners.first(faces.sizes[i]);
            corners = corners.subspan(own.size());
            if (m_isStrips) {
                m_polygons.addStrip(own, faces.first + i);
                continue;
            }
            m_polygons.addPolygon(own);
            if (m_texcoords >= 0) {
                m_polygons.setCornerTexcoords(texcoords.first(faces.texcoordCounts[i]));
                texcoords = texcoords.subspan(faces.texcoordCounts[i]);
            }
            if (m_usesColors)
                m_polygons.setFaceColor(faces.colors[i]);
        }
    }

    const PlyElement &m_element;
    PolygonMesh &m_polygons;
    bool m_isStrips;
    int m_vertices, m_texcoords; ///< properties, or -1
    PlyColor m_colors;
    bool m_usesColors;
};

void readFaces(const PlyElement &element, PlyBody &body, PolygonMesh &polygons)
{
    FaceReader reader(element, polygons);
    if (readTriangleRecords(element, body, polygons))
        return;
    polygons.mesh.indices.reserve(3 * element.count);
    reader.readAll(body);
}

} // namespace

Model readPly(const Source &source)
{
    const PlyHeader header = readPlyHeader(source.text());
    const PlyElement *vertices = header.find("vertex");
    if (!vertices)
        failMalformed(tr("the header declares no vertices"));
    PlyBody body(source, header);
    PolygonMesh polygons(vertices->count);
    // Triangulating polygons needs the positions of their corners.
    const bool isAhead = vertices != &header.elements.front();
    if (isAhead) {
        PlyBody ahead = body;
        for (const PlyElement *element = header.elements.data(); element != vertices; ++element)
            ahead.skipAll(*element);
        readVertices(*vertices, ahead, polygons.mesh);
    }
    Model model;
    for (const PlyElement &element : header.elements) {
        if (&element == vertices && isAhead) {
            body.skipAll(element);
        } else if (&element == vertices) {
            readVertices(element, body, polygons.mesh);
        } else if (element.name == "face" || element.name == "tristrips") {
            readFaces(element, body, polygons);
        } else {
            body.skipAll(element);
            if (element.name == "edge")
                noteLines(model.notes, element.count);
            else
                addNote(model.notes, element.count, marked("%1 element \"%2\" of the file is not read"),
                        marked("%1 elements \"%2\" of the file are not read"), {element.name});
        }
    }
    noteBytesBehind(model.notes, body.end());
    noteLines(model.notes, polygons.lineCount());

    model.fileVertices = polygons.vertexCount();
    Mesh mesh = polygons.take();
    if (!mesh.colors.empty())
        mesh.baseColor = glm::vec4(1.0f);
    if (!header.textureFile.empty() && !mesh.texcoords.empty()) {
        mesh.texture = addTexture(model, source.file, header.textureFile);
        mesh.baseColor = glm::vec4(1.0f);
    }
    model.meshes.push_back(std::move(mesh));
    return model;
}

} // namespace unprojector::mesh::reader
