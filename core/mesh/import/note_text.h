#pragma once

#include "core/mesh/mesh.h"

#include <string>

namespace unprojector::mesh {

/// One line in the language of text::tr(), UTF-8, that says what of a model file is not shown, or not as the file has it, without
/// a capital and a full stop:
///
///   3 lines and points are not shown
///   the picture "skin.png" is not there or cannot be read: its surfaces are shown without it
///
/// What the file says is quoted as it is, but for characters that
/// would end the line or steer a terminal, which become "?".
std::string noteText(const ModelNote &note);

} // namespace unprojector::mesh
