#pragma once

#include "core/scene_file/scene_file_error.h"

#include <string>

namespace unprojector::scene_file {

/// Describes an error of a scene file in one line: the problem, its position, and the remedy. In
/// the language of tr(), UTF-8:
///
///   scene.json:3:7: , stands where a value is expected
///   scene.json: projection.near: 0 must be greater than 0
///
/// Other messages are worded in the window or the command line. Both share this one: people edit
/// scene files as text, and copy messages from a terminal into an editor or a bug report. It names
/// keys of the file, which are English.
std::string sceneErrorText(const SceneFileError &error);

} // namespace unprojector::scene_file
