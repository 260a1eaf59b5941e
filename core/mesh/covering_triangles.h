#pragma once

#include "core/geometry/box.h"
#include "core/mesh/mesh.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace unprojector::mesh {

/// Selects the triangles of a mesh that can cover the centre of a pixel. OpenGL draws nothing of
/// the others, but a software renderer takes long to discard them: most triangles of a fine mesh
/// lie between the centres.
class CoveringTriangles {
public:
    /// @param mesh  of triangles; outlives this
    /// @param clipFromSource  of the mesh's positions, in single precision as OpenGL takes it
    /// @param viewport  x, y, width, height, device pixels
    /// @param reach  the largest size of each coordinate of the positions
    CoveringTriangles(const Mesh &mesh, const glm::mat4 &clipFromSource, const glm::ivec4 &viewport,
                      const glm::dvec3 &reach);

    /// Caches the projected position of every vertex, so that the triangles around it share the
    /// work. Pays off for a caller that asks for all triangles. Takes 12 bytes a vertex.
    void placeVertices();

    /// Appends the vertices of the covering triangles and of all that lie only partly in front of
    /// the eye, three each and in their order. A margin allows for OpenGL's rounding, so no
    /// triangle that it draws is left out.
    /// @param begin, end  corners of whole triangles
    void append(std::size_t begin, std::size_t end, std::vector<std::uint32_t> &vertices) const;

private:
    struct Corner {
        float x, y;   ///< pixels from the viewport's lower left corner
        float margin; ///< distance by which OpenGL's position may differ; infinite if not in front of the eye
    };
    Corner cornerAt(const glm::vec3 &position) const;
    bool canCover(const Corner &a, const Corner &b, const Corner &c) const;

    const Mesh &m_mesh;
    glm::vec4 m_x, m_y, m_w;     ///< rows of the matrix
    float m_sizeOfXY, m_sizeOfW; ///< sums of their largest terms
    float m_width, m_height;     ///< of the viewport
    std::vector<Corner> m_placed;
};

} // namespace unprojector::mesh
