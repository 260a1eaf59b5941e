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

/// A scene, or a model as the window shows it at first, with all models read.
struct OpenedScene {
    std::vector<scene::SceneObject> objects;
    std::optional<scene_file::SceneFile> file; ///< nothing where a model was opened
    std::string name;                          ///< what was opened, for messages
    InputFiles files;                          ///< all that was read: the scene, the models, and what these refer to
};

/// A model's file and those that were read for it.
InputFiles filesOf(const std::filesystem::path &file, const mesh::Model &model);

/// As opening::isMeantAsScene.
/// @param file  UTF-8; "-" is a scene
bool isMeantAsScene(const std::string &file);

/// Opens a model file, a scene file or clicks on one scene; prints errors on stderr. Models are read once a file.
/// @param file  UTF-8; "-" is a scene from standard input
std::optional<OpenedScene> openScene(const std::string &file);

/// Whether all objects lie where they can be computed with; of the first that does not, stderr says why.
bool areReachable(const OpenedScene &opened);

/// What the clicks on a picture of the scene meet. Objects of one model share its ray caster.
ray::SceneRays raysOf(const OpenedScene &opened, const unproject::Unprojector &unprojector);

/// The size of a window whose size nobody has given.
constexpr int kUsualWidth = 800, kUsualHeight = 600;

/// The picture of an opened scene: of a scene file its own, to the last digit; of a model what the window starts with. With
/// a size, what the window shows in that size.
/// @param size  device pixels; "800x600", or empty
/// Errors are printed on stderr.
std::optional<geometry::Setup> setupOf(const OpenedScene &opened, const std::string &size);

} // namespace unprojector::cli
