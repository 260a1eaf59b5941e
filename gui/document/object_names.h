#pragma once

#include "core/scene/scene.h"

#include <QString>

#include <cstddef>
#include <string>
#include <vector>

namespace unprojector::gui {

// Objects are told apart by their names, in lists and by the `unproject` command.

/// What is wrong with a name for an object.
enum class NameFault { None, Empty, Taken };

/// Taken is also the name that another one is read by, see readName: two lines of a list never look the same.
/// @param index  of the object that is to have the name
NameFault faultOf(const std::string &name, std::size_t index, const std::vector<scene::SceneObject> &objects);

/// As a line of the window has it: one line, and not as long as a file may make it.
QString shownName(const std::string &name);

/// The same of an object as it is read, see readName.
QString shownObjectName(const std::string &name, const std::vector<scene::SceneObject> &objects);

/// The name, or the name with the first number behind it that makes it another one than those of the objects: "cube (2)".
std::string freeName(const std::string &name, const std::vector<scene::SceneObject> &objects);

} // namespace unprojector::gui
