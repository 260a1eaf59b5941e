#pragma once

#include <string>
#include <string_view>

namespace unprojector::mesh::reader {

/// What to do with a file whose contents are of another kind than its name says, such as "its contents look like PLY: give
/// it the suffix .ply"; empty where they look like what the suffix says, or like nothing known.
/// @param start   the first bytes of the file, as many as there are up to some hundred
/// @param suffix  lower case, without the dot
std::string adviceByContents(std::string_view start, std::string_view suffix);

} // namespace unprojector::mesh::reader
