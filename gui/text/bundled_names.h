#pragma once

#include "core/scene/scene.h"

#include <QString>

#include <string>
#include <vector>

namespace unprojector::gui {

/// The translated name of a bundled object, numbered or not ("Cube (2)"); any other name unchanged.
/// Scenes and their files contain the English name, and so are the same in all languages.
QString readName(const std::string &name);

/// The name of an object as the user reads it. A file's object keeps its own name, in every table
/// and in the `unproject` command. So does a bundled object if another one already has its
/// translated name: two lines of a list never look the same.
/// @param name  of one of the objects; any other is returned unchanged
QString readName(const std::string &name, const std::vector<scene::SceneObject> &objects);

} // namespace unprojector::gui
