#pragma once

#include <QString>
#include <QStringList>

#include <filesystem>

class QWidget;

namespace unprojector::gui {

/// A file to write to, and as what.
struct SaveName {
    std::filesystem::path file; ///< empty: none was chosen
    int filter = 0;             ///< the place of the filter that was chosen
};

/// Asks for the name of a file to write to. A name without a suffix gets that of the filter before it is asked whether a file that is
/// there is to be replaced.
/// @param filters  "Table (*.csv)", each with one suffix
/// @param proposed  a name; may be empty
SaveName askSaveName(QWidget &parent, const QString &title, const QStringList &filters, const QString &proposed = {});

} // namespace unprojector::gui
