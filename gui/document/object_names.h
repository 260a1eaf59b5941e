#pragma once

#include "core/scene/scene.h"

#include <QString>

#include <cstddef>
#include <string>
#include <vector>

namespace unprojector::gui {

// Names identify objects, in lists and in the `unproject` command.

/// The ways in which an object name can be invalid.
enum class NameFault { None, Empty, Taken };

/// The fault of a name. Taken includes the name by which another object is read (readName): two
/// lines of a list never look the same.
/// @param index  of the object that is to have the name
NameFault faultOf(const std::string &name, std::size_t index, const std::vector<scene::SceneObject> &objects);

/// The name as one line of text, cut if it is too long for the window.
QString shownName(const std::string &name);

/// The same for an object name in its translated form (readName).
QString shownObjectName(const std::string &name, const std::vector<scene::SceneObject> &objects);

/// The name, with the first number appended that makes it unique among the objects if needed: "cube
/// (2)".
std::string freeName(const std::string &name, const std::vector<scene::SceneObject> &objects);

} // namespace unprojector::gui
