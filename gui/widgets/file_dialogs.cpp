#include "gui/widgets/file_dialogs.h"

#include "gui/text/error_text.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <QWidget>

namespace unprojector::gui {
namespace {

QString nameOf(FileKind kind)
{
    switch (kind) {
    case FileKind::Model: return QStringLiteral("model");
    case FileKind::Scene: return QStringLiteral("scene");
    case FileKind::Landmarks: return QStringLiteral("landmarks");
    case FileKind::Template: return QStringLiteral("template");
    case FileKind::Series: return QStringLiteral("series");
    case FileKind::Table: return QStringLiteral("table");
    case FileKind::Image: return QStringLiteral("image");
    case FileKind::Code: return QStringLiteral("code");
    case FileKind::Map: return QStringLiteral("map");
    case FileKind::Camera: return QStringLiteral("camera");
    }
    return {};
}

QString settingOf(FileKind kind)
{
    return QStringLiteral("folders/") + nameOf(kind);
}

std::filesystem::path pathOf(const QString &name)
{
    return {name.toStdU16String()};
}

} // namespace

QString startFolder(const QWidget &parent, FileKind kind)
{
    const QString last = QSettings().value(settingOf(kind)).toString();
    if (QFileInfo(last).isDir())
        return last;
    for (const QWidget *widget = &parent; widget; widget = widget->parentWidget()) {
        const QFileInfo file(widget->windowFilePath());
        if (!widget->windowFilePath().isEmpty() && file.isAbsolute())
            return file.path();
    }
    return {};
}

void rememberFolder(FileKind kind, const QString &chosen)
{
    const QFileInfo info(chosen);
    QSettings().setValue(settingOf(kind), info.isDir() ? info.absoluteFilePath() : info.absolutePath());
}

std::vector<std::filesystem::path> askFileNames(QWidget &parent, FileKind kind, const QString &title,
                                                const QString &filter)
{
    std::vector<std::filesystem::path> files;
    for (const QString &name : QFileDialog::getOpenFileNames(&parent, title, startFolder(parent, kind), filter)) {
        rememberFolder(kind, name);
        files.push_back(pathOf(name));
    }
    return files;
}

std::filesystem::path askFileName(QWidget &parent, FileKind kind, const QString &title, const QString &filter)
{
    const QString name = QFileDialog::getOpenFileName(&parent, title, startFolder(parent, kind), filter);
    if (!name.isEmpty())
        rememberFolder(kind, name);
    return pathOf(name);
}

std::filesystem::path askFolder(QWidget &parent, FileKind kind, const QString &title)
{
    const QString folder = QFileDialog::getExistingDirectory(&parent, title, startFolder(parent, kind));
    if (!folder.isEmpty())
        rememberFolder(kind, folder);
    return pathOf(folder);
}

std::filesystem::path askSceneName(QWidget &parent, const QString &title, const std::filesystem::path &proposal,
                                   const QString &filter)
{
    const QString proposed = pathText(proposal), folder = startFolder(parent, FileKind::Scene);
    const bool hasFolder = proposal.has_parent_path() || folder.isEmpty();
    const QString name =
        QFileDialog::getSaveFileName(&parent, title, hasFolder ? proposed : folder + u'/' + proposed, filter);
    if (!name.isEmpty())
        rememberFolder(FileKind::Scene, name);
    return pathOf(name);
}

} // namespace unprojector::gui
