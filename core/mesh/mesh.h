#pragma once

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

/// A picture: rows from the bottom up, four bytes a pixel: red, green, blue, opacity.
struct Image {
    int widthPixels = 0;
    int heightPixels = 0;
    std::vector<std::uint8_t> rgba;
};

/// A base-colour texture: as the file holds it (PNG, JPEG, …) until it is decoded for being drawn.
struct Texture {
    std::filesystem::path file; ///< where it came from; for messages when embedded
    std::vector<std::uint8_t>
        encoded; ///< the file's bytes; empty when the file could not be read, and once it is decoded
    std::shared_ptr<const Image> image; ///< null before it is decoded, and where that failed
    bool wrapRepeat = true;
};

/// Triangles or points that share one material. GPUs take `positions`, in single precision about an origin in double, so
/// that a mesh far from the object's origin is drawn as well as any. What is computed takes `position` or `fromOrigin`,
/// which are the file's numbers in double precision.
struct Mesh {
    enum class Kind { Triangles, Points };

    Kind kind = Kind::Triangles;
    glm::dvec3 origin{0.0};             ///< object space
    std::vector<glm::vec3> positions;   ///< relative to `origin`, rounded
    std::vector<glm::ivec3> remainders; ///< see remainderOf: one a vertex, or empty where `positions` are exact
    std::vector<glm::vec3> normals;     ///< one a vertex, or empty: triangles are drawn flat
    std::vector<glm::u8vec4> colors;    ///< one a vertex, or empty: the vertices are white
    std::vector<glm::vec2> texcoords;   ///< one a vertex, or empty: no texture. (0, 0) is the image's bottom-left
    std::vector<std::uint32_t> indices; ///< three a triangle, or empty: the vertices as they come. None for points
    /// Of each vertex its number in the file, see Model::vertexNumber. Empty, in all meshes of the model: as they come.
    std::vector<std::uint32_t> vertexNumbers;
    glm::vec4 baseColor{0.8f, 0.8f, 0.8f, 1.0f};
    int texture = -1;      ///< index into Model::textures, or -1
    bool isClosed = false; ///< known: seen from outside, every back side is hidden by a front side

    std::size_t triangleCount() const { return kind == Kind::Triangles ? elementCount() / 3 : 0; }
    std::size_t pointCount() const { return kind == Kind::Points ? elementCount() : 0; }
    /// The corners of all triangles, or the points.
    std::size_t elementCount() const { return indices.empty() ? positions.size() : indices.size(); }
    /// The vertex of corner `element % 3` of triangle `element / 3`, or of a point.
    std::size_t vertexAt(std::size_t element) const { return indices.empty() ? element : indices[element]; }
    /// Relative to `origin`, exact.
    glm::dvec3 fromOrigin(std::size_t vertex) const;
    /// Object space: the file's number, rounded to double.
    glm::dvec3 position(std::size_t vertex) const { return origin + fromOrigin(vertex); }
};

/// What single precision leaves out of a number: how many doubles lie between it and its float. A float has 29 bits less
/// than a double, so it always fits; only below 1.2e-38, where floats have fewer bits, it is 0.
std::int32_t remainderOf(double exact, float rounded);
/// The number again.
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

/// Something of a model file that is not shown, or not as the file has it.
struct ModelNote {
    enum class Kind {
        TextureMissing,    ///< detail: the file that is not there or cannot be read
        TextureUnusable,   ///< detail: its file, which is damaged, of a kind that is not known, or far too large
        TextureScaledDown, ///< detail: its file, count: its new width in pixels
        MaterialsMissing,  ///< detail: the file of materials that is not there or cannot be read
        MaterialUnknown,   ///< detail: a name that none of the file's materials has, count: how many such names
        LinesLeftOut,      ///< count: lines, and points beside triangles
        FacesLeftOut,      ///< count: faces that refer to vertices which the file does not have
        TexcoordsLeftOut,  ///< count: faces that refer to texture coordinates which the file does not have
        NormalsLeftOut,    ///< count: faces that refer to normals which the file does not have: they are made instead
        NumbersLeftOut,    ///< count: vertices with words behind their coordinates that mean nothing there
        ColorsUndeclared,  ///< numbers behind the coordinates are used as colours, which the header does not declare
        WeightsLeftOut,    ///< count: vertices with a weight of rational curves, which is not used
        LinesUnknown,      ///< count: lines that begin with a word which the format does not have; detail: the first
        BytesLeftOut,      ///< count: bytes behind all that the file declares
        PartLeftOut,       ///< detail: what the format calls it, such as an extension; count: how many, or 0
        ElementsLeftOut,   ///< detail: an element of a PLY file that is not read; count: how many the file has
        NodesLeftOut,      ///< count: meshes that no node of the shown scene has
        NodesListedAgain,  ///< count: nodes that the scene lists a second time, or beside a node that they are below
        CornersLeftOut,    ///< count: corners behind the last whole triangle of a part of a mesh
        FlatTriangles,     ///< count: triangles that have no area in single precision
        TooSmallToDraw,    ///< detail: what the model measures, less than graphics cards can draw
        SceneMissing,      ///< the file has no scene: all its nodes are shown
        PositionsMissing,  ///< count: parts of meshes without any positions
        PictureUnknown,    ///< count: textures whose picture is of a kind that is not known
        ExtensionLeftOut,  ///< detail: a glTF extension that the file requires, and that moves no vertex
        SubstituteShown,   ///< detail: a glTF extension that changes the shape, and that the file can do without
        SkinsApplied,      ///< count: nodes whose meshes are where the joints of their skins are
        MeshesHidden,      ///< count: nodes with meshes that the file hides
        ReadOutside,       ///< detail: a file outside the model's folder that was read; count: how many such files
    };
    Kind kind;
    std::size_t count = 0;
    std::string detail; ///< UTF-8, as the file has it
    friend bool operator==(const ModelNote &, const ModelNote &) = default;
};

class SoupNumbers;

/// What one model file holds.
struct Model {
    std::string name;
    std::vector<Mesh> meshes;
    std::vector<Texture> textures;
    geometry::Box bounds;
    /// Of the file, before any were split for their normals or the like. 0: of a soup, whose triangles have theirs alone. Those
    /// of the meshes have smaller numbers.
    std::size_t fileVertices = 0;
    /// Numbers the vertices of a triangle soup, which is one mesh; null for other models.
    std::shared_ptr<SoupNumbers> soupNumbers;
    std::vector<ModelNote> notes; ///< what is not as in the file
    /// The other files that were read for it: libraries of materials, buffers. Those of textures are at the textures.
    std::vector<std::filesystem::path> otherFiles;

    std::size_t triangleCount() const;
    std::size_t pointCount() const;
    std::size_t vertexCount() const; ///< of all meshes

    struct VertexPlace {
        std::size_t mesh, vertex;
    };
    /// The number of a vertex in the file, from 0. Several vertices have the same number where one of the file was split: for
    /// normals, colours or texture coordinates that differ from corner to corner, or by material.
    std::uint32_t vertexNumber(std::size_t mesh, std::size_t vertex) const;
    /// The first vertex of a number; nothing where the file has no such vertex, or none that is used. Looks through all of
    /// them where the file's were split.
    std::optional<VertexPlace> vertexOf(std::uint32_t number) const;

private:
    /// The file's numbers of a mesh's vertices; empty where they follow the mesh's order.
    const std::vector<std::uint32_t> &numbersIn(std::size_t mesh) const;
};

/// The origin that keeps the digits of positions in a box: along each axis on which the box is farther from zero than it
/// is wide, its middle rounded to single precision; else zero. Differences of the box's numbers from it are exact, and
/// those of floats are floats.
glm::dvec3 originFor(const geometry::Box &box);
/// Adds a vertex to a mesh whose origin is set; a position that is not finite stays so.
/// @param position  object space
void addPosition(Mesh &mesh, const glm::dvec3 &position);
/// The same for a vertex that there is already, and so from many threads at once.
/// @pre both `positions` and `remainders` have it
void setPosition(Mesh &mesh, std::size_t vertex, const glm::dvec3 &position);
/// Sets a mesh's origin and positions.
/// @param origin  the same for all meshes of a model that touch each other, or else they part by a rounding on the screen
/// @param positions  object space
void setPositions(Mesh &mesh, const glm::dvec3 &origin, std::span<const glm::dvec3> positions);

/// Finds the box around vertices of one mesh, of their exact positions.
class ShownBox {
public:
    void add(const Mesh &mesh, std::size_t vertex);
    const geometry::Box &box() const { return m_box; }

private:
    static constexpr float kMost = std::numeric_limits<float>::max();
    glm::vec3 m_lowest{kMost}, m_highest{-kMost}; ///< of one mesh, in single precision
    geometry::Box m_box;
};

/// The box around all points and all vertices that triangles use.
geometry::Box boundsOf(const std::vector<Mesh> &meshes);

} // namespace unprojector::mesh
