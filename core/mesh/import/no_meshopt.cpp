// Stubs for builds without meshoptimizer.

#include "core/mesh/import/meshopt_view.h"

namespace unprojector::mesh::reader {

bool hasMeshopt()
{
    return false;
}

std::vector<std::uint8_t> unpackedView(const Json &, const Json &, std::span<const std::uint8_t>)
{
    return {};
}

} // namespace unprojector::mesh::reader
