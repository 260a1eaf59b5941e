#pragma once

#include "gui/widgets/file_dialogs.h"

#include <QString>
#include <QStringList>

#include <filesystem>

class QWidget;

namespace unprojector::gui {

/// A file to write to, and its format.
struct SaveName {
    std::filesystem::path file; ///< empty: none was chosen
    int filter = 0;             ///< index of the chosen filter
};

/// Asks for the name of a file to write to. A name without a suffix gets the filter's before the
/// question whether to replace an existing file.
/// @param filters  "Table (*.csv)", each with one suffix
/// @param proposed  a name; may be empty
/// @param kind  decides the folder, see file_dialogs.h
SaveName askSaveName(QWidget &parent, const QString &title, const QStringList &filters, const QString &proposed = {},
                     FileKind kind = FileKind::Table);

} // namespace unprojector::gui
