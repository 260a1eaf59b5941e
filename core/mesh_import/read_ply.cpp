#include "core/mesh_import/mesh_reader.h"
#include "core/mesh_import/ply_header.h"
#include "core/mesh_import/polygon_mesh.h"
#include "core/mesh_import/text_scanner.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <optional>

namespace unprojector::mesh_import::mesh_reader {

namespace {

constexpr std::size_t kElementsBetweenReports = 1 << 14;

/// Reads the values after the header one by one.
class PlyBody {
public:
    PlyBody(const Source &source, const PlyHeader &header)
        : m_source(source), m_format(header.format), m_bytes(source.bytes), m_at(header.bodyOffset),
          m_scanner(source.text(), header.bodyOffset, header.bodyLine)
    {
    }

    void beginElement(const PlyElement &element, std::size_t number)
    {
        m_element = &element;
        m_number = number;
        if (number % kElementsBetweenReports == 0)
            m_source.progress.report(static_cast<double>(offset()) / static_cast<double>(m_bytes.size()));
    }

    double value(PlyType type)
    {
        if (m_format == PlyFormat::Ascii)
            return asciiValue(type);
        const std::uint64_t bits = binaryBits(byteCount(type));
        switch (type) {
        case PlyType::Int8: return static_cast<std::int8_t>(bits);
        case PlyType::Int16: return static_cast<std::int16_t>(bits);
        case PlyType::Int32: return static_cast<std::int32_t>(bits);
        case PlyType::Uint8:
        case PlyType::Uint16:
        case PlyType::Uint32: return static_cast<double>(bits);
        case PlyType::Float32: return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
        case PlyType::Float64: return std::bit_cast<double>(bits);
        }
        return 0.0;
    }

    /// A list's length, checked against what is left of the file.
    std::size_t listLength(const PlyProperty &list)
    {
        const double length = value(list.countType);
        const std::size_t bytesEach = m_format == PlyFormat::Ascii ? 2 : byteCount(list.type);
        if (!(length >= 0.0))
            failMalformed(where() + " has a list of negative length");
        const std::size_t most = (m_bytes.size() + 1 - offset()) / bytesEach;
        if (length > static_cast<double>(most))
            failTruncated();
        return static_cast<std::size_t>(length);
    }

    void skip(const PlyProperty &property)
    {
        const std::size_t count = property.isList ? listLength(property) : 1;
        for (std::size_t i = 0; i < count; ++i)
            value(property.type);
    }

private:
    std::size_t offset() const { return m_format == PlyFormat::Ascii ? m_scanner.offset() : m_at; }
    std::string where() const { return m_element->name + ' ' + std::to_string(m_number); }

    [[noreturn]] void failTruncated() const
    {
        failMalformed("the file ends within " + where() + " of " + std::to_string(m_element->count));
    }

    std::uint64_t binaryBits(std::size_t count)
    {
        if (m_bytes.size() - m_at < count)
            failTruncated();
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t shift = m_format == PlyFormat::LittleEndian ? i : count - 1 - i;
            bits |= std::uint64_t{m_bytes[m_at + i]} << (8 * shift);
        }
        m_at += count;
        return bits;
    }

    double asciiValue(PlyType type)
    {
        const std::string_view word = m_scanner.nextWord();
        if (word.empty())
            failTruncated();
        if (!isFloating(type)) {
            if (const std::optional<long long> integer = integerFromWord(word))
                return static_cast<double>(*integer);
        }
        const std::optional<float> number = floatFromWord(word);
        if (!number)
            failMalformed("line " + std::to_string(m_scanner.line()) + ": " + quoted(word) + " is no number");
        return *number;
    }

    const Source &m_source;
    PlyFormat m_format;
    std::span<const std::uint8_t> m_bytes;
    std::size_t m_at;
    TextScanner m_scanner;
    const PlyElement *m_element = nullptr;
    std::size_t m_number = 0;
};

int findAny(const PlyElement &element, std::initializer_list<std::string_view> names)
{
    for (const std::string_view name : names) {
        if (const int found = element.find(name);
            found >= 0 && !element.properties[static_cast<std::size_t>(found)].isList)
            return found;
    }
    return -1;
}

std::uint8_t channelFromValue(double value, PlyType type)
{
    double share = value;
    if (type == PlyType::Uint8 || type == PlyType::Int8)
        share = value / 255.0;
    else if (!isFloating(type))
        share = value / 65535.0;
    // Written so that NaN becomes 0.
    return share > 0.0 ? static_cast<std::uint8_t>(std::lround(std::min(share, 1.0) * 255.0)) : std::uint8_t{0};
}

/// Where an element keeps its colour.
struct ColorProperties {
    explicit ColorProperties(const PlyElement &element)
        : channels{findAny(element, {"red", "r", "diffuse_red"}), findAny(element, {"green", "g", "diffuse_green"}),
                   findAny(element, {"blue", "b", "diffuse_blue"}), findAny(element, {"alpha", "a", "diffuse_alpha"})}
    {
    }
    bool isComplete() const { return channels[0] >= 0 && channels[1] >= 0 && channels[2] >= 0; }
    glm::u8vec4 color(const PlyElement &element, const std::vector<double> &values) const
    {
        glm::u8vec4 result(255);
        for (int c = 0; c < 4; ++c) {
            if (channels[static_cast<std::size_t>(c)] < 0)
                continue;
            const auto property = static_cast<std::size_t>(channels[static_cast<std::size_t>(c)]);
            result[c] = channelFromValue(values[property], element.properties[property].type);
        }
        return result;
    }

    std::array<int, 4> channels;
};

void readVertices(const PlyElement &element, PlyBody &body, Mesh &mesh)
{
    const std::array<int, 3> position{findAny(element, {"x"}), findAny(element, {"y"}), findAny(element, {"z"})};
    const std::array<int, 3> normal{findAny(element, {"nx"}), findAny(element, {"ny"}), findAny(element, {"nz"})};
    const std::array<int, 2> texcoord{findAny(element, {"s", "u", "texture_u", "tex_u"}),
                                      findAny(element, {"t", "v", "texture_v", "tex_v"})};
    const ColorProperties colors(element);
    if (position[0] < 0 || position[1] < 0 || position[2] < 0)
        failMalformed("the vertices have no x, y and z");
    const bool hasNormals = normal[0] >= 0 && normal[1] >= 0 && normal[2] >= 0;
    const bool hasTexcoords = texcoord[0] >= 0 && texcoord[1] >= 0;

    mesh.positions.reserve(element.count);
    std::vector<double> values(element.properties.size());
    const auto at = [&values](int property) { return static_cast<float>(values[static_cast<std::size_t>(property)]); };
    for (std::size_t v = 0; v < element.count; ++v) {
        body.beginElement(element, v);
        for (std::size_t p = 0; p < values.size(); ++p) {
            if (element.properties[p].isList)
                body.skip(element.properties[p]);
            else
                values[p] = body.value(element.properties[p].type);
        }
        mesh.positions.emplace_back(at(position[0]), at(position[1]), at(position[2]));
        if (hasNormals)
            mesh.normals.emplace_back(at(normal[0]), at(normal[1]), at(normal[2]));
        if (hasTexcoords)
            mesh.texcoords.emplace_back(at(texcoord[0]), at(texcoord[1]));
        if (colors.isComplete())
            mesh.colors.push_back(colors.color(element, values));
    }
}

void readFaces(const PlyElement &element, PlyBody &body, PolygonMesh &polygons)
{
    const int vertices =
        element.find("vertex_indices") >= 0 ? element.find("vertex_indices") : element.find("vertex_index");
    const int texcoords = element.find("texcoord");
    const ColorProperties colors(element);
    const bool usesColors = colors.isComplete() && polygons.mesh.colors.empty();
    if (vertices < 0 || !element.properties[static_cast<std::size_t>(vertices)].isList)
        failMalformed("the element \"" + element.name + "\" has no list \"vertex_indices\"");

    polygons.mesh.indices.reserve(3 * element.count);
    std::vector<double> values(element.properties.size());
    std::vector<std::int64_t> corners;
    std::vector<glm::vec2> cornerTexcoords;
    for (std::size_t f = 0; f < element.count; ++f) {
        body.beginElement(element, f);
        cornerTexcoords.clear();
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty &property = element.properties[p];
            if (!property.isList) {
                values[p] = body.value(property.type);
            } else if (static_cast<int>(p) == vertices) {
                corners.resize(body.listLength(property));
                for (std::int64_t &corner : corners) {
                    const double value = body.value(property.type);
                    corner = value >= -1.0 && value <= 4294967295.0 ? static_cast<std::int64_t>(value) : -2;
                }
            } else if (static_cast<int>(p) == texcoords) {
                const std::size_t length = body.listLength(property);
                for (std::size_t i = 0; i + 1 < length; i += 2) {
                    const auto u = static_cast<float>(body.value(property.type));
                    cornerTexcoords.emplace_back(u, static_cast<float>(body.value(property.type)));
                }
                if (length % 2 != 0)
                    body.value(property.type);
            } else {
                body.skip(property);
            }
        }
        if (element.name == "tristrips") {
            polygons.addStrip(corners, f);
            continue;
        }
        polygons.addPolygon(corners, f);
        if (texcoords >= 0)
            polygons.setCornerTexcoords(cornerTexcoords);
        if (usesColors)
            polygons.setFaceColor(colors.color(element, values));
    }
}

} // namespace

Model readPly(const Source &source)
{
    const PlyHeader header = readPlyHeader(source.text());
    const PlyElement *vertices = header.find("vertex");
    if (!vertices)
        failMalformed("the header declares no vertices");
    PlyBody body(source, header);
    PolygonMesh polygons(vertices->count);
    for (const PlyElement &element : header.elements) {
        if (&element == vertices) {
            readVertices(element, body, polygons.mesh);
        } else if (element.name == "face" || element.name == "tristrips") {
            readFaces(element, body, polygons);
        } else if (!element.properties.empty()) {
            for (std::size_t i = 0; i < element.count; ++i) {
                body.beginElement(element, i);
                for (const PlyProperty &property : element.properties)
                    body.skip(property);
            }
        }
    }

    Model model;
    Mesh mesh = polygons.take();
    if (!mesh.colors.empty())
        mesh.baseColor = glm::vec4(1.0f);
    if (!header.textureFile.empty() && !mesh.texcoords.empty()) {
        model.textures.push_back(readTexture(source.file, header.textureFile));
        mesh.texture = 0;
        mesh.baseColor = glm::vec4(1.0f);
    }
    model.meshes.push_back(std::move(mesh));
    return model;
}

} // namespace unprojector::mesh_import::mesh_reader
