#pragma once

#include "core/base/file_stamp.h"
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

/// Success, or the system's reason for a failure.
using Kept = geometry::Result<std::monostate, QString>;

/// A scan of a series with unsaved landmarks.
struct RecoverySeries {
    std::filesystem::path folder; ///< absolute
    std::filesystem::path scan;   ///< absolute
    int placing = 1;
    base::FileStamp stamp; ///< of the file with its landmarks at the last read or write
    int placed = 0;        ///< number of placed landmarks
    int saved = 0;         ///< number of placed landmarks in that file
};

/// The description of the scene that a recovery file keeps.
struct RecoveryInfo {
    QString name;                              ///< as the window's title has it
    std::filesystem::path sceneFile;           ///< absolute: the file it was opened from or saved to; empty: none
    QDateTime time;                            ///< when it was kept
    std::optional<base::FileStamp> stamp = {}; ///< of the scene file at the last read or write
    std::optional<RecoverySeries> series = {}; ///< of a scan of a series

    /// The name, and the series of a scan.
    QString shownName() const;
    /// Describes the loss without the file: the name, and the numbers of a scan's landmarks.
    QString lostText() const;
};

/// A scene with unsaved changes, kept in the recovery folder in case the program ends unexpectedly.
/// The object holds the file's lock: no other window and no other running program offers it or
/// writes it.
///
/// The file is one line of JSON with the RecoveryInfo, then the scene as File > Save would write it
/// beside the scene file: relative paths find its models. A scene without a file has absolute
/// paths. Both parts are in one file, so that they are always from the same moment. Only the user
/// can read folder and files: a scene may be of a patient.
class RecoveryFile {
public:
    /// The folder of recovery files: the user's own, or a portable program's (isPortable).
    static QString defaultFolder(const QString &programFolder);
    /// Creates a file with a new name, not written yet; creates the folder if needed.
    /// @return the system's reason on failure
    static geometry::Result<std::unique_ptr<RecoveryFile>, QString> create(const QString &folder);
    /// The files that no running program holds, the last written first. Removes other remains of
    /// dead programs (half-written files, locks).
    static std::vector<std::unique_ptr<RecoveryFile>> abandonedIn(const QString &folder);

    /// Releases the lock; the file stays. abandonedIn finds it later.
    ~RecoveryFile() = default;
    RecoveryFile(const RecoveryFile &) = delete;
    RecoveryFile &operator=(const RecoveryFile &) = delete;

    /// Replaces the whole content, or leaves it unchanged on failure.
    /// @param sceneText  by core's sceneText
    /// @return whether it is on the disk
    Kept write(const RecoveryInfo &info, const std::string &sceneText);
    /// @return nothing if the file is damaged
    std::optional<RecoveryInfo> info() const;
    /// @return NotReadable; the errors of parseScene, with lines counted from the scene's first
    scene_file::SceneOrError scene() const;

    QString path() const;
    void remove();
    /// Renames a damaged file: it is not offered again, but it can still be repaired.
    /// @return its new path
    QString putAside();

private:
    RecoveryFile(const QString &folder, const QString &id);
    /// Removes other remains of a dead program than the content.
    void clearRests() const;

    QString m_folder;
    QString m_id;
    QLockFile m_lock;
};

} // namespace unprojector::gui
