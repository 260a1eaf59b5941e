#pragma once

#include "core/mesh/mesh.h"

#include <map>
#include <memory>
#include <string>

namespace unprojector::examples {

/// The program's bundled models, by their names in scene files. The first call builds them, in any
/// thread; all scenes share them.
const std::map<std::string, std::shared_ptr<const mesh::Model>> &bundledModels();

} // namespace unprojector::examples
