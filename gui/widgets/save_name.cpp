#include "gui/widgets/save_name.h"

#include <QFileDialog>

#include <algorithm>

namespace unprojector::gui {

SaveName askSaveName(QWidget &parent, const QString &title, const QStringList &filters, const QString &proposed,
                     FileKind kind)
{
    QFileDialog dialog(&parent, title, startFolder(parent, kind));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters(filters);
    const auto takeSuffix = [&dialog](const QString &filter) {
        dialog.setDefaultSuffix(filter.section(QStringLiteral("*."), -1).chopped(1)); // "csv" of "Table (*.csv)"
    };
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, takeSuffix);
    takeSuffix(filters.front());
    dialog.selectFile(proposed);
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty())
        return {};
    rememberFolder(kind, dialog.selectedFiles().front());
    return {std::filesystem::path(dialog.selectedFiles().front().toStdU16String()),
            static_cast<int>(std::max<qsizetype>(0, filters.indexOf(dialog.selectedNameFilter())))};
}

} // namespace unprojector::gui
