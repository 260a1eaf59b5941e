#include "gui/widgets/save_name.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include <algorithm>

namespace unprojector::gui {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::SaveName)
};

/// The suffixes of a filter: "cpp" and "h" of "C++ (*.cpp *.h)".
QStringList suffixesOf(const QString &filter)
{
    QStringList suffixes;
    const QStringList patterns = filter.section(u'(', -1).chopped(1).split(u' ', Qt::SkipEmptyParts);
    for (const QString &pattern : patterns)
        suffixes << pattern.mid(2);
    return suffixes;
}

bool hasSuffix(const QString &fileName, const QString &filter)
{
    const QStringList suffixes = suffixesOf(filter);
    const QString last = u'.' + QFileInfo(fileName).suffix();
    return std::any_of(suffixes.begin(), suffixes.end(), [&](const QString &suffix) {
        return fileName.endsWith(u'.' + suffix, Qt::CaseInsensitive)
               || (last.size() > 1 && suffix.endsWith(last, Qt::CaseInsensitive));
    });
}

/// Tells the user the suffixes that a name may have.
void rejectSuffix(QWidget &parent, const QString &title, const QString &file, const QStringList &filters)
{
    QStringList suffixes;
    for (const QString &filter : filters) {
        for (const QString &suffix : suffixesOf(filter)) {
            if (!suffixes.contains(u'.' + suffix))
                suffixes << u'.' + suffix;
        }
    }
    QMessageBox box(QMessageBox::Warning, title,
                    Texts::tr("%1: no format has this suffix. End the name with one of: %2.")
                        .arg(QFileInfo(file).fileName(), suffixes.join(QStringLiteral(", "))),
                    QMessageBox::Ok, &parent);
    box.setTextFormat(Qt::PlainText);
    box.exec();
}

} // namespace

std::optional<int> filterOf(const QString &fileName, const QStringList &filters, int chosen)
{
    if (chosen >= 0 && chosen < filters.size() && hasSuffix(fileName, filters[chosen]))
        return chosen;
    const auto found = std::find_if(filters.begin(), filters.end(),
                                    [&fileName](const QString &filter) { return hasSuffix(fileName, filter); });
    return found != filters.end() ? std::optional(static_cast<int>(found - filters.begin())) : std::nullopt;
}

SaveName askSaveName(QWidget &parent, const QString &title, const QStringList &filters, const QString &proposed,
                     FileKind kind)
{
    QFileDialog dialog(&parent, title, startFolder(parent, kind));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters(filters);
    const auto takeSuffix = [&dialog](const QString &filter) {
        const QString before = dialog.defaultSuffix(), now = suffixesOf(filter).front();
        const QStringList files = dialog.selectedFiles();
        dialog.setDefaultSuffix(now);
        const QFileInfo named(files.isEmpty() ? QString() : files.front());
        if (!before.isEmpty() && named.fileName().endsWith(u'.' + before) && !named.isDir())
            dialog.selectFile(named.fileName().chopped(before.size()) + now);
    };
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, takeSuffix);
    takeSuffix(filters.front());
    dialog.selectFile(proposed);
    while (dialog.exec() == QDialog::Accepted && !dialog.selectedFiles().isEmpty()) {
        const QString file = dialog.selectedFiles().front();
        const auto chosen = static_cast<int>(filters.indexOf(dialog.selectedNameFilter()));
        if (const std::optional<int> filter = filterOf(file, filters, chosen)) {
            rememberFolder(kind, file);
            return {std::filesystem::path(file.toStdU16String()), *filter};
        }
        rejectSuffix(parent, title, file, filters);
    }
    return {};
}

} // namespace unprojector::gui
