#pragma once

#include "core/cli/rows/row_table.h"
#include "core/scene_file/clicks.h"
#include "core/unproject/batch/batch_unproject.h"
#include "core/unproject/unprojector.h"

#include <glm/mat4x4.hpp>

#include <string>
#include <vector>

// Unusable input is refused.

namespace unprojector::cli {

/// Reads a scene file, or the clicks that the window prints.
/// @param file  UTF-8; "-" for stdin
scene_file::SceneOrClicks sceneOrClicks(const std::string &file);

/// The file itself, and the models that its scenes name, whether read or not.
/// @param file  as above
InputFiles filesOf(const scene_file::SceneOrClicks &given, const std::string &file);

/// The scene of a file, or the one that all its clicks share. Models are not loaded, see openScene.
scene_file::SceneFile sceneOf(const scene_file::SceneOrClicks &given, const std::string &file);
scene_file::SceneFile readScene(const std::string &file);

/// The setup of the rows' scene, and the space in it.
struct RowScene {
    geometry::Setup setup;
    unproject::BatchSpace space;
    InputFiles inputs; ///< the scene's files and the rows' file
};
/// @param given  the content of options.scene
RowScene rowScene(const scene_file::SceneOrClicks &given, const RowOptions &options);

/// Parses --space: eye, world or object:NAME.
unproject::BatchSpace batchSpace(const std::string &space, const scene_file::SceneFile &scene);

} // namespace unprojector::cli
