#pragma once

#include "core/mesh/import/mesh_import.h"

#include <string>

namespace unprojector::mesh {

/// The reason why a model file is rejected and the remedy, after the file's name:
///
///   head.obj: the file is damaged: line 3: a vertex needs three numbers
std::string importErrorText(const ImportError &error);
/// The same without the name.
std::string reasonText(const ImportError &error);

} // namespace unprojector::mesh
