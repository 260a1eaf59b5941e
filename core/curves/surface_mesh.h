#pragma once

#include "core/base/progress.h"
#include "core/landmarks/landmark.h"
#include "core/mesh/mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace unprojector::curves {

/// The triangles of a model as one surface. Corners with identical coordinates are one corner, even
/// where the file repeats them per triangle, as STL and split normals do. Built once per model, for
/// paths; then immutable and safe for all threads.
class SurfaceMesh {
public:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    /// Builds the surface, with some 28 bytes per triangle.
    /// @param progress  may be empty
    /// @return null if progress requests a stop. Throws std::bad_alloc.
    static std::shared_ptr<const SurfaceMesh> build(const mesh::Model &model, const base::Progress &progress);

    /// The model's triangle count. A triangle without three distinct corners has an edge of length
    /// 0 and no neighbours.
    std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(m_corners.size()); }
    std::size_t cornerCount() const { return m_places.size(); }
    const std::array<std::uint32_t, 3> &corners(std::uint32_t triangle) const { return m_corners[triangle]; }
    bool isFlat(std::uint32_t triangle) const;
    /// The position of a corner, object space.
    const glm::dvec3 &place(std::uint32_t corner) const { return m_places[corner]; }
    /// The corner of a vertex by its number, see Model::vertexNumber; kNone if no triangle uses it.
    std::uint32_t cornerOfVertex(std::uint32_t vertex) const;
    /// The triangles that share a corner.
    std::span<const std::uint32_t> around(std::uint32_t corner) const
    {
        return std::span(m_around).subspan(m_starts[corner], m_starts[corner + 1] - m_starts[corner]);
    }
    /// The corner of a triangle beside two others; the first of them where a flat triangle has no other.
    std::uint32_t thirdCorner(std::uint32_t triangle, std::uint32_t a, std::uint32_t b) const;

    /// Calls visit(other) for every other triangle with both corners.
    template <class Visit>
    void across(std::uint32_t triangle, std::uint32_t a, std::uint32_t b, const Visit &visit) const
    {
        for (const std::uint32_t other : around(a)) {
            const std::array<std::uint32_t, 3> &c = m_corners[other];
            if (other != triangle && (c[0] == b || c[1] == b || c[2] == b))
                visit(other);
        }
    }
    /// The only other triangle with both corners; kNone at a boundary, and where three or more
    /// meet.
    std::uint32_t onlyAcross(std::uint32_t triangle, std::uint32_t a, std::uint32_t b) const;

private:
    std::vector<glm::dvec3> m_places;
    std::vector<std::array<std::uint32_t, 3>> m_corners;
    std::vector<std::uint32_t> m_starts, m_around; ///< for each corner, the triangles that share it
    std::vector<std::uint32_t> m_ofVertex;
};

/// A position on a surface: in a triangle, with weights of its corners. A corner of weight 0 has no
/// influence.
struct SurfacePlace {
    std::uint32_t triangle = 0;
    glm::dvec3 barycentric{0.0};
};

/// The position of an anchor on a surface.
/// @return empty if it is free, if its triangle or vertex is missing, or if no corner has a weight,
///         as files may have it
std::optional<SurfacePlace> placeOf(const landmarks::Anchor &anchor, const SurfaceMesh &mesh);

} // namespace unprojector::curves
