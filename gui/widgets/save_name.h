#pragma once

#include "gui/widgets/file_dialogs.h"

#include <QString>
#include <QStringList>

#include <filesystem>
#include <optional>

class QWidget;

namespace unprojector::gui {

/// A file to write to, and its format.
struct SaveName {
    std::filesystem::path file; ///< empty: none was chosen
    int filter = 0;             ///< index of the filter with its suffix
};

/// The index of the filter with a file's suffix: the chosen one if it has it, else the first. A file
/// "x.json" fits "Markups (*.mrk.json)". Nothing if no filter has the suffix.
/// @param filters  "Table (*.csv)", "C++ (*.cpp *.h)"
std::optional<int> filterOf(const QString &fileName, const QStringList &filters, int chosen);

/// Asks for the name of a file to write to. The suffix that the user types decides the format. A
/// name without a suffix gets the first one of the chosen filter, before the question whether to
/// replace an existing file. A suffix of no filter is rejected with a message.
/// @param filters  see filterOf
/// @param proposed  a name; may be empty
/// @param kind  decides the folder, see file_dialogs.h
SaveName askSaveName(QWidget &parent, const QString &title, const QStringList &filters, const QString &proposed = {},
                     FileKind kind = FileKind::Table);

} // namespace unprojector::gui
