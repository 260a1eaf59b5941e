#pragma once

#include "core/scene_file/scene_file_error.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace unprojector::scene_file {

/// Parses a JSON document safely: limits its size and depth, and rejects duplicate keys and numbers
/// beyond the range of doubles. The library's own parser would keep the last of two equal keys, and
/// takes time quadratic in their number.
/// @return EmptyFile, Syntax, NumberTooLarge, TooDeep, DuplicateKey, each with line and column;
///         TooLarge
geometry::Result<nlohmann::ordered_json, SceneFileError> parseStrictJson(std::string_view text);
/// The same with another size limit than kMostSceneBytes.
geometry::Result<nlohmann::ordered_json, SceneFileError> parseStrictJson(std::string_view text, std::size_t mostBytes);

/// Shortens a text to at most `most` bytes, at a character boundary, with "…" at the end if
/// anything was cut.
std::string shortened(std::string_view text, std::size_t most = 60);

} // namespace unprojector::scene_file
