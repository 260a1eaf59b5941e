#include "core/mesh/import/polygon_mesh.h"

#include "core/base/translation.h"
#include "core/mesh/import/material.h"
#include "core/mesh/import/mesh_normals.h"
#include "core/mesh/import/mesh_reader.h"

#include <string>
#include <utility>

namespace unprojector::mesh::reader {
using base::marked;
using base::tr;

std::uint32_t PolygonMesh::checked(std::int64_t vertex, const char *what, std::size_t number) const
{
    if (vertex < 0 || static_cast<std::uint64_t>(vertex) >= m_vertexCount)
        failMalformed(
            tr("%1 %2 refers to vertex %3, the file has %4 (counted from 0)", tr(what), number, vertex, m_vertexCount));
    return static_cast<std::uint32_t>(vertex);
}

void PolygonMesh::checkPolygon(std::span<const std::int64_t> vertices, std::size_t face) const
{
    for (const std::int64_t vertex : vertices)
        checked(vertex, marked("face|of a mesh"), face);
}

void PolygonMesh::addPolygon(std::span<const std::int64_t> vertices)
{
    m_polygonBegin = mesh.indices.size();
    m_localTriangles.clear();
    m_lineCount += vertices.size() < 3 ? 1u : 0u;
    if (vertices.size() == 3) {
        m_localTriangles.assign({0, 1, 2});
    } else if (vertices.size() > 3) {
        m_corners.clear();
        for (const std::int64_t vertex : vertices)
            m_corners.push_back(mesh.positions[static_cast<std::size_t>(vertex)]);
        m_triangulator.triangulate(m_corners, m_localTriangles);
    }
    for (const std::uint32_t corner : m_localTriangles)
        mesh.indices.push_back(static_cast<std::uint32_t>(vertices[corner]));
}

void PolygonMesh::setFaceColor(const glm::u8vec4 &color)
{
    m_cornerColors.resize(m_polygonBegin, glm::u8vec4(255));
    m_cornerColors.resize(mesh.indices.size(), color);
}

void PolygonMesh::setCornerTexcoords(std::span<const glm::vec2> texcoords)
{
    m_cornerTexcoords.resize(m_polygonBegin, glm::vec2(0.0f));
    for (const std::uint32_t corner : m_localTriangles)
        m_cornerTexcoords.push_back(corner < texcoords.size() ? texcoords[corner] : glm::vec2(0.0f));
}

void PolygonMesh::addStrip(std::span<const std::int64_t> vertices, std::size_t strip)
{
    std::size_t begin = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (vertices[i] < 0) {
            begin = i + 1;
            continue;
        }
        const std::uint32_t c = checked(vertices[i], marked("triangle strip"), strip);
        if (i < begin + 2)
            continue;
        auto a = static_cast<std::uint32_t>(vertices[i - 2]);
        auto b = static_cast<std::uint32_t>(vertices[i - 1]);
        // Every second triangle of a strip has the opposite winding.
        if ((i - begin) % 2 != 0)
            std::swap(a, b);
        // A repeated vertex only steers the strip.
        if (a != b && b != c && c != a)
            mesh.indices.insert(mesh.indices.end(), {a, b, c});
    }
}

Mesh PolygonMesh::take()
{
    if (mesh.indices.empty()) {
        mesh.kind = Mesh::Kind::Points;
        mesh.baseColor = Material{}.baseColorOf(mesh.kind, !mesh.colors.empty());
    }
    if (m_cornerColors.empty() && m_cornerTexcoords.empty())
        return std::move(mesh);

    m_cornerColors.resize(m_cornerColors.empty() ? 0 : mesh.indices.size(), glm::u8vec4(255));
    m_cornerTexcoords.resize(m_cornerTexcoords.empty() ? 0 : mesh.indices.size(), glm::vec2(0.0f));
    const std::vector<std::uint32_t> corners = std::exchange(mesh.indices, {});
    gatherVertices(mesh, corners);
    mesh.vertexNumbers = corners;
    if (!m_cornerColors.empty())
        mesh.colors = std::move(m_cornerColors);
    if (!m_cornerTexcoords.empty())
        mesh.texcoords = std::move(m_cornerTexcoords);
    mergeEqualVertices(mesh);
    return std::move(mesh);
}

} // namespace unprojector::mesh::reader
