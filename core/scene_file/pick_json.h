#pragma once

#include "core/unproject/pick.h"

#include <nlohmann/json.hpp>

namespace unprojector::scene_file {
using namespace unproject;

/// A click as scripts read it: "widget", "devicePixel", "window", "hit", "eye", "world", and "scene", which holds what
/// is needed to compute it again. On a surface eye and world are one point for each of kMethods, {"formula": [x, y, z], …}; on the
/// background each is {"near": {…}, "far": {…}}, the ends of the ray in that form. A method without an answer is null.
/// Keys keep this order; doubles have all their digits.
nlohmann::ordered_json toJson(const Pick &pick);

/// "window" (logical pixels), "viewport" (device pixels, origin bottom-left), "projection", "view"; "depthRange"
/// where it is not [0, 1]. A Perspective is written as its frustum, whose edges are
/// rounded to doubles: the formulas with those edges may differ by units in the last place.
nlohmann::ordered_json toJson(const Picture &geometry);

} // namespace unprojector::scene_file
