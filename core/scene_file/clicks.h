#pragma once

#include "core/scene_file/ray_on_mesh.h"
#include "core/scene_file/scene_file.h"
#include "core/unproject/pick.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace unprojector::scene_file {

/// A point by each of kMethods, in their order; nothing where a method has no answer.
using ClickPoint = std::array<std::optional<glm::dvec3>, unproject::kMethods.size()>;

/// Where a click is in one space: on a surface a point, on the background the ends of its ray.
struct ClickPlace {
    ClickPoint surface;
    ClickPoint rayNear, rayFar;
};

/// How far each coordinate can be off, see Pick::uncertainty.
struct ClickUncertainty {
    glm::dvec3 eye{0.0}, world{0.0};
};

struct ClickedObject {
    std::size_t index = 0; ///< in the scene's list
    std::string name;      ///< UTF-8
    ClickPoint point;      ///< object space
};

/// A click as scripts read it, with all that is needed to compute it again.
///
/// JSON: "widget", "devicePixel", "window", "hit", "eye", "world", "uncertainty", "object", "rayOnMesh", "scene". On a surface eye and world are
/// {"formula": [x, y, z], "matrix": [x, y, z], …}, one key a method, and object has "index", "name" and the same keys for
/// its own coordinates; on the background eye and world are {"near": {…}, "far": {…}}, the ends of the ray in that form,
/// and object is null. A method without an answer is null. "uncertainty" is how far each coordinate of the point can be off,
/// {"eye": [x, y, z], "world": [x, y, z]}, on a surface only. "rayOnMesh" is what the ray through the pixel's centre meets on the
/// meshes, see RayOnMesh; it is left out where nobody has asked, and not read. "scene" is a whole scene file, see SceneFile. Only "window" and
/// "scene" are needed to compute a click again; "hit" is true where it is left out.
struct Click {
    geometry::WidgetPoint widget;
    geometry::DevicePixel devicePixel;
    geometry::WindowPoint window; ///< the pixel's centre, with the depth as read
    bool hit = true;
    ClickPlace eye, world;
    std::optional<ClickUncertainty> uncertainty; ///< none on the background, and where a file has none
    std::optional<ClickedObject> object;         ///< none on the background
    std::optional<RayOnMesh> rayOnMesh = {};
    SceneFile scene;
};

/// What to write for a click. Its scene has the numbers of the picture as they were, the objects with absolute paths, and
/// nothing that would make the window choose other numbers.
/// @param scene  as it was at the click
/// @param ray    what its ray meets; nothing where that is not known
Click clickOf(const unproject::Pick &pick, const scene::Scene &scene, std::optional<RayOnMesh> ray = {});

/// Clicks as a JSON array. Numbers have all their digits: parseSceneOrClicks gives the same ones back.
/// @return NotUtf8
geometry::Result<std::string, SceneFileError> clicksText(const std::vector<Click> &clicks);

using SceneOrClicks = std::variant<SceneFile, std::vector<Click>>;

/// Reads a scene file, or clicks: an array of them, or a single one, which is told by its "scene".
/// @return as parseScene
geometry::Result<SceneOrClicks, SceneFileError> parseSceneOrClicks(std::string_view text, const std::string &name);

} // namespace unprojector::scene_file
