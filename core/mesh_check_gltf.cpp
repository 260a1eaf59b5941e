#include "core/mesh_reader.h"

namespace unprojector::mesh_reader {

void checkGltf(const Source &) {}

} // namespace unprojector::mesh_reader
