#pragma once

#include "core/base/note.h"
#include "core/geometry/box.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace unprojector::mesh {

/// An image: rows from the bottom up, four bytes a pixel: red, green, blue, opacity.
struct Image {
    int widthPixels = 0;
    int heightPixels = 0;
    std::vector<std::uint8_t> rgba;
};

/// A base-colour texture, kept as the file's bytes (PNG, JPEG, …) until it is decoded for drawing.
struct Texture {
    std::filesystem::path file;         ///< its source; for messages if embedded
    std::vector<std::uint8_t> encoded;  ///< the file's bytes; empty if unreadable, and after decoding
    std::shared_ptr<const Image> image; ///< null before decoding, and if it failed
    bool wrapRepeat = true;
};

/// Triangles or points that share one material. GPUs take `positions`, in single precision about an
/// origin in double, so that a mesh far from the object's origin is drawn without loss.
/// Computations take `position` or `fromOrigin`, which are the file's numbers in double precision.
struct Mesh {
    enum class Kind { Triangles, Points };

    Kind kind = Kind::Triangles;
    glm::dvec3 origin{0.0};             ///< object space
    std::vector<glm::vec3> positions;   ///< relative to `origin`, rounded
    std::vector<glm::ivec3> remainders; ///< see remainderOf: one a vertex, or empty if `positions` are exact
    std::vector<glm::vec3> normals;     ///< one a vertex, or empty: triangles are drawn flat
    std::vector<glm::u8vec4> colors;    ///< one a vertex, or empty: the vertices are white
    std::vector<glm::vec2> texcoords;   ///< one a vertex, or empty: no texture. (0, 0) is the image's bottom-left
    std::vector<std::uint32_t> indices; ///< three a triangle, or empty: vertices in their order. Empty for points
    /// The file's number of each vertex, see Model::vertexNumber. If empty in all meshes of the
    /// model: numbered in their order.
    std::vector<std::uint32_t> vertexNumbers;
    glm::vec4 baseColor{0.8f, 0.8f, 0.8f, 1.0f};
    int texture = -1;      ///< index into Model::textures, or -1
    bool isClosed = false; ///< known to be closed: seen from outside, a front side hides every back side

    std::size_t triangleCount() const { return kind == Kind::Triangles ? elementCount() / 3 : 0; }
    std::size_t pointCount() const { return kind == Kind::Points ? elementCount() : 0; }
    /// The corners of all triangles, or the points.
    std::size_t elementCount() const { return indices.empty() ? positions.size() : indices.size(); }
    /// The vertex of corner `element % 3` of triangle `element / 3`, or of a point.
    std::size_t vertexAt(std::size_t element) const { return indices.empty() ? element : indices[element]; }
    /// A vertex's position relative to `origin`, exact.
    glm::dvec3 fromOrigin(std::size_t vertex) const;
    /// A vertex's position in object space: the file's number, rounded to double.
    glm::dvec3 position(std::size_t vertex) const { return origin + fromOrigin(vertex); }
};

/// The part of a number that single precision loses: the count of doubles between it and its float.
/// It always fits, since a float has 29 bits fewer than a double. Below 1.2e-38, where floats have
/// fewer bits, it is 0.
std::int32_t remainderOf(double exact, float rounded);
/// The number restored from its float and its remainder.
inline double withRemainder(float rounded, std::int32_t remainder)
{
    return std::bit_cast<double>(std::bit_cast<std::int64_t>(double{rounded}) + remainder);
}

inline glm::dvec3 Mesh::fromOrigin(std::size_t vertex) const
{
    const glm::vec3 &p = positions[vertex];
    if (remainders.empty())
        return glm::dvec3(p);
    const glm::ivec3 &r = remainders[vertex];
    return {withRemainder(p.x, r.x), withRemainder(p.y, r.y), withRemainder(p.z, r.z)};
}

class SoupNumbers;

/// The contents of one model file.
struct Model {
    std::string name;
    std::vector<Mesh> meshes;
    std::vector<Texture> textures;
    geometry::Box bounds;
    /// The vertex count in the file, before splitting at normals and the like; all vertex numbers
    /// are smaller. 0 for a triangle soup, whose triangles share no vertices.
    std::size_t fileVertices = 0;
    /// The vertex numbers of a triangle soup, computed on first use. A soup has one mesh. Null for
    /// other models.
    std::shared_ptr<SoupNumbers> soupNumbers;
    std::vector<base::Note> notes; ///< what is not shown as the file has it
    /// The other files that were read: material libraries, buffers. Textures name their own files.
    std::vector<std::filesystem::path> otherFiles;

    std::size_t triangleCount() const;
    std::size_t pointCount() const;
    std::size_t vertexCount() const; ///< of all meshes

    struct VertexPlace {
        std::size_t mesh, vertex;
    };
    /// The number of a vertex in the file, from 0. Vertices split from one in the file share its
    /// number. The importer splits where normals, colours or texture coordinates differ between
    /// corners, or by material.
    std::uint32_t vertexNumber(std::size_t mesh, std::size_t vertex) const;
    /// The first vertex with a number; nothing if the file has no such vertex or never uses it.
    /// Searches all vertices if the file's were split.
    std::optional<VertexPlace> vertexOf(std::uint32_t number) const;

private:
    /// The file's numbers of a mesh's vertices; empty if they follow the mesh's order.
    const std::vector<std::uint32_t> &numbersIn(std::size_t mesh) const;
};

/// The origin that keeps the digits of positions in a box. Along each axis on which the box is
/// farther from zero than it is wide, it is the box's middle rounded to single precision; else
/// zero. Differences of the box's numbers from it are exact; if the numbers are floats, so are the
/// differences.
glm::dvec3 originFor(const geometry::Box &box);
/// Adds a vertex to a mesh whose origin is set; a position that is not finite stays so.
/// @param position  object space
void addPosition(Mesh &mesh, const glm::dvec3 &position);
/// Sets an existing vertex. Many threads may call it at once.
/// @pre both `positions` and `remainders` have it
void setPosition(Mesh &mesh, std::size_t vertex, const glm::dvec3 &position);
/// Sets a mesh's origin and positions.
/// @param origin  the same for all touching meshes of a model, else rounding opens gaps between
///         them on the screen
/// @param positions  object space
void setPositions(Mesh &mesh, const glm::dvec3 &origin, std::span<const glm::dvec3> positions);

/// Computes the bounding box of vertices of one mesh, from their exact positions.
class ShownBox {
public:
    void add(const Mesh &mesh, std::size_t vertex);
    const geometry::Box &box() const { return m_box; }

private:
    static constexpr float kMost = std::numeric_limits<float>::max();
    glm::vec3 m_lowest{kMost}, m_highest{-kMost}; ///< of one mesh, in single precision
    geometry::Box m_box;
};

/// The bounding box of all points and of all vertices that triangles use.
geometry::Box boundsOf(const std::vector<Mesh> &meshes);

} // namespace unprojector::mesh
