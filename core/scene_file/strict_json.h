#pragma once

#include "core/scene_file/scene_file_error.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace unprojector::scene_file {

/// A JSON document of a size and depth that can do no harm, with no key twice in an object and no number beyond the
/// range of doubles. The library's own parser would keep the last of two equal keys, and takes time quadratic in their
/// number.
/// @return EmptyFile, Syntax, NumberTooLarge, TooDeep, DuplicateKey, each with line and column; TooLarge
geometry::Result<nlohmann::ordered_json, SceneFileError> parseStrictJson(std::string_view text);
/// The same of a document that may have other than kMostSceneBytes.
geometry::Result<nlohmann::ordered_json, SceneFileError> parseStrictJson(std::string_view text, std::size_t mostBytes);

/// At most `most` bytes of a text, not cut inside a character; "…" at the end where something is missing.
std::string shortened(std::string_view text, std::size_t most = 60);

} // namespace unprojector::scene_file
