// Stubs for builds without Draco.

#include "core/mesh/import/draco_mesh.h"

namespace unprojector::mesh::reader {

bool hasDraco()
{
    return false;
}

DracoMesh unpackedDraco(std::span<const std::uint8_t>, std::span<const DracoRequest>, const DracoCounts &)
{
    return {};
}

} // namespace unprojector::mesh::reader
