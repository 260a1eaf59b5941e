#pragma once

#include "core/mesh/mesh.h"

#include <string>

namespace unprojector::mesh {

/// Describes an import note in one line, without a capital and a full stop. UTF-8, in the language
/// of base::tr():
///
///   3 lines and points are not shown
///   the picture "skin.png" is not there or cannot be read: its surfaces are shown without it
///
/// Names from the file are quoted unchanged, except that characters that would end the line or
/// control a terminal become "?".
std::string noteText(const ModelNote &note);

} // namespace unprojector::mesh
