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

/// Which triangles of a mesh can cover the centre of a pixel. OpenGL draws nothing of the others, but without a graphics
/// card it takes long to find that out: most triangles of a fine mesh lie between the centres.
class CoveringTriangles {
public:
    /// @param mesh  of triangles; outlives this
    /// @param clipFromSource  of the mesh's positions, in single precision as OpenGL takes it
    /// @param viewport  x, y, width, height, device pixels
    /// @param reach  the largest size of each coordinate of the positions
    CoveringTriangles(const Mesh &mesh, const glm::mat4 &clipFromSource, const glm::ivec4 &viewport,
                      const glm::dvec3 &reach);

    /// Finds out once where every vertex comes to lie, instead of at each triangle around it anew: for whoever asks for all
    /// triangles. Takes 12 bytes a vertex.
    void placeVertices();

    /// Appends the vertices of those, and of all that lie in front of the eye in part only, three each and in their order.
    /// What OpenGL rounds is allowed for: none that it draws anything of is left out.
    /// @param begin, end  corners of whole triangles
    void append(std::size_t begin, std::size_t end, std::vector<std::uint32_t> &vertices) const;

private:
    struct Corner {
        float x, y;   ///< pixels from the viewport's lower left corner
        float margin; ///< by which OpenGL may place it elsewhere; infinite where it is not in front of the eye
    };
    Corner cornerAt(const glm::vec3 &position) const;
    bool canCover(const Corner &a, const Corner &b, const Corner &c) const;

    const Mesh &m_mesh;
    glm::vec4 m_x, m_y, m_w;     ///< rows of the matrix
    float m_sizeOfXY, m_sizeOfW; ///< of their largest summands, together
    float m_width, m_height;     ///< of the viewport
    std::vector<Corner> m_placed;
};

} // namespace unprojector::mesh
