#pragma once

#include "core/mesh/import/mesh_import.h"
#include "core/scene_file/scene_file.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

/// What a file is opened as, and where the models of a scene come from: the same for the window, the command and the lessons.
namespace unprojector::opening {

using ModelPointer = std::shared_ptr<const mesh::Model>;
using ReadModel = geometry::Result<ModelPointer, mesh::ImportError>;

/// The models that are in use, one a file. It keeps no model alive. All its functions are for any thread.
class ModelFiles {
public:
    /// The model of a file: the one in use, unless the file's size or time has changed since it was read; else it is read.
    /// @param progress  may be empty
    /// @param prepare   called with a model that was just read; returning false cancels; may be empty
    /// @return the errors of importModel; Cancelled; OutOfMemory where `prepare` throws std::bad_alloc
    ReadModel read(const std::filesystem::path &file, const mesh::ImportProgress &progress = {},
                   const std::function<bool(mesh::Model &)> &prepare = {});

private:
    /// By which a change of a file is seen without reading it.
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

    std::mutex m_mutex; ///< of m_files
    std::map<std::filesystem::path, Kept> m_files;
};

/// Whether a file is to be opened as a scene and not as a model: it is one, or its name ends in .json, even where the contents
/// are beyond recognition. The error of reading it then says why.
bool isMeantAsScene(const std::filesystem::path &file);

/// The files of a scene's models, each once, in the order of the objects.
/// @param sceneFile  the file that the scene was read from
std::vector<std::filesystem::path> modelFiles(const scene_file::SceneFile &scene,
                                              const std::filesystem::path &sceneFile);

/// A scene's objects with their models: the bundled ones by name, the others by `read`, which is asked once a file.
/// @param sceneFile  as above
/// @return what is wrong with the first model that cannot be had, in the language of text::tr()
geometry::Result<std::vector<scene::SceneObject>, std::string>
objectsOf(const scene_file::SceneFile &scene, const std::filesystem::path &sceneFile,
          const std::function<ReadModel(const std::filesystem::path &file)> &read);

} // namespace unprojector::opening
