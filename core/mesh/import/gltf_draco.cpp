#include "core/mesh/import/gltf_draco.h"

#include "core/base/translation.h"
#include "core/mesh/import/draco_mesh.h"
#include "core/mesh/import/gltf_corners.h"
#include "core/mesh/import/gltf_extensions.h"

#include <string>
#include <utility>
#include <vector>

namespace unprojector::mesh::reader {
using base::tr;

namespace {

constexpr const char *kTypes[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};

std::uint64_t countOf(const GltfFile &file, const Json &object, const char *key)
{
    return GltfFile::number(file.reference(object, key, "accessors"), "count", 0);
}

/// Requires unpacked fallback data, for a program without Draco.
void requireSubstitute(const GltfFile &file, const Json &primitive)
{
    const auto isPacked = [&file](const Json &object, const char *key) {
        return GltfFile::find(object, key) && !GltfFile::find(file.reference(object, key, "accessors"), "bufferView");
    };
    const Json *attributes = GltfFile::find(primitive, "attributes");
    if ((attributes && isPacked(*attributes, "POSITION")) || isPacked(primitive, "indices"))
        failWithoutLibrary(kDracoExtension);
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
    const DracoCounts expected{countOf(file, *attributes, "POSITION"), GltfCorners(mode, corners).triangleCount()};

    std::vector<std::string> names;
    std::vector<DracoRequest> requests;
    for (const auto &[name, id] : ids->items()) {
        if (!GltfFile::find(*attributes, name.c_str()))
            continue;
        names.push_back(name);
        const Json &accessor = file.reference(*attributes, name.c_str(), "accessors");
        requests.push_back({GltfFile::number(*ids, name.c_str(), 0),
                            static_cast<int>(GltfFile::number(accessor, "componentType", 0))});
    }
    DracoMesh mesh = unpackedDraco(file.viewBytes(packing), requests, expected);

    // The accessors stay unchanged for other primitives, which may have other data.
    for (std::size_t i = 0; i < names.size(); ++i) {
        Json accessor = file.reference(*attributes, names[i].c_str(), "accessors");
        accessor.erase("byteOffset");
        accessor["type"] = kTypes[mesh.attributes[i].components];
        accessor["count"] = mesh.counts.vertices;
        primitive["attributes"][names[i]] = file.addAccessor(std::move(accessor), std::move(mesh.attributes[i].bytes));
    }
    primitive["indices"] = file.addAccessor(
        {{"componentType", 5125u}, {"type", "SCALAR"}, {"count", 3 * mesh.counts.triangles}}, std::move(mesh.indices));
    primitive["mode"] = std::uint64_t{GltfCorners::Triangles};
}

} // namespace

void unpackDraco(GltfFile &file, const std::set<std::uint64_t> &meshes)
{
    for (const std::uint64_t number : meshes) {
        for (Json &primitive : file.root()["meshes"][static_cast<std::size_t>(number)]["primitives"]) {
            const Json *packing = extensionOf(primitive, kDracoExtension);
            if (!packing)
                continue;
            file.source().progress.report(0.0);
            if (hasDraco())
                unpack(file, *packing, primitive);
            else
                requireSubstitute(file, primitive);
        }
    }
}

} // namespace unprojector::mesh::reader
