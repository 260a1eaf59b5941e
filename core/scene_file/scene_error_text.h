#pragma once

#include "core/scene_file/scene_file_error.h"

#include <string>

namespace unprojector::scene_file {

/// One line that says what is wrong with a scene file, where, and what to do, in the language of tr(), UTF-8:
///
///   scene.json:3:7: , stands where a value is expected
///   scene.json: projection.near: 0 must be greater than 0
///
/// All other wording lives in the window or in the command line. This one is both's: a scene file is edited as text, and
/// its message copied from a terminal into an editor or a bug report. It names keys of the file, which are English.
std::string sceneErrorText(const SceneFileError &error);

} // namespace unprojector::scene_file
