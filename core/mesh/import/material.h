#pragma once

#include "core/mesh/mesh.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace unprojector::mesh::reader {

/// A colour's channel. NaN becomes 0.
inline std::uint8_t byteFromShare(double share)
{
    return share > 0.0 ? static_cast<std::uint8_t>(std::lround(std::min(share, 1.0) * 255.0)) : std::uint8_t{0};
}

/// The colour that a material of a model file gives a surface. It is multiplied with the texture
/// and the vertex colours.
struct Material {
    glm::vec4 baseColor{0.8f, 0.8f, 0.8f, 1.0f};
    bool hasBaseColor = false; ///< whether the file sets it
    int texture = -1;          ///< index into Model::textures

    /// The base colour. If the file sets none, vertex colours stay unchanged. Points are unlit, and
    /// the grey of surfaces would have little contrast in a light theme; they get a grey that suits
    /// light and dark.
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
