#pragma once

#include "core/cli/rows/byte_stream.h"
#include "core/opening/opened_scene.h"

#include <optional>
#include <string>

namespace unprojector::cli {

using opening::filesOf;
using opening::OpenedScene;
using opening::raysOf;

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

/// The setup of an opened scene, see opening::setupOf. Errors are printed on stderr.
/// @param size  device pixels; "800x600", or empty
std::optional<geometry::Setup> setupOf(const OpenedScene &opened, const std::string &size);

} // namespace unprojector::cli
