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

/// A point by each of kMethods, in their order; nothing if a method has no answer.
using ClickPoint = std::array<std::optional<glm::dvec3>, unproject::kMethods.size()>;

/// The result of a click in one space: a point on a surface, the ends of its ray on the background.
struct ClickPlace {
    ClickPoint surface;
    ClickPoint rayNear, rayFar;
};

/// The uncertainty of each coordinate, see Pick::uncertainty.
struct ClickUncertainty {
    glm::dvec3 eye{0.0}, world{0.0};
};

struct ClickedObject {
    std::size_t index = 0; ///< in the scene's list
    std::string name;      ///< UTF-8
    ClickPoint point;      ///< object space
};

/// A click for scripts, with all that is needed to recompute it.
///
/// JSON: "widget", "devicePixel", "window", "hit", "eye", "world", "uncertainty", "object",
/// "rayOnMesh", "scene". Only "window" and "scene" are needed to recompute a click; "hit" defaults
/// to true.
///
/// - On a surface, eye and world are {"formula": [x, y, z], "matrix": [x, y, z], …}, one key a
///   method. object has "index", "name" and the same keys for its own coordinates.
/// - On the background, eye and world are {"near": {…}, "far": {…}}, the ends of the ray in that
///   form, and object is null.
/// - A method without an answer is null.
/// - "uncertainty" is the uncertainty of each coordinate of the point, {"eye": [x, y, z], "world":
///   [x, y, z]}, on a surface only.
/// - "rayOnMesh" is the hit of the pixel centre's ray on the meshes, see RayOnMesh. It is written
///   only on request, and never read.
/// - "scene" is a whole scene file, see SceneFile.
struct Click {
    geometry::WidgetPoint widget;
    geometry::DevicePixel devicePixel;
    geometry::WindowPoint window; ///< the pixel's centre, with the depth as read
    bool hit = true;
    ClickPlace eye, world;
    std::optional<ClickUncertainty> uncertainty; ///< none on the background, and if a file has none
    std::optional<ClickedObject> object;         ///< none on the background
    std::optional<RayOnMesh> rayOnMesh = {};
    SceneFile scene;
};

/// The click to write for a pick. Its scene has the numbers of the setup at the click and objects
/// with absolute paths. It omits all settings that would make the window choose other numbers.
/// @param scene  as it was at the click
/// @param ray    the hit of its ray; nothing if unknown
Click clickOf(const unproject::Pick &pick, const scene::Scene &scene, std::optional<RayOnMesh> ray = {});

/// The clicks as a JSON array. Numbers have all their digits, so parseSceneOrClicks restores them
/// exactly.
/// @return as sceneText
base::Expected<std::string, base::Error> clicksText(const std::vector<Click> &clicks);

using SceneOrClicks = std::variant<SceneFile, std::vector<Click>>;

/// Reads a scene file, or clicks: an array of them, or a single one, recognized by its "scene".
/// @return as parseScene
base::Expected<SceneOrClicks, base::Error> parseSceneOrClicks(std::string_view text, const std::string &name);

/// The scene, or the one that all clicks share.
/// @param name  of the file, for the error
SceneOrError oneScene(const SceneOrClicks &given, const std::string &name);

} // namespace unprojector::scene_file
