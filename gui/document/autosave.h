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

/// When unsaved changes are written.
struct AutosaveTiming {
    std::chrono::milliseconds pause{1000};  ///< after a change, if no other follows
    std::chrono::milliseconds latest{5000}; ///< after the first change that is not written, whatever follows
};

/// Keeps a window's scene in a recovery file for as long as it has changes that are saved nowhere else. There is such a
/// file just while there are such changes: whoever finds one that nobody holds knows that they would be lost.
class Autosave : public QObject {
    Q_OBJECT
public:
    struct Content {
        RecoveryInfo info;
        std::string sceneText;
    };
    /// What is to be kept, asked for at the moment of writing; or why the scene cannot be put into words.
    using Source = std::function<geometry::Result<Content, QString>()>;

    Autosave(QString folder, AutosaveTiming timing, Source source, QObject *parent = nullptr);
    /// The file, if there is one, stays for the next start.
    ~Autosave() override = default;

    const QString &folder() const { return m_folder; }
    /// The scene may have changed. Writes after a while, or removes the file where there is nothing to keep.
    void follow(bool isUnsaved);
    /// Goes on with a recovered file, which is the scene's own from now on. One that was kept before is removed.
    void adopt(std::unique_ptr<RecoveryFile> file);
    /// Gives the file away, with the changes until now in it; the scene that comes gets another one. Where they cannot be
    /// written, `failed` tells it, even if it did before: nobody tries again until the file is back and followed.
    /// @return null where there was nothing to keep; where it could not be written, what was kept before, which may be nothing
    std::unique_ptr<RecoveryFile> release();
    /// The changes are saved or not wanted: nothing is kept of them.
    void discard();

signals:
    /// The changes could not be kept, and why: the folder and the system's reason, or the scene's. Said once until it works
    /// again, and when the file is given away.
    void failed(const QString &reason);

private:
    void write();
    Kept keep();

    QString m_folder;
    AutosaveTiming m_timing;
    Source m_source;
    std::unique_ptr<RecoveryFile> m_file; ///< none while there is nothing to keep
    QTimer m_timer;
    QElapsedTimer m_sinceFirstChange; ///< of those that are not written; invalid without any
    bool m_isBehind = false;          ///< there are changes that are not in the file
    bool m_hasFailed = false;
};

} // namespace unprojector::gui
