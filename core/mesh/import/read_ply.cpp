#include "core/base/byte_order.h"
#include "core/base/parallel.h"
#include "core/base/translation.h"
#include "core/mesh/import/mesh_reader.h"
#include "core/mesh/import/ply_body.h"
#include "core/mesh/import/ply_header.h"
#include "core/mesh/import/ply_vertices.h"
#include "core/mesh/import/polygon_mesh.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <span>
#include <string>

namespace unprojector::mesh::reader {
using namespace base;

namespace {

/// A few milliseconds of work.
constexpr std::size_t kFacesInTask = 1 << 17;

bool isVertexList(const PlyProperty &property)
{
    return property.isList && (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Reads faces that are all triangles directly from the bytes, on all cores. Throws Damage.
/// @return false for other faces or text; then nothing is read
bool readTriangleRecords(const PlyElement &element, PlyFormat format, PlyBody &body, PolygonMesh &polygons,
                         base::Reporter &progress)
{
    if (format == PlyFormat::Ascii || element.name != "face" || element.properties.size() != 1
        || !isVertexList(element.properties[0]) || byteCount(element.properties[0].countType) != 1
        || byteCount(element.properties[0].type) != 4 || isFloating(element.properties[0].type) || element.count == 0)
        return false;
    constexpr std::size_t kRecordBytes = 1 + 3 * 4;
    if (element.count > body.bytesLeft() / kRecordBytes)
        return false;
    const std::uint8_t *records = body.next();
    std::atomic<bool> areTriangles = true;
    inParallelRanges(element.count, kFacesInTask, progress.part(0.4, 0.5), [&](std::size_t begin, std::size_t end) {
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
    fillInParallel(
        indices, before + 3 * element.count, progress.part(0.5, 1.0), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const std::size_t corner = i - before;
                indices[i] =
                    numberAt<std::uint32_t>(records + corner / 3 * kRecordBytes + 1 + corner % 3 * 4, orderOf(format));
                if (indices[i] >= polygons.vertexCount())
                    polygons.failAtVertex(static_cast<std::int32_t>(indices[i]), corner / 3);
            }
        });
    return true;
}

/// Reads the faces of a long text that have only corners, on all cores; only triangulation is
/// sequential.
/// @return false for other faces; then nothing is read
bool readFaceLines(const PlyElement &element, PlyBody &body, PolygonMesh &polygons)
{
    if (element.name != "face" || element.properties.size() != 1 || !isVertexList(element.properties[0]))
        return false;
    struct Part {
        std::size_t first = 0;
        std::vector<std::uint32_t> sizes;
        std::vector<std::int64_t> corners;
    };
    std::vector<Part> parts;
    std::mutex mutex;
    const PlyProperty &list = element.properties[0];
    const bool isRead = body.readLines(element, [&](PlyBody &lines, std::size_t first, std::size_t count) {
        Part part;
        part.first = first;
        for (std::size_t f = first; f < first + count; ++f) {
            lines.beginElement(element, f);
            const std::size_t size = lines.listLength(list);
            part.sizes.push_back(static_cast<std::uint32_t>(size));
            for (std::size_t i = 0; i < size; ++i)
                part.corners.push_back(lines.corner(list.type));
            lines.endElement();
        }
        const std::lock_guard lock(mutex);
        parts.push_back(std::move(part));
    });
    if (!isRead)
        return false;
    std::sort(parts.begin(), parts.end(), [](const Part &a, const Part &b) { return a.first < b.first; });
    polygons.mesh.indices.reserve(3 * element.count);
    for (Part &part : parts) {
        std::size_t begin = 0;
        for (std::size_t i = 0; i < part.sizes.size(); ++i) {
            polygons.addPolygon(std::span(part.corners).subspan(begin, part.sizes[i]), part.first + i);
            begin += part.sizes[i];
        }
        part = {};
    }
    return true;
}

void readFaces(const PlyElement &element, PlyBody &body, PolygonMesh &polygons)
{
    const int vertices =
        element.find("vertex_indices") >= 0 ? element.find("vertex_indices") : element.find("vertex_index");
    const int texcoords = element.find("texcoord");
    const PlyColor colors(element);
    const bool usesColors = colors.isComplete() && polygons.mesh.colors.empty();
    if (vertices < 0 || !element.properties[static_cast<std::size_t>(vertices)].isList)
        failMalformed(tr("the element \"%1\" has no list \"vertex_indices\"", element.name));

    polygons.mesh.indices.reserve(3 * element.count);
    std::vector<double> values(element.properties.size());
    std::vector<std::int64_t> corners;
    std::vector<glm::vec2> cornerTexcoords;
    for (std::size_t f = 0; f < element.count; ++f) {
        body.beginElement(element, f);
        cornerTexcoords.clear();
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty &property = element.properties[p];
            const auto &channels = colors.channels;
            const bool isColor = std::find(channels.begin(), channels.end(), static_cast<int>(p)) != channels.end();
            if (usesColors && isColor) {
                values[p] = body.value(property.type);
            } else if (static_cast<int>(p) == vertices) {
                corners.resize(body.listLength(property));
                for (std::int64_t &corner : corners)
                    corner = body.corner(property.type);
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
        body.endElement();
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

bool isFaces(const PlyElement &element)
{
    return element.name == "face" || element.name == "tristrips";
}

/// Reads the vertices of a file that has other elements before them.
void readVerticesAhead(const PlyHeader &header, PlyBody body, PolygonMesh &polygons, base::Reporter &progress)
{
    for (const PlyElement &element : header.elements) {
        if (element.name == "vertex") {
            readPlyVertices(element, body, header.format, polygons.mesh, progress);
            return;
        }
        body.skipAll(element);
    }
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
    if (isAhead)
        readVerticesAhead(header, body, polygons, source.progress);
    Model model;
    for (const PlyElement &element : header.elements) {
        if (&element == vertices && !isAhead) {
            readPlyVertices(element, body, header.format, polygons.mesh, source.progress);
        } else if (isFaces(element)) {
            if (!readTriangleRecords(element, header.format, body, polygons, source.progress)
                && !readFaceLines(element, body, polygons))
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
