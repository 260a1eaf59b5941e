#include "core/mesh/import/ply_vertices.h"

#include "core/base/parallel.h"
#include "core/base/translation.h"
#include "core/mesh/import/material.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <mutex>
#include <string_view>

namespace unprojector::mesh::reader {
using namespace base;
using namespace geometry;

namespace {

/// A few milliseconds of work.
constexpr std::size_t kVerticesInTask = 1 << 16;

int findAny(const PlyElement &element, std::initializer_list<std::string_view> names)
{
    for (const std::string_view name : names) {
        if (const int found = element.find(name);
            found >= 0 && !element.properties[static_cast<std::size_t>(found)].isList)
            return found;
    }
    return -1;
}

/// Returns whether a type is the single-precision float.
bool isFloat(PlyType type)
{
    return type != PlyType::Float64 && type != PlyType::Int32 && type != PlyType::Uint32;
}

std::uint8_t channelFromValue(double value, PlyType type)
{
    double share = value;
    if (type == PlyType::Uint8 || type == PlyType::Int8)
        share = value / 255.0;
    else if (!isFloating(type))
        share = value / 65535.0;
    return byteFromShare(share);
}

template <class Numbers>
bool isAmong(const Numbers &properties, std::size_t property)
{
    return std::find(properties.begin(), properties.end(), static_cast<int>(property)) != properties.end();
}

/// The meaning of a vertex's properties.
struct VertexLayout {
    explicit VertexLayout(const PlyElement &vertices)
        : element(vertices), position{findAny(element, {"x"}), findAny(element, {"y"}), findAny(element, {"z"})},
          normal{findAny(element, {"nx"}), findAny(element, {"ny"}), findAny(element, {"nz"})},
          texcoord{findAny(element, {"s", "u", "texture_u", "tex_u"}),
                   findAny(element, {"t", "v", "texture_v", "tex_v"})},
          color(element)
    {
        if (position[0] < 0 || position[1] < 0 || position[2] < 0)
            failMalformed(tr("the vertices have no x, y and z"));
        hasNormals = normal[0] >= 0 && normal[1] >= 0 && normal[2] >= 0;
        hasTexcoords = texcoord[0] >= 0 && texcoord[1] >= 0;
    }

    bool isPosition(std::size_t property) const { return isAmong(position, property); }
    /// Returns whether set() uses a property.
    bool isUsed(std::size_t property) const
    {
        return (hasNormals && isAmong(normal, property)) || (hasTexcoords && isAmong(texcoord, property))
               || (color.isComplete() && isAmong(color.channels, property));
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
    bool hasNormals = false;
    bool hasTexcoords = false;
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
                if (layout.isPosition(p) || layout.isUsed(p))
                    values[p] = part.value(element.properties[p].type);
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
void readRecords(const VertexLayout &layout, PlyBody &body, PlyFormat format, Mesh &mesh, base::Reporter &progress)
{
    const PlyElement &element = layout.element;
    const std::size_t size = element.leastBytes(format);
    body.beginElement(element, 0);
    const std::uint8_t *records = body.take(size * element.count);
    struct Field {
        std::size_t property, offset;
        PlyType type;
    };
    std::vector<Field> fields; // the used ones
    std::vector<Field> axes(3);
    std::size_t offset = 0;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const Field field{p, offset, element.properties[p].type};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (layout.position[axis] == static_cast<int>(p))
                axes[axis] = field;
        }
        if (layout.isUsed(p))
            fields.push_back(field);
        offset += byteCount(field.type);
    }
    const auto positionAt = [&](std::size_t v) {
        const std::uint8_t *record = records + v * size;
        return glm::dvec3(plyValue(record + axes[0].offset, axes[0].type, format),
                          plyValue(record + axes[1].offset, axes[1].type, format),
                          plyValue(record + axes[2].offset, axes[2].type, format));
    };

    Box box;
    std::mutex mutex;
    inParallelRanges(element.count, kVerticesInTask, progress.part(0.0, 0.2), [&](std::size_t begin, std::size_t end) {
        Box own;
        for (std::size_t v = begin; v < end; ++v)
            own.add(positionAt(v));
        const std::lock_guard lock(mutex);
        box.add(own);
    });
    mesh.origin = originFor(box);
    const bool areFloats = std::all_of(axes.begin(), axes.end(), [](const Field &axis) { return isFloat(axis.type); });
    mesh.remainders.resize(areFloats ? 0 : element.count);
    fillInParallel(mesh.positions, element.count, progress.part(0.2, 0.4), [&](std::size_t begin, std::size_t end) {
        std::vector<double> values(element.properties.size());
        for (std::size_t v = begin; v < end; ++v) {
            if (areFloats)
                mesh.positions[v] = glm::vec3(positionAt(v) - mesh.origin);
            else
                setPosition(mesh, v, positionAt(v));
            for (const Field &field : fields)
                values[field.property] = plyValue(records + v * size + field.offset, field.type, format);
            layout.set(mesh, v, values);
        }
    });
    const auto isZero = [](const glm::ivec3 &remainder) { return remainder == glm::ivec3(0); };
    if (std::all_of(mesh.remainders.begin(), mesh.remainders.end(), isZero))
        mesh.remainders = {};
}

} // namespace

PlyColor::PlyColor(const PlyElement &element)
    : channels{findAny(element, {"red", "r", "diffuse_red"}), findAny(element, {"green", "g", "diffuse_green"}),
               findAny(element, {"blue", "b", "diffuse_blue"}), findAny(element, {"alpha", "a", "diffuse_alpha"})}
{
}

glm::u8vec4 PlyColor::color(const PlyElement &element, const std::vector<double> &values) const
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

void readPlyVertices(const PlyElement &element, PlyBody &body, PlyFormat format, Mesh &mesh, base::Reporter &progress)
{
    const VertexLayout layout(element);
    layout.resize(mesh);
    if (format == PlyFormat::Ascii || element.hasLists())
        readOneByOne(layout, body, mesh);
    else
        readRecords(layout, body, format, mesh, progress);
}

} // namespace unprojector::mesh::reader
