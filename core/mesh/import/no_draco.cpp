// For builds without Draco.

#include "core/mesh/import/gltf_draco.h"
#include "core/mesh/import/gltf_extensions.h"

namespace unprojector::mesh::reader {

bool hasDraco()
{
    return false;
}

void unpackDraco(GltfFile &file, Json &primitive)
{
    const auto isPacked = [&file](const Json &object, const char *key) {
        return GltfFile::find(object, key) && !GltfFile::find(file.reference(object, key, "accessors"), "bufferView");
    };
    const Json *attributes = GltfFile::find(primitive, "attributes");
    if ((attributes && isPacked(*attributes, "POSITION")) || isPacked(primitive, "indices"))
        failWithoutLibrary(kDracoExtension);
}

} // namespace unprojector::mesh::reader
