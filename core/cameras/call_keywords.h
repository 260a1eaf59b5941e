#pragma once

#include "core/cameras/call_signature.h"

#include <string>

namespace unprojector::cameras {

/// What a call has wrong, thrown as a PasteError.
/// @param text  names the call
[[noreturn]] void failCall(std::string text);

/// Sorts the arguments of a call by their keywords: "fov=60" of Python, "fieldOfView: 1" of C#.
/// Drops PyBullet's physicsClientId, which names no number of a matrix.
/// Fails for an unknown keyword, and for an argument that is given twice.
/// @param[in,out] call  afterwards without keywords; an argument that is missing between others is
///         empty
void sortByKeyword(CallText &call, CallShape shape);

} // namespace unprojector::cameras
