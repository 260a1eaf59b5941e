#pragma once

#include <QString>

namespace unprojector::gui {

/// Returns whether the program in this folder is portable, as on a USB stick: the folder has a file
/// named "portable". Settings and recovery files then stay in that folder instead of the user's
/// account.
bool isPortable(const QString &programFolder);

} // namespace unprojector::gui
