#pragma once

#include "core/cli/rows/byte_stream.h"
#include "core/scene_file/clicks.h"
#include "core/unproject/batch/batch_unproject.h"
#include "core/unproject/unprojector.h"

#include <glm/mat4x4.hpp>

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {
using namespace unproject;
using namespace scene_file;

/// Reads a scene file, or the clicks that the window prints; prints errors on stderr.
/// @param file  UTF-8; "-" for stdin
std::optional<SceneOrClicks> sceneOrClicks(const std::string &file);

/// The file itself, and those of the models that its scenes name, whether they are read or not.
/// @param file  as above
InputFiles filesOf(const SceneOrClicks &given, const std::string &file);

/// The scene of a file, or the one that all its clicks show. Errors are printed on stderr. Models are not loaded, see openScene.
std::optional<SceneFile> sceneOf(const SceneOrClicks &given, const std::string &file);
std::optional<SceneFile> readScene(const std::string &file);

/// What --space says: eye, world or object:NAME. Errors are printed on stderr.
std::optional<BatchSpace> batchSpace(const std::string &space, const SceneFile &scene);

} // namespace unprojector::cli
