#pragma once

#include "core/mesh/import/gltf_file.h"
#include "core/mesh/import/material.h"

#include <glm/mat3x3.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace unprojector::mesh::reader {

/// A glTF material, with the set and the transform of its texture coordinates.
struct GltfMaterial : Material {
    std::uint64_t texcoordSet = 0;
    glm::dmat3 textureFromTexcoord{1.0}; ///< KHR_texture_transform; of (u, v, 1), v down
};

/// The materials of a glTF file. Reads images and adds notes to the model.
class GltfMaterials {
public:
    GltfMaterials(GltfFile &file, Model &model) : m_file(file), m_model(model) {}

    /// The material of a primitive of a mesh; a default if it has none.
    GltfMaterial of(const Json &primitive);

private:
    void readTexture(const Json &textureInfo, GltfMaterial &material);
    std::optional<int> textureNumber(const Json &texture);
    Texture imageOf(const Json &image);

    GltfFile &m_file;
    Model &m_model;
    std::map<std::uint64_t, GltfMaterial> m_materials;
    std::map<std::pair<std::uint64_t, bool>, int> m_textures; ///< by image and wrap mode
};

} // namespace unprojector::mesh::reader
