#include "core/mesh/import/draco_mesh.h"

#include "core/base/translation.h"
#include "core/mesh/import/mesh_reader.h"

#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>

#include <cstring>
#include <memory>
#include <string>

namespace unprojector::mesh::reader {
using base::tr;

namespace {

constexpr std::size_t kMostComponents = 4;

[[noreturn]] void failDamaged()
{
    failMalformed(tr("the Draco data of a mesh are damaged; export the file again"));
}

void require(bool isInOrder)
{
    if (!isInOrder)
        failDamaged();
}

draco::DecoderBuffer bufferOf(std::span<const std::uint8_t> bytes)
{
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char *>(bytes.data()), bytes.size());
    return buffer;
}

/// Reads the declared counts before Draco allocates memory. The vertex count is a lower bound if
/// unpacking may split vertices.
DracoCounts declaredCounts(std::span<const std::uint8_t> bytes)
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
    return isSequential ? DracoCounts{second, first} : DracoCounts{first, second};
}

template <class Number>
bool copyValues(const draco::PointAttribute &attribute, std::size_t vertices, DracoValues &values)
{
    const std::size_t size = values.components * sizeof(Number);
    values.bytes.resize(vertices * size);
    for (std::size_t v = 0; v < vertices; ++v) {
        const auto index = attribute.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(v)));
        Number numbers[kMostComponents] = {};
        if (index.value() >= attribute.size()
            || !attribute.ConvertValue(index, static_cast<std::int8_t>(values.components), numbers))
            return false;
        std::memcpy(values.bytes.data() + v * size, numbers, size);
    }
    return true;
}

DracoValues valuesOf(const draco::Mesh &mesh, const DracoRequest &request)
{
    const draco::PointAttribute *attribute = mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(request.id));
    if (!attribute)
        failMalformed(tr("the Draco data of a mesh have no attribute %1, which the file refers to", request.id));
    DracoValues values{static_cast<std::size_t>(attribute->num_components()), {}};
    if (values.components > kMostComponents)
        failMalformed(tr("the attribute %1 of Draco data has %2 numbers each, of which glTF has 4 at most", request.id,
                         values.components));
    const auto copied = [&] {
        switch (request.componentType) {
        case 5120: return copyValues<std::int8_t>(*attribute, mesh.num_points(), values);
        case 5121: return copyValues<std::uint8_t>(*attribute, mesh.num_points(), values);
        case 5122: return copyValues<std::int16_t>(*attribute, mesh.num_points(), values);
        case 5123: return copyValues<std::uint16_t>(*attribute, mesh.num_points(), values);
        case 5125: return copyValues<std::uint32_t>(*attribute, mesh.num_points(), values);
        case 5126: return copyValues<float>(*attribute, mesh.num_points(), values);
        default: failMalformed(tr("an accessor has an unknown component type"));
        }
    };
    if (!copied())
        failMalformed(tr("the attribute %1 of Draco data does not fit the numbers that the file declares", request.id));
    return values;
}

void requireCount(std::uint64_t count, std::uint64_t expected, const char *sentence)
{
    if (count != expected)
        failMalformed(tr(sentence, count, expected));
}

} // namespace

bool hasDraco()
{
    return true;
}

DracoMesh unpackedDraco(std::span<const std::uint8_t> bytes, std::span<const DracoRequest> requests,
                        const DracoCounts &expected)
{
    constexpr const char *kTriangles =
        base::marked("the Draco data of a mesh have %1 triangles, and the file declares %2");
    constexpr const char *kVertices =
        base::marked("the Draco data of a mesh have %1 vertices, and the file declares %2");
    const DracoCounts declared = declaredCounts(bytes);
    requireCount(declared.triangles, expected.triangles, kTriangles);
    if (declared.vertices > expected.vertices)
        failMalformed(tr(kVertices, declared.vertices, expected.vertices));
    draco::DecoderBuffer buffer = bufferOf(bytes);
    draco::Decoder decoder;
    draco::StatusOr<std::unique_ptr<draco::Mesh>> decoded = decoder.DecodeMeshFromBuffer(&buffer);
    require(decoded.ok());
    const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
    requireCount(mesh->num_faces(), expected.triangles, kTriangles);
    requireCount(mesh->num_points(), expected.vertices, kVertices);

    DracoMesh unpacked{expected, {}, {}};
    unpacked.indices.resize(std::size_t{mesh->num_faces()} * 12);
    for (std::uint32_t face = 0; face < mesh->num_faces(); ++face) {
        const draco::Mesh::Face &corners = mesh->face(draco::FaceIndex(face));
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = corners[corner].value();
            std::memcpy(unpacked.indices.data() + std::size_t{face} * 12 + 4 * corner, &vertex, sizeof vertex);
        }
    }
    for (const DracoRequest &request : requests)
        unpacked.attributes.push_back(valuesOf(*mesh, request));
    return unpacked;
}

} // namespace unprojector::mesh::reader
