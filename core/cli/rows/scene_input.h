#pragma once

#include "core/cli/rows/row_table.h"
#include "core/scene_file/clicks.h"
#include "core/unproject/batch/batch_unproject.h"
#include "core/unproject/unprojector.h"

#include <glm/mat4x4.hpp>

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {

/// Reads a scene file, or the clicks that the window prints. Prints errors on stderr.
/// @param file  UTF-8; "-" for stdin
std::optional<scene_file::SceneOrClicks> sceneOrClicks(const std::string &file);

/// The file itself, and the models that its scenes name, whether read or not.
/// @param file  as above
InputFiles filesOf(const scene_file::SceneOrClicks &given, const std::string &file);

/// The scene of a file, or the one that all its clicks share. Errors are printed on stderr. Models
/// are not loaded, see openScene.
std::optional<scene_file::SceneFile> sceneOf(const scene_file::SceneOrClicks &given, const std::string &file);
std::optional<scene_file::SceneFile> readScene(const std::string &file);

/// The setup of the rows' scene, and the space in it.
struct RowScene {
    geometry::Setup setup;
    unproject::BatchSpace space;
    InputFiles inputs; ///< the scene's files and the rows' file
};
/// Prints errors on stderr.
/// @param given  the content of options.scene
std::optional<RowScene> rowScene(const scene_file::SceneOrClicks &given, const RowOptions &options);

/// Parses --space: eye, world or object:NAME. Errors are printed on stderr.
std::optional<unproject::BatchSpace> batchSpace(const std::string &space, const scene_file::SceneFile &scene);

} // namespace unprojector::cli
