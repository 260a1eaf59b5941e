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

} // namespace

bool hasMeshopt()
{
    return true;
}

std::vector<std::uint8_t> unpackedView(const Json &view, const Json &packing, std::span<const std::uint8_t> bytes)
{
    const std::string mode = textOf(packing, "mode", ""), filter = textOf(packing, "filter", "NONE");
    const std::uint64_t count = GltfFile::number(packing, "count", 0);
    const std::uint64_t stride = GltfFile::number(packing, "byteStride", 0); // bytes of an element
    // The library asserts its preconditions; it reports errors in the data only.
    const std::uint64_t declared = GltfFile::number(view, "byteLength", 0);
    if (count * stride != declared)
        failMalformed(tr("a packed buffer view of %1 times %2 bytes is declared as %3 bytes", count, stride, declared));
    const bool hasAttributes = mode == "ATTRIBUTES", hasTriangles = mode == "TRIANGLES";
    if (!hasAttributes && !hasTriangles && mode != "INDICES")
        failMalformed(tr("a buffer view is packed in the mode \"%1\", which does not exist", mode));
    const auto checkStride = [&](bool fits) {
        if (!fits)
            failMalformed(
                tr("a buffer view that is packed in the mode \"%1\" with the filter \"%2\" has elements of %3 bytes, "
                   "which do not fit",
                   mode, filter, stride));
    };
    checkStride(hasAttributes ? stride % 4 == 0 && stride > 0 && stride <= 256 : stride == 2 || stride == 4);
    if (hasTriangles && count % 3 != 0)
        failMalformed(tr("a buffer view that is packed as triangles has %1 indices", count));
    const bool isOctahedral = filter == "OCTAHEDRAL", isQuaternion = filter == "QUATERNION",
               isExponential = filter == "EXPONENTIAL";
    if (filter != "NONE" && !(hasAttributes && (isOctahedral || isQuaternion || isExponential)))
        failMalformed(tr("a buffer view is packed in the mode \"%1\" with the filter \"%2\", which does not exist",
                         mode, filter));
    checkStride((!isOctahedral || stride == 4 || stride == 8) && (!isQuaternion || stride == 8));
    // An index takes at least a byte, and so does a triangle.
    const std::uint64_t most =
        hasAttributes ? kMostGrowth * bytes.size() / stride : (hasTriangles ? 3 : 1) * std::uint64_t{bytes.size()};
    if (count > most)
        failMalformed(tr("a packed buffer view of %1 bytes declares %2 elements", bytes.size(), count));

    std::vector<std::uint8_t> whole(static_cast<std::size_t>(declared));
    const auto elements = static_cast<std::size_t>(count), size = static_cast<std::size_t>(stride);
    const int error =
        hasAttributes  ? meshopt_decodeVertexBuffer(whole.data(), elements, size, bytes.data(), bytes.size())
        : hasTriangles ? meshopt_decodeIndexBuffer(whole.data(), elements, size, bytes.data(), bytes.size())
                       : meshopt_decodeIndexSequence(whole.data(), elements, size, bytes.data(), bytes.size());
    if (error != 0)
        failMalformed(
            tr("a packed buffer view of %1 elements is damaged, or is packed by a later version of "
               "meshoptimizer than %2",
               count,
               std::to_string(MESHOPTIMIZER_VERSION / 1000) + '.' + std::to_string(MESHOPTIMIZER_VERSION % 1000 / 10)));
    if (isOctahedral)
        meshopt_decodeFilterOct(whole.data(), elements, size);
    else if (isQuaternion)
        meshopt_decodeFilterQuat(whole.data(), elements, size);
    else if (isExponential)
        meshopt_decodeFilterExp(whole.data(), elements, size);
    return whole;
}

} // namespace unprojector::mesh::reader
