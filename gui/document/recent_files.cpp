#include "gui/document/recent_files.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace unprojector::gui {
namespace {

constexpr int kMostFiles = 10;

QString key()
{
    return QStringLiteral("recentFiles");
}

} // namespace

QStringList recentFiles()
{
    return QSettings().value(key()).toStringList();
}

void addRecentFile(const QString &absolutePath)
{
    QStringList files = recentFiles();
    files.removeAll(absolutePath);
    files.prepend(absolutePath);
    QSettings().setValue(key(), QVariant(files.mid(0, kMostFiles)));
}

void clearRecentFiles()
{
    QSettings().remove(key());
}

QString recentFileText(const QString &absolutePath)
{
    const QFileInfo info(absolutePath);
    QString text = QStringLiteral("%1 – %2").arg(info.fileName(), QDir::toNativeSeparators(info.path()));
    return text.replace(u'&', QStringLiteral("&&"));
}

} // namespace unprojector::gui
