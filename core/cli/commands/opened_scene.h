#pragma once

#include "core/cli/rows/byte_stream.h"
#include "core/ray/scene_rays.h"
#include "core/scene/scene.h"
#include "core/scene_file/scene_file.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {

/// A scene, or a model as the window shows it on opening, with all models read.
struct OpenedScene {
    std::vector<scene::SceneObject> objects;
    std::optional<scene_file::SceneFile> file; ///< empty where a model was opened
    std::string name;                          ///< what was opened, for messages
    InputFiles files;                          ///< all files read: the scene, the models, and the files these name
};

/// A model's file and the files that the model names.
InputFiles filesOf(const std::filesystem::path &file, const mesh::Model &model);

/// True if a file is meant as a scene, see opening::isMeantAsScene.
/// @param file  UTF-8; "-" is a scene
bool isMeantAsScene(const std::string &file);

/// Opens a model file, a scene file, or clicks on one scene; prints errors on stderr. Reads each
/// model file once.
/// @param file  UTF-8; "-" is a scene from standard input
std::optional<OpenedScene> openScene(const std::string &file);

/// True if all objects lie within the range of computation. Otherwise stderr names the first that
/// does not, with the reason.
bool areReachable(const OpenedScene &opened);

/// The ray casters for clicks on a view of the scene. Objects of one model share its ray caster.
ray::SceneRays raysOf(const OpenedScene &opened, const unproject::Unprojector &unprojector);

/// The window size where none is given.
constexpr int kUsualWidth = 800, kUsualHeight = 600;

/// The setup of an opened scene: a scene file's own, unchanged to the last digit; for a model, the
/// window's setup on opening. With a size, the setup that the window uses at that size. Errors are
/// printed on stderr.
/// @param size  device pixels; "800x600", or empty
std::optional<geometry::Setup> setupOf(const OpenedScene &opened, const std::string &size);

} // namespace unprojector::cli
