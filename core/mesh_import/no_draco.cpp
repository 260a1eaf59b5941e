// Where the program is built without Draco.

#include "core/mesh_import/draco_mesh.h"

namespace unprojector::mesh_import::mesh_reader {

bool hasDraco()
{
    return false;
}

DracoMesh unpackedDraco(std::span<const std::uint8_t>, std::span<const DracoRequest>, const DracoCounts &)
{
    return {};
}

} // namespace unprojector::mesh_import::mesh_reader
