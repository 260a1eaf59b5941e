#pragma once

#include "core/geometry/box.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace unprojector::scene {
using namespace geometry;

/// A base-colour texture as the file holds it: still encoded (PNG, JPEG, …), decoded by whoever draws it.
struct Texture {
    std::filesystem::path file;        ///< where it came from; for messages when embedded
    std::vector<std::uint8_t> encoded; ///< the file's bytes; empty when the file could not be read
    bool wrapRepeat = true;
};

/// Triangles that share one material. Object space, in single precision as model files and GPUs hold it.
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;     ///< one a vertex
    std::vector<glm::u8vec4> colors;    ///< one a vertex, or empty: the vertices are white
    std::vector<glm::vec2> texcoords;   ///< one a vertex, or empty: no texture. (0, 0) is the image's bottom-left
    std::vector<std::uint32_t> indices; ///< three a triangle
    glm::vec4 baseColor{0.8f, 0.8f, 0.8f, 1.0f};
    int texture = -1; ///< index into Model::textures, or -1

    std::size_t triangleCount() const { return indices.size() / 3; }
};

/// What one model file holds.
struct Model {
    std::string name;
    std::vector<Mesh> meshes;
    std::vector<Texture> textures;
    Box bounds;

    std::size_t triangleCount() const;
};

/// The box around all vertices that triangles use.
Box boundsOf(const std::vector<Mesh> &meshes);

} // namespace unprojector::scene
