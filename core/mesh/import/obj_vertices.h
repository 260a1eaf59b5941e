#pragma once

#include "core/mesh/import/obj_chunk.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace unprojector::mesh::reader {

/// The vertices of a mesh out of an OBJ file: one for each combination of position, texture coordinate and normal that
/// its corners have.
class ObjVertices {
public:
    /// By ObjKind, counted from 0; −1: none.
    using Vertex = std::array<std::int32_t, kObjKinds>;

    /// @param kept  so many of the file's vertices keep their numbers: their first combination gets it, others are
    ///              appended. Otherwise vertices come in the order of their use.
    explicit ObjVertices(std::size_t kept);
    /// The vertex's number in the mesh.
    std::uint32_t add(const Vertex &vertex);
    /// What is never used has neither texture coordinate nor normal.
    const std::vector<Vertex> &all() const { return m_vertices; }

private:
    std::size_t slotOf(const Vertex &vertex) const;
    void grow();

    std::size_t m_kept;
    std::vector<bool> m_isUsed; ///< of the kept ones
    std::vector<Vertex> m_vertices;
    std::vector<std::uint32_t> m_slots; ///< a table of those that are not kept, by hash
};

} // namespace unprojector::mesh::reader
