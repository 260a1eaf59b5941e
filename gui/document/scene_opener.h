#pragma once

#include "core/base/file_stamp.h"
#include "core/opening/models.h"
#include "core/scene_file/scene_file.h"
#include "gui/document/background.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <filesystem>
#include <optional>
#include <vector>

namespace unprojector::gui {

class RecoveryFile;

/// The origin of a scene, and its title.
struct SceneOrigin {
    QString name;                              ///< as in a title
    std::filesystem::path file = {};           ///< absolute; empty: none
    std::optional<base::FileStamp> stamp = {}; ///< of the file at the last read or write by this program
};

/// A request to open.
struct Opening {
    enum class Kind { NewScene, Addition, SceneFile };
    Kind kind = Kind::NewScene;
    SceneOrigin origin = {};                        ///< of a scene file; a recovered scene may have no file
    scene_file::SceneFile contents = {};            ///< of a scene file
    const RecoveryFile *recovered = nullptr;        ///< the recovery file, if any
    std::vector<std::filesystem::path> models = {}; ///< a scene file names its own in its contents
    QStringList notes = {};                         ///< import notes of the scene file
    std::vector<std::filesystem::path> landmarkFiles =
        {}; ///< landmark files and templates, passed on after the models are shown
};

/// The result of opening, to be shown.
struct Opened {
    Opening opening;
    std::vector<scene::SceneObject> objects = {}; ///< of the models that could be read, unless a scene file names them
    std::optional<scene::Scene> scene = {};       ///< of a scene file; nothing if a part of it could not be read
    QStringList errors = {};                      ///< why parts could not be read
    QStringList notes = {};                       ///< import notes
};

/// The path made absolute, independent of the working folder.
std::filesystem::path absolutePath(const std::filesystem::path &file);
/// "a.obj and 2 more"
QString namesText(const QString &first, int others);

/// Reads scenes, and models on a separate thread, one opening at a time. It changes nothing that is
/// shown.
class SceneOpener : public QObject {
    Q_OBJECT
public:
    /// Reads a scene file, without its models.
    /// @return the reason if it cannot be read or shown
    static geometry::Result<Opening, QString> readScene(const std::filesystem::path &file);

    /// Starts reading the models, one file after the other; reuses models in memory. Cancels an
    /// opening that is under way.
    void load(Opening asked);
    /// Cancels the opening under way: emits `ended` before it returns, and nothing after.
    void cancel();
    bool isLoading() const { return m_background.isRunning(); }
    /// The title of what is being opened.
    /// @pre isLoading()
    QString name() const;

signals:
    void started();
    /// @param share  of all files, in [0, 1]
    void progressed(const QString &fileName, double share);
    /// Emitted also if nothing could be read.
    void opened(const unprojector::gui::Opened &opened);
    /// Emitted when an opening has ended, in any way.
    void ended();

private:
    opening::ModelFiles m_modelFiles;
    Opening m_opening;          ///< while it loads
    Background m_background{2}; ///< the next one need not wait for a cancelled one
};

} // namespace unprojector::gui
