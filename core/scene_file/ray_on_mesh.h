#pragma once

#include "core/ray/scene_hit.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace unprojector::scene_file {

/// What the ray of a click meets on the meshes themselves, as `unproject pick --json` prints it, and clicks have it.
///
/// JSON: {"hit": false}, or "hit", "object" (its name), "triangle", "barycentric", "world", "objectPoint", "normal",
/// "distance", "vertex" ("id", "world", "distance"), "edge" ("ids", "world", "distance") and "uncertainty". Of a point of a
/// cloud, what only a triangle has is null; so is a number that is not finite.
struct RayOnMesh {
    std::optional<ray::SceneHit> hit;
    std::string object; ///< UTF-8, where something is hit
};

nlohmann::ordered_json jsonOf(const RayOnMesh &ray);

} // namespace unprojector::scene_file
