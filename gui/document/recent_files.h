#pragma once

#include <QStringList>

namespace unprojector::gui {

// The last opened files, newest first, kept in the user's settings.

QStringList recentFiles();
void addRecentFile(const QString &absolutePath);
void clearRecentFiles();
/// The menu text of a recent file: its name, then its folder.
QString recentFileText(const QString &absolutePath);

} // namespace unprojector::gui
