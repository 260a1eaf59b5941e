// A model file of one format, its suffix given by UNPROJECTOR_FUZZ_SUFFIX, as it comes from a disk.

#include "core/geometry/finite.h"
#include "core/mesh/import/mesh_import.h"
#include "tests/fuzz/fuzzing.h"

#include <algorithm>

using namespace unprojector;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const auto read = mesh::importModel(fuzz::fileOf("model." UNPROJECTOR_FUZZ_SUFFIX, data, size), {});
    if (!read)
        return 0;
    const mesh::Model &model = **read;
    fuzz::require(!model.meshes.empty(), "a model that opens has something to show");
    for (const mesh::Mesh &mesh : model.meshes) {
        const bool isPoints = mesh.kind == mesh::Mesh::Kind::Points;
        fuzz::require(mesh.elementCount() > 0, "a mesh has something to show");
        fuzz::require(isPoints ? mesh.indices.empty() : mesh.elementCount() % 3 == 0, "faces are triangles");
        fuzz::require(std::all_of(mesh.indices.begin(), mesh.indices.end(),
                                  [&](std::uint32_t i) { return i < mesh.positions.size(); }),
                      "triangles have vertices of their mesh");
        fuzz::require(geometry::isFinite(mesh.origin)
                          && std::all_of(mesh.positions.begin(), mesh.positions.end(),
                                         [](const glm::vec3 &p) { return geometry::isFinite(p); }),
                      "coordinates are finite");
        const auto isOneEachOrNone = [&](const auto &values) {
            return values.empty() || values.size() == mesh.positions.size();
        };
        fuzz::require(isOneEachOrNone(mesh.normals) && isOneEachOrNone(mesh.colors) && isOneEachOrNone(mesh.texcoords),
                      "what vertices have, all have");
        fuzz::require(mesh.texture < static_cast<int>(model.textures.size()), "a mesh's texture is one of the model's");
    }
    return 0;
}
