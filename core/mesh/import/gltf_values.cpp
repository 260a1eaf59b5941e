#include "core/mesh/import/gltf_values.h"

#include "core/base/byte_order.h"
#include "core/base/translation.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <utility>

namespace unprojector::mesh::reader {
using base::numberAt;
using base::tr;

namespace {

/// The element limit of an accessor without bytes of its own; a larger file raises it to its byte
/// count. Such accessors only serve as the base of sparse patches, which do have bytes.
constexpr std::uint64_t kElementsOutOfNothing = 1 << 14;

std::size_t bytesOf(int componentType)
{
    switch (componentType) {
    case 5120:
    case 5121: return 1;
    case 5122:
    case 5123: return 2;
    case 5125:
    case 5126: return 4;
    default: failMalformed(tr("an accessor has an unknown component type"));
    }
}

std::size_t componentsOf(const Json &accessor)
{
    static constexpr std::pair<const char *, std::size_t> kTypes[] = {
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
    const Json *type = GltfFile::find(accessor, "type");
    for (const auto &[name, components] : kTypes) {
        if (type && *type == name)
            return components;
    }
    failMalformed(tr("an accessor has an unknown type"));
}

} // namespace

GltfValues::GltfValues(GltfFile &file, const Json &accessor)
    : m_type(static_cast<int>(GltfFile::number(accessor, "componentType", 0))), m_componentBytes(bytesOf(m_type)),
      m_components(componentsOf(accessor)), m_count(static_cast<std::size_t>(GltfFile::number(accessor, "count", 0))),
      m_stride(m_components * m_componentBytes)
{
    if (const Json *normalized = GltfFile::find(accessor, "normalized"))
        m_isNormalized = areIntegers() && *normalized == true;
    const std::size_t elementBytes = m_stride;
    if (GltfFile::find(accessor, "bufferView")) {
        const Json &view = file.reference(accessor, "bufferView", "bufferViews");
        m_bytes = file.viewBytes(accessor);
        // Some programs write 0 for tightly packed elements.
        if (const std::uint64_t stride = GltfFile::number(view, "byteStride", 0); stride > 0)
            m_stride = static_cast<std::size_t>(stride);
        if (m_stride < elementBytes)
            failMalformed(tr("\"byteStride\" is %1, less than the %2 bytes of one element", m_stride, elementBytes));
        const std::uint64_t offset = GltfFile::number(accessor, "byteOffset", 0);
        const std::uint64_t bytes =
            m_count == 0 ? 0 : std::uint64_t{m_stride} * (m_count - 1) + std::uint64_t{elementBytes};
        if (offset + bytes > m_bytes.size())
            failMalformed(tr("an accessor of %1 elements goes beyond its buffer view", m_count));
        m_bytes = m_bytes.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(bytes));
    } else {
        if (m_count > std::max<std::uint64_t>(kElementsOutOfNothing, file.source().bytes.size()))
            failMalformed(tr("an accessor declares %1 elements without any bytes", m_count));
        m_owned.resize(m_count * elementBytes);
        m_bytes = m_owned;
    }
    if (const Json *sparse = GltfFile::find(accessor, "sparse"))
        readSparse(file, accessor, *sparse);
}

void GltfValues::readSparse(GltfFile &file, const Json &accessor, const Json &sparse)
{
    const Json *indices = GltfFile::find(sparse, "indices");
    const Json *values = GltfFile::find(sparse, "values");
    if (!GltfFile::find(sparse, "count") || !indices || !values)
        failMalformed(tr("a sparse accessor lacks its count, its indices or its values"));
    // Both are read as accessors of their own, which they are.
    Json indexAccessor = *indices, valueAccessor = *values;
    indexAccessor["type"] = "SCALAR";
    indexAccessor["count"] = sparse.at("count");
    valueAccessor["type"] = accessor.at("type");
    valueAccessor["componentType"] = accessor.at("componentType");
    valueAccessor["count"] = sparse.at("count");
    if (GltfFile::find(indexAccessor, "sparse") || GltfFile::find(valueAccessor, "sparse"))
        failMalformed(tr("a sparse accessor lies in another"));
    const GltfValues places(file, indexAccessor), patches(file, valueAccessor);
    if (!places.areIntegers())
        failMalformed(tr("the indices of a sparse accessor are not integers"));
    const std::size_t elementBytes = m_components * m_componentBytes;
    std::vector<std::uint8_t> whole(m_count * elementBytes);
    for (std::size_t element = 0; element < m_count; ++element)
        std::memcpy(whole.data() + element * elementBytes, placeOf(element, 0), elementBytes);
    for (std::size_t patch = 0; patch < places.count(); ++patch) {
        const std::int64_t place = places.integerAt(patch, 0);
        if (place < 0 || static_cast<std::uint64_t>(place) >= m_count)
            failMalformed(tr("a sparse accessor of %1 elements changes number %2", m_count, place));
        std::memcpy(whole.data() + static_cast<std::size_t>(place) * elementBytes, patches.placeOf(patch, 0),
                    elementBytes);
    }
    m_owned = std::move(whole);
    m_bytes = m_owned;
    m_stride = elementBytes;
}

std::int64_t GltfValues::integerAt(std::size_t element, std::size_t component) const
{
    const std::uint8_t *place = placeOf(element, component);
    switch (m_type) {
    case 5120: return static_cast<std::int8_t>(*place);
    case 5121: return *place;
    case 5122: return numberAt<std::int16_t>(place);
    case 5123: return numberAt<std::uint16_t>(place);
    default: return numberAt<std::uint32_t>(place);
    }
}

double GltfValues::at(std::size_t element, std::size_t component) const
{
    if (m_type == kFloat)
        return static_cast<double>(numberAt<float>(placeOf(element, component)));
    const auto value = static_cast<double>(integerAt(element, component));
    if (!m_isNormalized)
        return value;
    switch (m_type) {
    case 5120: return std::max(value / 127.0, -1.0);
    case 5121: return value / 255.0;
    case 5122: return std::max(value / 32767.0, -1.0);
    case 5123: return value / 65535.0;
    default: return value / 4294967295.0;
    }
}

} // namespace unprojector::mesh::reader
