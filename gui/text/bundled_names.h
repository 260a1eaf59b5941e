#pragma once

#include "core/scene/scene.h"

#include <QString>

#include <string>
#include <vector>

namespace unprojector::gui {

/// What objects that come with the program are called in the language that it speaks, numbered or not ("Cube (2)"); any
/// other name is left as it is. Scenes and their files know them by the English one, and so are the same in all
/// languages.
QString readName(const std::string &name);

/// The name of an object as the user reads it. One of a file has its own: it is called so in every table and by the
/// `unproject` command. So has one of the program where another object bears its name in this language, given in
/// another one: two lines of a list never look the same.
/// @param name  of one of the objects; any other is left as it is
QString readName(const std::string &name, const std::vector<scene::SceneObject> &objects);

} // namespace unprojector::gui
