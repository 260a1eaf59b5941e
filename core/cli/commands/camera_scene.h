#pragma once

#include "core/cli/commands/camera_texts.h"
#include "core/cli/commands/scene_command.h"
#include "core/geometry/box.h"
#include "core/scene_file/scene_file.h"

#include <optional>

namespace unprojector::cli {

/// Adds the objects of --objects to a scene, and their files to the inputs.
/// @return their bounds, empty without objects; nothing if a file cannot be read
std::optional<geometry::Box> addObjects(const SceneOptions &options, InputFiles &inputs, scene_file::SceneFile &scene);

/// Writes a scene after the reader has accepted it: that checks a scene's limits. Errors are
/// printed on stderr.
ExitCode writeScene(const SceneOptions &options, const InputFiles &inputs, const scene_file::SceneFile &scene);

/// Makes a scene from another program's camera. Assumptions and errors are printed on stderr.
/// @return nothing if the texts have no known program's form
std::optional<ExitCode> runCameraScene(const SceneOptions &options, const GivenTexts &given);

} // namespace unprojector::cli
