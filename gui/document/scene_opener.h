#pragma once

#include "core/files/file_stamp.h"
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

/// Where a scene is from, and what it is called.
struct SceneOrigin {
    QString name;                               ///< as in a title
    std::filesystem::path file = {};            ///< absolute; empty: none
    std::optional<files::FileStamp> stamp = {}; ///< of the file when it was last read or written here
};

/// What is to be opened.
struct Opening {
    enum class Kind { NewScene, Addition, SceneFile };
    Kind kind = Kind::NewScene;
    SceneOrigin origin = {};                        ///< of a scene file; that of a recovered one may have no file
    scene_file::SceneFile contents = {};            ///< of a scene file
    const RecoveryFile *recovered = nullptr;        ///< what the scene is recovered from
    std::vector<std::filesystem::path> models = {}; ///< those of a scene file follow from its contents
    QStringList notes = {};                         ///< what of the scene file is not kept
    std::vector<std::filesystem::path> landmarkFiles =
        {}; ///< files of them and templates, for who has shown the models
};

/// What was opened, to be shown.
struct Opened {
    Opening opening;
    std::vector<scene::SceneObject> objects = {}; ///< of the models that could be read, unless they are a scene file's
    std::optional<scene::Scene> scene = {};       ///< of a scene file; nothing where a part of it could not be read
    QStringList errors = {};                      ///< why parts could not be read
    QStringList notes = {};                       ///< import notes
};

/// From now on the working folder does not matter.
std::filesystem::path absolutePath(const std::filesystem::path &file);
/// "a.obj and 2 more"
QString namesText(const QString &first, int others);

/// Reads scenes and models, these on a thread of its own, one opening at a time. It changes nothing that is shown.
class SceneOpener : public QObject {
    Q_OBJECT
public:
    /// Reads a scene file, without its models.
    /// @return why it cannot be read or shown
    static geometry::Result<Opening, QString> readScene(const std::filesystem::path &file);

    /// Starts reading the models, one file after the other; a model that is in use already is not read again. An opening that is
    /// under way is cancelled.
    void load(Opening asked);
    /// Ends the opening that is under way: `ended` comes before this returns, nothing of it comes after.
    void cancel();
    bool isLoading() const { return m_background.isRunning(); }
    /// As a title would call what is being opened.
    /// @pre isLoading()
    QString name() const;

signals:
    void started();
    /// @param share  of all files, in [0, 1]
    void progressed(const QString &fileName, double share);
    /// Also where nothing could be read.
    void opened(const unprojector::gui::Opened &opened);
    /// An opening has ended, in whatever way.
    void ended();

private:
    opening::ModelFiles m_modelFiles;
    Opening m_opening;          ///< while it loads
    Background m_background{2}; ///< the next need not wait for the cancelled one
};

} // namespace unprojector::gui
