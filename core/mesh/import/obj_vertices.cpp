#include "core/mesh/import/obj_vertices.h"

namespace unprojector::mesh::reader {

ObjVertices::ObjVertices(std::size_t kept)
    : m_kept(kept), m_isUsed(kept, false), m_vertices(0, std::vector<Vertex>(kept))
{
    for (std::size_t v = 0; v < kept; ++v)
        m_vertices.keys()[v] = {static_cast<std::int32_t>(v), -1, -1};
}

std::uint32_t ObjVertices::add(const Vertex &vertex)
{
    const auto position = static_cast<std::size_t>(vertex[ObjVertex]);
    if (position < m_kept) {
        Vertex &first = m_vertices.keys()[position];
        if (!m_isUsed[position]) {
            m_isUsed[position] = true;
            first = vertex;
        }
        if (first == vertex)
            return static_cast<std::uint32_t>(position);
    }
    return m_vertices.add(vertex);
}

} // namespace unprojector::mesh::reader
