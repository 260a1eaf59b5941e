#pragma once

#include "core/base/json.h"
#include "core/ray/pixel_edge.h"

#include <optional>
#include <string>

namespace unprojector::scene_file {

/// The hit of a click's ray on the meshes, as `unproject pick --json` prints it and clicks contain
/// it.
///
/// JSON: {"hit": false}, or "hit", "object" (its name), "triangle", "barycentric", "world",
/// "objectPoint", "normal", "distance", "vertex" ("id", "world", "distance"), "edge" ("ids",
/// "world", "distance") and "uncertainty". For a point of a cloud, keys that only apply to
/// triangles are null. Numbers that are not finite are null too.
///
/// If an occluding edge crosses the pixel, "pixelEdge" tells the other side: "object" (null: the
/// background) and "behind" (null on the background), see PixelEdge.
struct RayOnMesh {
    std::optional<ray::SceneHit> hit;
    std::string object; ///< UTF-8, of the hit object
    std::optional<ray::PixelEdge> edge = {};
    std::string edgeObject = {}; ///< of the edge's other side
};

base::Json jsonOf(const RayOnMesh &ray);

} // namespace unprojector::scene_file
