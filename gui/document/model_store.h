#pragma once

#include "core/scene/scene.h"
#include "gui/document/background.h"

#include <QObject>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace unprojector::gui {
using namespace scene;

/// The models that are in use, one a file, and what is made of them beside the window's work: a coarse stand-in of each
/// that is too large to be drawn while the view moves. It keeps no model alive.
class ModelStore : public QObject {
    Q_OBJECT
public:
    /// Objects with more triangles and points than this, all together, are drawn by their stand-ins while the view moves.
    static constexpr std::size_t kMostInMotion = 100'000;

    /// By which a change of a file is seen without reading it.
    struct FileState {
        std::uintmax_t size = 0;
        std::filesystem::file_time_type time;
        friend bool operator==(const FileState &, const FileState &) = default;
    };
    /// Nothing where there is no such file.
    static std::optional<FileState> stateOf(const std::filesystem::path &file);

    explicit ModelStore(QObject *parent = nullptr);

    /// The model that was read from a file; null where nobody has it any more, or where the file has changed since.
    std::shared_ptr<const Model> find(const std::filesystem::path &file) const;
    /// Remembers what was read from a file.
    /// @param state  of the file before it was read: what changes in between is seen as a change
    void keep(const std::filesystem::path &file, const std::optional<FileState> &state,
              const std::shared_ptr<const Model> &model);

    /// Begins to make the stand-ins of these objects' models, where together they are too large; `standInReady` tells of
    /// each.
    void makeStandIns(const std::vector<SceneObject> &objects);
    /// The objects with stand-ins for the models that are too large.
    /// @return nothing where the objects are few enough to be drawn themselves, or a stand-in is not made yet
    std::optional<std::vector<SceneObject>> standInsFor(const std::vector<SceneObject> &objects) const;
    /// Whether objects are too large to be drawn while the view moves.
    static bool areLarge(const std::vector<SceneObject> &objects);

signals:
    void standInReady();
    /// A stand-in could not be made, and why; its model is drawn itself.
    void jobFailed(const unprojector::gui::JobFailure &failure);

private:
    struct Kept {
        FileState state;
        std::weak_ptr<const Model> model;
    };
    struct StandIn {
        std::weak_ptr<const Model> model;     ///< an address alone may be another's by now
        std::shared_ptr<const Model> standIn; ///< null while it is being made, and where it could not be made
    };

    const StandIn *standInOf(const std::shared_ptr<const Model> &model) const;
    void dropUnused();

    std::map<std::filesystem::path, Kept> m_files;
    std::map<const Model *, StandIn> m_standIns;
    Background m_background;
};

} // namespace unprojector::gui
