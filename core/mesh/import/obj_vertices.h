#pragma once

#include "core/mesh/import/obj_chunk.h"
#include "core/mesh/numbering.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace unprojector::mesh::reader {

/// The vertices of a mesh from an OBJ file: one for each combination of position, texture
/// coordinate and normal in its corners.
class ObjVertices {
public:
    /// The indices by ObjKind, counted from 0; −1: none.
    using Vertex = std::array<std::int32_t, kObjKinds>;

    /// @param kept  this many of the file's vertices keep their numbers: the first combination of
    ///         each gets its number, others are appended. With 0, vertices are numbered in the
    ///         order of use.
    explicit ObjVertices(std::size_t kept);
    /// The vertex's number in the mesh.
    std::uint32_t add(const Vertex &vertex);
    /// All vertices. An unused one has neither texture coordinate nor normal.
    const std::vector<Vertex> &all() const { return m_vertices.keys(); }

private:
    std::size_t m_kept;
    std::vector<bool> m_isUsed; ///< of the kept ones
    struct Hash {
        std::uint64_t operator()(const Vertex &vertex) const
        {
            return hashOf(std::bit_cast<std::array<std::uint32_t, kObjKinds>>(vertex));
        }
    };
    Numbering<Vertex, Hash> m_vertices;
};

} // namespace unprojector::mesh::reader
