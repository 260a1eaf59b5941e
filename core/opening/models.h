#pragma once

#include "core/mesh/import/mesh_import.h"
#include "core/scene_file/scene_file.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

/// Decides how a file is opened, and provides the models of a scene: shared by the window, the
/// command and the lessons.
namespace unprojector::opening {

using ModelPointer = std::shared_ptr<const mesh::Model>;
using ReadModel = base::Expected<ModelPointer, base::Error>;

/// A cache of the models in use, one per file. It keeps no model alive. All functions may be called
/// from any thread.
class ModelFiles {
public:
    /// The model of a file: from the cache, unless the file's size or time has changed since it was
    /// read; else imported.
    /// @param progress  may be empty
    /// @param prepare   called with an imported model; returning false cancels; may be empty
    /// @return the errors of importModel; Stopped; OutOfMemory too if `prepare` throws std::bad_alloc
    ReadModel read(const std::filesystem::path &file, const base::Progress &progress = {},
                   const std::function<bool(mesh::Model &)> &prepare = {});

private:
    /// The size and time of a file, which reveal a change without reading it.
    struct State {
        bool isKnown = false;
        std::uintmax_t size = 0;
        std::filesystem::file_time_type time;
        friend bool operator==(const State &, const State &) = default;
    };
    struct Kept {
        State state;
        std::weak_ptr<const mesh::Model> model;
    };
    static State stateOf(const std::filesystem::path &file);

    std::mutex m_mutex; ///< guards the members below
    std::map<std::filesystem::path, Kept> m_files;
    std::size_t m_sizeOfNextCleaning = 1; ///< of m_files, when it loses the models that nothing uses
};

/// Returns whether to open a file as a scene rather than as a model. True for a scene, and for any
/// name that ends in .json, even with unrecognizable contents; the error of reading it then
/// explains the problem.
bool isMeantAsScene(const std::filesystem::path &file);

/// The files of a scene's models, each once, in the order of the objects.
/// @param sceneFile  the file that the scene was read from
std::vector<std::filesystem::path> modelFiles(const scene_file::SceneFile &scene,
                                              const std::filesystem::path &sceneFile);

/// Returns a scene's objects with their models: the bundled ones by name, the others from `read`,
/// which is called once per file.
/// @param sceneFile  as above
/// @return the error of the first model that cannot be read; its subject is the object's name
base::Expected<std::vector<scene::SceneObject>, base::Error>
objectsOf(const scene_file::SceneFile &scene, const std::filesystem::path &sceneFile,
          const std::function<ReadModel(const std::filesystem::path &file)> &read);

} // namespace unprojector::opening
