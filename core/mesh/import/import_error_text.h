#pragma once

#include "core/mesh/import/mesh_import.h"

#include <string>

namespace unprojector::mesh {

/// Why a model file is refused and what to do, the file's name before it:
///
///   head.obj: the file is damaged: line 3: a vertex needs three numbers
std::string importErrorText(const ImportError &error);
/// The same without the name.
std::string reasonText(const ImportError &error);

} // namespace unprojector::mesh
