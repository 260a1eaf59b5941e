#pragma once

#include "core/mesh/mesh.h"

#include <glm/vec4.hpp>

namespace unprojector::mesh::reader {

/// What a material of a model file says of a surface's colour, which is multiplied with the texture's and the vertices'.
struct Material {
    glm::vec4 baseColor{0.8f, 0.8f, 0.8f, 1.0f};
    bool hasBaseColor = false; ///< whether the file says so
    int texture = -1;          ///< into Model::textures

    /// Where the file does not say, vertices that have colours are as those say. Points are not lit, and the grey of surfaces
    /// would hardly be seen before a light window: theirs is one for light and for dark.
    glm::vec4 baseColorOf(Mesh::Kind kind, bool hasVertexColors) const
    {
        if (hasBaseColor)
            return baseColor;
        if (hasVertexColors)
            return glm::vec4(1.0f);
        return kind == Mesh::Kind::Points ? glm::vec4(0.45f, 0.48f, 0.52f, 1.0f) : baseColor;
    }
};

} // namespace unprojector::mesh::reader
