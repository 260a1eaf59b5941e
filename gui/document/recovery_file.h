#pragma once

#include "core/files/file_stamp.h"
#include "core/scene_file/scene_file.h"

#include <QDateTime>
#include <QLockFile>
#include <QString>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace unprojector::gui {

/// Done, or why not, in the system's words.
using Kept = geometry::Result<std::monostate, QString>;

/// Which scene a recovery file keeps.
struct RecoveryInfo {
    QString name;                               ///< as the window's title has it
    std::filesystem::path sceneFile;            ///< absolute: what it was opened from or saved to; empty: nowhere
    QDateTime time;                             ///< when it was kept
    std::optional<files::FileStamp> stamp = {}; ///< of the scene file, when it was last read or written
};

/// One scene with unsaved changes, kept in the recovery folder in case the program ends unexpectedly. Whoever has such
/// an object holds the file's lock: no other window and no other running program offers it or writes it.
///
/// The file is one line of JSON with the RecoveryInfo, then the scene as File > Save would write it beside the scene
/// file, so that its models are found from there. A scene without a file has them by absolute paths. Both parts are in
/// one file, so that they cannot come from different moments. Folder and files are the user's alone: a scene may be of a
/// patient.
class RecoveryFile {
public:
    /// The folder for them: the user's own, or that of a program that isPortable.
    static QString defaultFolder(const QString &programFolder);
    /// A file of a new name, not written yet; the folder is made where there is none.
    /// @return why there is none, in the system's words
    static geometry::Result<std::unique_ptr<RecoveryFile>, QString> create(const QString &folder);
    /// The files that no running program holds, the last written first. What else dead programs have left (half
    /// files, locks) is cleared away.
    static std::vector<std::unique_ptr<RecoveryFile>> abandonedIn(const QString &folder);

    /// Lets go of the file, which stays. Its next owner finds it by abandonedIn.
    ~RecoveryFile() = default;
    RecoveryFile(const RecoveryFile &) = delete;
    RecoveryFile &operator=(const RecoveryFile &) = delete;

    /// Replaces the content as a whole, or leaves it as it was.
    /// @param sceneText  by core's sceneText
    /// @return whether it is on the disk
    Kept write(const RecoveryInfo &info, const std::string &sceneText);
    /// @return nothing where the file is damaged
    std::optional<RecoveryInfo> info() const;
    /// @return NotReadable; the errors of parseScene, with lines counted from the scene's first
    geometry::Result<scene_file::SceneFile, scene_file::SceneFileError> scene() const;

    QString path() const;
    void remove();
    /// Takes a damaged file out of the way, so that it is not offered again but is there for whoever can mend it.
    /// @return where it is now
    QString putAside();

private:
    RecoveryFile(const QString &folder, const QString &id);
    /// Removes what a dead program may have left of this file besides its content.
    void clearRests() const;

    QString m_folder;
    QString m_id;
    QLockFile m_lock;
};

} // namespace unprojector::gui
