#pragma once

#include "core/matrices/call_signature.h"
#include "core/matrices/pasted_matrix.h"

#include <optional>
#include <string>
#include <vector>

namespace unprojector::matrices {

/// The fault of a keyword.
struct KeywordFault {
    CallFault fault;
    std::string keyword; ///< as written
};

/// Sorts the arguments of a call by their keywords: "fov=60" of Python, "fieldOfView: 1" of C#.
/// Drops PyBullet's physicsClientId, which names no number of a matrix.
/// @param[in,out] arguments  afterwards without keywords; an argument that is missing between
///         others is empty
/// @return UnknownKeyword, or RepeatedKeyword for an argument that is given twice
std::optional<KeywordFault> sortByKeyword(std::vector<std::string> &arguments, CallShape shape);

} // namespace unprojector::matrices
