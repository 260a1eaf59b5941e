#pragma once

#include "core/mesh/curvature.h"
#include "core/mesh/mesh.h"

#include <glm/vec3.hpp>

#include <map>
#include <memory>
#include <optional>

namespace unprojector::gui {

/// The curvature of models. Keys don't keep a model alive, and a new model never matches the key of
/// a former one.
using CurvatureMap =
    std::map<std::weak_ptr<const mesh::Model>, std::shared_ptr<const mesh::Curvature>, std::owner_less<>>;

/// The options that show the shape of surfaces by their colours. Depths and objects of pixels never
/// depend on them.
struct Shading {
    /// Direction to the only light, eye space, of length 1; nothing: the usual lights at the
    /// camera.
    std::optional<glm::vec3> sideLight = {};
    bool hasColors = true;        ///< textures, vertex colours and materials; else everything is grey
    bool hasEdges = false;        ///< edges of triangles that are large enough in the view
    CurvatureMap curvatures = {}; ///< models in it are light on ridges and dark in valleys
};

} // namespace unprojector::gui
