#pragma once

#include <QString>

namespace unprojector::gui {

/// Whether the program in this folder is carried about, on a stick for one: a file named "portable" lies there. What would be
/// kept in the user's account, settings and recovery files, then stays in that folder.
bool isPortable(const QString &programFolder);

} // namespace unprojector::gui
