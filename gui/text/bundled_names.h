#pragma once

#include <QString>

#include <string>

namespace unprojector::gui {

/// The name of an object as the user reads it. Those that come with the program have theirs in the language that it speaks,
/// numbered or not ("Cube (2)"); scenes and their files know them by the English one, and so are the same in all languages.
QString readName(const std::string &name);

} // namespace unprojector::gui
