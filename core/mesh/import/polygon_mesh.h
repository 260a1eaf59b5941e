#pragma once

#include "core/mesh/import/polygon_triangulation.h"
#include "core/mesh/mesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace unprojector::mesh::reader {

/// Builds one mesh from a file's vertices and polygons. Colours and texture coordinates may belong
/// to vertices or to the corners of faces; then vertices are split where their corners differ.
class PolygonMesh {
public:
    explicit PolygonMesh(std::size_t vertexCount) : m_vertexCount(vertexCount) {}

    /// The vertices; set before the first polygon. Colours and texture coordinates either for all
    /// or for none.
    Mesh mesh;

    std::size_t vertexCount() const { return m_vertexCount; }
    /// The number of polygons so far with fewer than three corners.
    std::size_t lineCount() const { return m_lineCount; }

    /// Throws Damage for a vertex the file does not have. Many threads may call it at once.
    /// @param face  the face's number in the file, for messages
    void checkPolygon(std::span<const std::int64_t> vertices, std::size_t face) const;
    /// @pre checkPolygon() accepts it
    void addPolygon(std::span<const std::int64_t> vertices);
    /// Sets the corners of the last added polygon. If it is ever called, unset corners of other
    /// polygons are white or (0, 0).
    void setFaceColor(const glm::u8vec4 &color);
    void setCornerTexcoords(std::span<const glm::vec2> texcoords);
    /// Adds a strip of triangles; a negative number restarts it.
    void addStrip(std::span<const std::int64_t> vertices, std::size_t strip);

    /// Returns the finished mesh; of points if there is no triangle.
    Mesh take();

private:
    std::uint32_t checked(std::int64_t vertex, const char *what, std::size_t number) const;

    std::size_t m_vertexCount;
    std::size_t m_lineCount = 0;
    std::size_t m_polygonBegin = 0;              ///< where the last polygon starts in mesh.indices
    std::vector<std::uint32_t> m_localTriangles; ///< the last polygon's triangles, as corners of the polygon
    PolygonTriangulator m_triangulator;
    std::vector<glm::vec3> m_corners;
    std::vector<glm::u8vec4> m_cornerColors; ///< one an index, or shorter
    std::vector<glm::vec2> m_cornerTexcoords;
};

} // namespace unprojector::mesh::reader
