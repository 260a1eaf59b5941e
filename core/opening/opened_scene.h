#pragma once

#include "core/mesh/import/mesh_import.h"
#include "core/opening/models.h"
#include "core/ray/scene_rays.h"
#include "core/scene/scene.h"
#include "core/scene_file/scene_file.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::opening {

/// A scene, or a model as the window shows it on opening, with all models read.
struct OpenedScene {
    std::vector<scene::SceneObject> objects;
    std::optional<scene_file::SceneFile> file; ///< empty where a model was opened
    std::string name;                          ///< what was opened, for messages
    std::vector<std::string> files; ///< all files read, UTF-8: the scene, the models, and the files these name
};

/// A model's file and the files that the model names, UTF-8.
std::vector<std::string> filesOf(const std::filesystem::path &file, const mesh::Model &model);

/// Opens a model, a scene file, or clicks on one scene.
base::Expected<OpenedScene, base::Error> open(const std::filesystem::path &file);

/// Opens the text of a scene file, or of clicks on one scene.
/// @param path, name  as in withModels
base::Expected<OpenedScene, base::Error> openText(std::string_view text, const std::filesystem::path &path,
                                                  const std::string &name);

/// Reads the models of a scene, each file once.
/// @param path  the scene's file, which the models' paths are relative to; empty: standard input
/// @param name  of the scene, for messages
base::Expected<OpenedScene, base::Error> withModels(scene_file::SceneFile scene, const std::filesystem::path &path,
                                                    const std::string &name);

/// The first object that does not lie within the range of computation; empty: all do.
std::optional<base::Error> unreachable(const OpenedScene &opened);

/// The ray casters of the objects: null for hidden ones. Objects of one model share its caster.
std::vector<std::shared_ptr<const ray::RayCaster>> castersOf(const std::vector<scene::SceneObject> &objects);

/// The ray casters for clicks on a view of the scene.
ray::SceneRays raysOf(const OpenedScene &opened, const unproject::Unprojector &unprojector);

/// The window size where none is given.
constexpr int kUsualWidth = 800, kUsualHeight = 600;

/// The setup of an opened scene: a scene file's own, unchanged to the last digit; for a model, the
/// window's setup on opening. With a size, the setup that the window uses at that size.
/// @param size  device pixels; its ratio is not used
/// @pre check(*size)
base::Expected<geometry::Setup, base::Error> setupOf(const OpenedScene &opened,
                                                     const std::optional<geometry::Surface> &size);

} // namespace unprojector::opening
