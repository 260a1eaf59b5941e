#include "core/mesh/import/obj_vertices.h"

namespace unprojector::mesh::reader {

namespace {

constexpr std::uint32_t kEmpty = 0xffffffffu;
constexpr std::size_t kFirstSlots = 64;

std::size_t hashOf(const ObjVertices::Vertex &vertex)
{
    std::uint64_t hash = 0x2545f4914f6cdd1dull;
    for (const std::int32_t number : vertex) {
        hash = (hash ^ static_cast<std::uint32_t>(number)) * 0x9e3779b97f4a7c15ull;
        hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
}

} // namespace

ObjVertices::ObjVertices(std::size_t kept)
    : m_kept(kept), m_isUsed(kept, false), m_vertices(kept), m_slots(kFirstSlots, kEmpty)
{
    for (std::size_t v = 0; v < kept; ++v)
        m_vertices[v] = {static_cast<std::int32_t>(v), -1, -1};
}

std::size_t ObjVertices::slotOf(const Vertex &vertex) const
{
    const std::size_t mask = m_slots.size() - 1;
    std::size_t slot = hashOf(vertex) & mask;
    while (m_slots[slot] != kEmpty && m_vertices[m_slots[slot]] != vertex)
        slot = (slot + 1) & mask;
    return slot;
}

std::uint32_t ObjVertices::add(const Vertex &vertex)
{
    const auto position = static_cast<std::size_t>(vertex[ObjVertex]);
    if (position < m_kept) {
        if (!m_isUsed[position]) {
            m_isUsed[position] = true;
            m_vertices[position] = vertex;
        }
        if (m_vertices[position] == vertex)
            return static_cast<std::uint32_t>(position);
    }
    std::size_t slot = slotOf(vertex);
    if (m_slots[slot] != kEmpty)
        return m_slots[slot];
    const std::size_t count = m_vertices.size() - m_kept;
    if (count + count / 2 >= m_slots.size()) {
        grow();
        slot = slotOf(vertex);
    }
    m_slots[slot] = static_cast<std::uint32_t>(m_vertices.size());
    m_vertices.push_back(vertex);
    return m_slots[slot];
}

void ObjVertices::grow()
{
    m_slots.assign(2 * m_slots.size(), kEmpty);
    for (std::size_t v = m_kept; v < m_vertices.size(); ++v)
        m_slots[slotOf(m_vertices[v])] = static_cast<std::uint32_t>(v);
}

} // namespace unprojector::mesh::reader
