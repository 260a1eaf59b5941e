#pragma once

#include <QString>

#include <filesystem>
#include <vector>

class QWidget;

namespace unprojector::gui {

// All dialogs for files and folders. Each starts in the folder last used for its kind of file, else
// in the folder of the scene or scan of its window (QWidget::windowFilePath). The folders last from
// one start of the program to the next.

/// The kinds of files that are usually kept in different folders.
enum class FileKind { Model, Scene, Landmarks, Template, Series, Table, Image, Code, Map, Camera };

/// The folder in which a dialog starts; empty: the system decides.
QString startFolder(const QWidget &parent, FileKind kind);
/// Remembers the folder of a chosen file, or a chosen folder itself.
void rememberFolder(FileKind kind, const QString &chosen);

// Ask for names. @return empty: none was chosen

std::vector<std::filesystem::path> askFileNames(QWidget &parent, FileKind kind, const QString &title,
                                                const QString &filter);
std::filesystem::path askFileName(QWidget &parent, FileKind kind, const QString &title, const QString &filter);
std::filesystem::path askFolder(QWidget &parent, FileKind kind, const QString &title);
/// Asks for the name of a scene to save. @param proposal  with or without its folder
std::filesystem::path askSceneName(QWidget &parent, const QString &title, const std::filesystem::path &proposal,
                                   const QString &filter);

} // namespace unprojector::gui
