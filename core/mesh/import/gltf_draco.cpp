#include "core/mesh/import/gltf_draco.h"

#include "core/base/translation.h"
#include "core/mesh/import/gltf_corners.h"
#include "core/mesh/import/gltf_extensions.h"

#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>

#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace unprojector::mesh::reader {
using base::tr;

namespace {

constexpr const char *kTypes[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
constexpr std::size_t kMostComponents = 4;

struct Counts {
    std::uint64_t vertices = 0, triangles = 0;
};

void require(bool isInOrder)
{
    if (!isInOrder)
        failMalformed(tr("the Draco data of a mesh are damaged; export the file again"));
}

draco::DecoderBuffer bufferOf(std::span<const std::uint8_t> bytes)
{
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char *>(bytes.data()), bytes.size());
    return buffer;
}

/// Reads the declared counts before Draco allocates memory. The vertex count is a lower bound if
/// unpacking may split vertices.
Counts declaredCounts(std::span<const std::uint8_t> bytes)
{
    draco::DecoderBuffer buffer = bufferOf(bytes);
    draco::DracoHeader header{};
    require(draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok());
    if (header.version_major != 2 || header.version_minor != 2)
        failMalformed(
            tr("the Draco data of a mesh are of version %1.%2, and glTF has version 2.2; export the file again",
               int{header.version_major}, int{header.version_minor}));
    if (header.encoder_type != draco::TRIANGULAR_MESH)
        failMalformed(tr("the Draco data of a mesh hold points, and not triangles"));
    buffer.set_bitstream_version(DRACO_BITSTREAM_VERSION(2, 2));
    if ((header.flags & METADATA_FLAG_MASK) != 0) {
        draco::GeometryMetadata metadata;
        require(draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata));
    }
    std::uint32_t first = 0, second = 0;
    const bool isSequential = header.encoder_method == draco::MESH_SEQUENTIAL_ENCODING;
    std::uint8_t traversal = 0;
    require(isSequential || buffer.Decode(&traversal));
    require(draco::DecodeVarint(&first, &buffer) && draco::DecodeVarint(&second, &buffer));
    return isSequential ? Counts{second, first} : Counts{first, second};
}

/// The numbers of an attribute, vertex by vertex.
template <class Number>
std::vector<std::uint8_t> valuesOf(const draco::PointAttribute &attribute, std::size_t vertices, std::uint64_t id)
{
    const auto components = static_cast<std::size_t>(attribute.num_components());
    const std::size_t size = components * sizeof(Number);
    std::vector<std::uint8_t> bytes(vertices * size);
    for (std::size_t v = 0; v < vertices; ++v) {
        const auto index = attribute.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(v)));
        Number numbers[kMostComponents] = {};
        if (index.value() >= attribute.size()
            || !attribute.ConvertValue(index, static_cast<std::int8_t>(components), numbers))
            failMalformed(tr("the attribute %1 of Draco data does not fit the numbers that the file declares", id));
        std::memcpy(bytes.data() + v * size, numbers, size);
    }
    return bytes;
}

std::vector<std::uint8_t> valuesOf(const draco::PointAttribute &attribute, std::size_t vertices, std::uint64_t id,
                                   std::uint64_t componentType)
{
    switch (componentType) {
    case 5120: return valuesOf<std::int8_t>(attribute, vertices, id);
    case 5121: return valuesOf<std::uint8_t>(attribute, vertices, id);
    case 5122: return valuesOf<std::int16_t>(attribute, vertices, id);
    case 5123: return valuesOf<std::uint16_t>(attribute, vertices, id);
    case 5125: return valuesOf<std::uint32_t>(attribute, vertices, id);
    case 5126: return valuesOf<float>(attribute, vertices, id);
    default: failMalformed(tr("an accessor has an unknown component type"));
    }
}

void requireCount(std::uint64_t count, std::uint64_t expected, const char *sentence)
{
    if (count != expected)
        failMalformed(tr(sentence, count, expected));
}

/// Decodes a mesh. Positions keep the rounding of the compression.
/// @param expected  by the file: damaged data could ask for any amount of memory
std::unique_ptr<draco::Mesh> decoded(std::span<const std::uint8_t> bytes, const Counts &expected)
{
    constexpr const char *kTriangles =
        base::marked("the Draco data of a mesh have %1 triangles, and the file declares %2");
    constexpr const char *kVertices =
        base::marked("the Draco data of a mesh have %1 vertices, and the file declares %2");
    const Counts declared = declaredCounts(bytes);
    requireCount(declared.triangles, expected.triangles, kTriangles);
    if (declared.vertices > expected.vertices)
        failMalformed(tr(kVertices, declared.vertices, expected.vertices));
    draco::DecoderBuffer buffer = bufferOf(bytes);
    draco::Decoder decoder;
    draco::StatusOr<std::unique_ptr<draco::Mesh>> result = decoder.DecodeMeshFromBuffer(&buffer);
    require(result.ok());
    std::unique_ptr<draco::Mesh> mesh = std::move(result).value();
    requireCount(mesh->num_faces(), expected.triangles, kTriangles);
    requireCount(mesh->num_points(), expected.vertices, kVertices);
    return mesh;
}

std::uint64_t countOf(const GltfFile &file, const Json &object, const char *key)
{
    return GltfFile::number(file.reference(object, key, "accessors"), "count", 0);
}

void unpack(GltfFile &file, const Json &packing, Json &primitive)
{
    const std::uint64_t mode = GltfFile::number(primitive, "mode", GltfCorners::Triangles);
    if (mode != GltfCorners::Triangles && mode != GltfCorners::TriangleStrip)
        failMalformed(tr("a mesh that Draco packs has the mode %1, which is not one of triangles", mode));
    const Json *attributes = GltfFile::find(primitive, "attributes");
    const Json *ids = GltfFile::find(packing, "attributes");
    if (!attributes || !ids || !ids->is_object() || !GltfFile::find(*ids, "POSITION")
        || !GltfFile::find(*attributes, "POSITION") || !GltfFile::find(primitive, "indices"))
        failMalformed(tr("a mesh that Draco packs lacks its positions or its indices"));
    // A strip has two more corners than triangles, a list three times as many.
    const std::size_t corners = static_cast<std::size_t>(countOf(file, primitive, "indices"));
    const Counts expected{countOf(file, *attributes, "POSITION"), GltfCorners(mode, corners).triangleCount()};

    const std::unique_ptr<draco::Mesh> mesh = decoded(file.viewBytes(packing), expected);

    std::vector<std::uint8_t> indices(static_cast<std::size_t>(expected.triangles) * 12);
    for (std::uint32_t face = 0; face < mesh->num_faces(); ++face) {
        const draco::Mesh::Face &triangle = mesh->face(draco::FaceIndex(face));
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = triangle[corner].value();
            std::memcpy(indices.data() + std::size_t{face} * 12 + 4 * corner, &vertex, sizeof vertex);
        }
    }
    // The accessors stay unchanged for other primitives, which may have other data.
    for (const auto &[name, id] : ids->items()) {
        if (!GltfFile::find(*attributes, name.c_str()))
            continue;
        Json accessor = file.reference(*attributes, name.c_str(), "accessors");
        const std::uint64_t number = GltfFile::number(*ids, name.c_str(), 0);
        const draco::PointAttribute *attribute = mesh->GetAttributeByUniqueId(static_cast<std::uint32_t>(number));
        if (!attribute)
            failMalformed(tr("the Draco data of a mesh have no attribute %1, which the file refers to", number));
        const auto components = static_cast<std::size_t>(attribute->num_components());
        if (components > kMostComponents)
            failMalformed(tr("the attribute %1 of Draco data has %2 numbers each, of which glTF has 4 at most", number,
                             components));
        std::vector<std::uint8_t> values =
            valuesOf(*attribute, mesh->num_points(), number, GltfFile::number(accessor, "componentType", 0));
        accessor.erase("byteOffset");
        accessor["type"] = kTypes[components];
        accessor["count"] = expected.vertices;
        primitive["attributes"][name] = file.addAccessor(std::move(accessor), std::move(values));
    }
    primitive["indices"] = file.addAccessor(
        {{"componentType", 5125u}, {"type", "SCALAR"}, {"count", 3 * expected.triangles}}, std::move(indices));
    primitive["mode"] = std::uint64_t{GltfCorners::Triangles};
}

} // namespace

bool hasDraco()
{
    return true;
}

void unpackDraco(GltfFile &file, Json &primitive)
{
    file.source().progress.report(0.0);
    unpack(file, *extensionOf(primitive, kDracoExtension), primitive);
}

} // namespace unprojector::mesh::reader
