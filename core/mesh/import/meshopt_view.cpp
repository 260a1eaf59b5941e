#include "core/mesh/import/meshopt_view.h"

#include "core/base/translation.h"

#include <meshoptimizer.h>

#include <string>

namespace unprojector::mesh::reader {
using base::tr;

namespace {

/// The maximum growth of a packed byte: in later versions one byte encodes that four columns of 256
/// vertices are 0.
constexpr std::uint64_t kMostGrowth = 1024;

std::string textOf(const Json &object, const char *key, const char *otherwise)
{
    const Json *found = GltfFile::find(object, key);
    if (!found)
        return otherwise;
    if (!found->is_string())
        failMalformed(tr("\"%1\" of a packed buffer view is not a text", key));
    return found->get<std::string>();
}

/// Checks the preconditions that the library asserts. The library itself reports errors in the
/// data.
class Unpacking {
public:
    Unpacking(const Json &view, const Json &packing)
        : m_mode(textOf(packing, "mode", "")), m_filter(textOf(packing, "filter", "NONE")),
          m_count(GltfFile::number(packing, "count", 0)), m_stride(GltfFile::number(packing, "byteStride", 0))
    {
        const std::uint64_t whole = GltfFile::number(view, "byteLength", 0);
        if (m_count * m_stride != whole)
            failMalformed(
                tr("a packed buffer view of %1 times %2 bytes is declared as %3 bytes", m_count, m_stride, whole));
        const bool hasFilter = m_filter != "NONE";
        if (m_mode == "ATTRIBUTES") {
            if (m_stride % 4 != 0 || m_stride == 0 || m_stride > 256)
                failStride();
        } else if (m_mode == "TRIANGLES" || m_mode == "INDICES") {
            if (m_stride != 2 && m_stride != 4)
                failStride();
            if (m_mode == "TRIANGLES" && m_count % 3 != 0)
                failMalformed(tr("a buffer view that is packed as triangles has %1 indices", m_count));
        } else {
            failMalformed(tr("a buffer view is packed in the mode \"%1\", which does not exist", m_mode));
        }
        if ((hasFilter && m_mode != "ATTRIBUTES")
            || (hasFilter && m_filter != "OCTAHEDRAL" && m_filter != "QUATERNION" && m_filter != "EXPONENTIAL"))
            failMalformed(tr("a buffer view is packed in the mode \"%1\" with the filter \"%2\", which does not exist",
                             m_mode, m_filter));
        if ((m_filter == "OCTAHEDRAL" && m_stride != 4 && m_stride != 8) || (m_filter == "QUATERNION" && m_stride != 8))
            failStride();
    }

    std::vector<std::uint8_t> unpacked(std::span<const std::uint8_t> bytes) const
    {
        // An index takes at least a byte, and so does a triangle.
        const std::uint64_t most = m_mode == "TRIANGLES" ? 3 * std::uint64_t{bytes.size()}
                                   : m_mode == "INDICES" ? bytes.size()
                                                         : kMostGrowth * bytes.size() / m_stride;
        if (m_count > most)
            failMalformed(tr("a packed buffer view of %1 bytes declares %2 elements", bytes.size(), m_count));
        std::vector<std::uint8_t> whole(static_cast<std::size_t>(m_count * m_stride));
        if (decode(whole.data(), bytes) != 0)
            failMalformed(tr("a packed buffer view of %1 elements is damaged, or is packed by a later version of "
                             "meshoptimizer than %2",
                             m_count,
                             std::to_string(MESHOPTIMIZER_VERSION / 1000) + '.'
                                 + std::to_string(MESHOPTIMIZER_VERSION % 1000 / 10)));
        filter(whole.data());
        return whole;
    }

private:
    [[noreturn]] void failStride() const
    {
        failMalformed(
            tr("a buffer view that is packed in the mode \"%1\" with the filter \"%2\" has elements of %3 bytes, "
               "which do not fit",
               m_mode, m_filter, m_stride));
    }

    int decode(std::uint8_t *whole, std::span<const std::uint8_t> bytes) const
    {
        const auto count = static_cast<std::size_t>(m_count), stride = static_cast<std::size_t>(m_stride);
        if (m_mode == "ATTRIBUTES")
            return meshopt_decodeVertexBuffer(whole, count, stride, bytes.data(), bytes.size());
        if (m_mode == "TRIANGLES")
            return meshopt_decodeIndexBuffer(whole, count, stride, bytes.data(), bytes.size());
        return meshopt_decodeIndexSequence(whole, count, stride, bytes.data(), bytes.size());
    }

    void filter(std::uint8_t *whole) const
    {
        const auto count = static_cast<std::size_t>(m_count), stride = static_cast<std::size_t>(m_stride);
        if (m_filter == "OCTAHEDRAL")
            meshopt_decodeFilterOct(whole, count, stride);
        else if (m_filter == "QUATERNION")
            meshopt_decodeFilterQuat(whole, count, stride);
        else if (m_filter == "EXPONENTIAL")
            meshopt_decodeFilterExp(whole, count, stride);
    }

    std::string m_mode;
    std::string m_filter;
    std::uint64_t m_count;
    std::uint64_t m_stride; ///< bytes of an element
};

} // namespace

bool hasMeshopt()
{
    return true;
}

std::vector<std::uint8_t> unpackedView(const Json &view, const Json &packing, std::span<const std::uint8_t> bytes)
{
    return Unpacking(view, packing).unpacked(bytes);
}

} // namespace unprojector::mesh::reader
