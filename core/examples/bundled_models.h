#pragma once

#include "core/mesh/mesh.h"

#include <map>
#include <memory>
#include <string>

namespace unprojector::examples {

/// The models that the program brings along, by the names that scene files know them by. Built by the first call, from
/// whatever thread it comes; all scenes share them.
const std::map<std::string, std::shared_ptr<const mesh::Model>> &bundledModels();

} // namespace unprojector::examples
