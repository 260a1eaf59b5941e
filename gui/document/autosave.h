#pragma once

#include "gui/document/recovery_file.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <chrono>
#include <functional>
#include <memory>
#include <string>

namespace unprojector::gui {

/// The delays before unsaved changes are written.
struct AutosaveTiming {
    std::chrono::milliseconds pause{1000};  ///< after a change, if no other follows
    std::chrono::milliseconds latest{5000}; ///< after the first unwritten change, even if more changes follow
};

/// The limits of hurried writes.
struct HurryTiming {
    std::chrono::milliseconds between{200}; ///< writes; the first one is at once
    std::chrono::milliseconds cheap{50};    ///< the most time that a write takes if the next one may be hurried
};

/// Keeps a window's scene in a recovery file while it has changes that are saved nowhere else. The
/// file exists only while such changes exist: an unlocked file means that changes would be lost.
class Autosave : public QObject {
    Q_OBJECT
public:
    struct Content {
        RecoveryInfo info;
        std::string sceneText;
    };
    /// Called at the moment of writing: returns the content to keep, or why the scene cannot be
    /// serialized.
    using Source = std::function<geometry::Result<Content, QString>()>;

    Autosave(QString folder, AutosaveTiming timing, Source source, QObject *parent = nullptr);
    /// Leaves the file, if any, for the next start.
    ~Autosave() override = default;

    const QString &folder() const { return m_folder; }
    /// Reacts to a possible change of the scene: writes after a delay, or removes the file if there
    /// is nothing to keep.
    void follow(bool isUnsaved);
    /// Writes the changes that `follow` waits with on the next turn of the event loop, or later if the
    /// last write was just before. Does nothing if that took long.
    void hurry(HurryTiming timing = {});
    /// Takes over a recovered file as the scene's own. Removes the file that was kept before.
    void adopt(std::unique_ptr<RecoveryFile> file);
    /// Writes the latest changes and gives the file away; the next scene gets another file. If the
    /// write fails, emits `failed`, even if it was emitted before: no retry happens until the file
    /// is adopted and followed again.
    /// @return null if there was nothing to keep. After a failed write, the content kept before,
    /// which may be nothing
    std::unique_ptr<RecoveryFile> release();
    /// Removes the file: the changes are saved or not wanted.
    void discard();

signals:
    /// Emitted when the changes could not be kept; the reason names the folder and the system's
    /// reason, or the scene's. Emitted once until writing works again, and once more when the file
    /// is given away.
    void failed(const QString &reason);

private:
    void write();
    Kept keep();

    QString m_folder;
    AutosaveTiming m_timing;
    Source m_source;
    std::unique_ptr<RecoveryFile> m_file; ///< null while there is nothing to keep
    QTimer m_timer;
    QElapsedTimer m_sinceWrite;          ///< invalid before the first write
    std::chrono::milliseconds m_cost{0}; ///< of the last write
    QElapsedTimer m_sinceFirstChange;    ///< since the first unwritten change; invalid without one
    bool m_isBehind = false;             ///< there are unwritten changes
    bool m_isHurried = false;            ///< the timer runs since `hurry`
    bool m_hasFailed = false;
};

} // namespace unprojector::gui
