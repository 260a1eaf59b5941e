#pragma once

#include "core/mesh/import/mesh_import.h"

#include <string>

namespace unprojector::cli {
using namespace mesh;

/// The command's wording of why a model file is refused: names the file and says what to do.
std::string importErrorText(const ImportError &error);

} // namespace unprojector::cli
