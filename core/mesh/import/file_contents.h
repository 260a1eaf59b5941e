#pragma once

#include <string>
#include <string_view>

namespace unprojector::mesh::reader {

/// Advice for a file whose contents don't match its suffix, such as "its contents look like PLY:
/// give it the suffix .ply". Empty if they match, or look like no known format.
/// @param start   the first bytes of the file, up to some hundred
/// @param suffix  lower case, without the dot
std::string adviceByContents(std::string_view start, std::string_view suffix);

} // namespace unprojector::mesh::reader
