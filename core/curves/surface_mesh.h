#pragma once

#include "core/landmarks/landmark.h"
#include "core/mesh/mesh.h"
#include "core/ray/box_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace unprojector::curves {
using ray::Progress;

/// The triangles of a model as one surface: corners at the very same coordinates are one corner, whether the file has them once
/// or, as STL and split normals do, once a triangle. Made once a model, for paths; then immutable, and any thread may ask.
class SurfaceMesh {
public:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    /// Some 28 bytes a triangle.
    /// @param progress  may be empty
    /// @return null when progress says stop. Throws std::bad_alloc.
    static std::shared_ptr<const SurfaceMesh> build(const mesh::Model &model, const Progress &progress);

    /// As the model counts them; one whose corners are not three places has a side of no length, and no neighbours.
    std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(m_corners.size()); }
    std::size_t cornerCount() const { return m_places.size(); }
    const std::array<std::uint32_t, 3> &corners(std::uint32_t triangle) const { return m_corners[triangle]; }
    bool isFlat(std::uint32_t triangle) const;
    /// Object space.
    const glm::dvec3 &place(std::uint32_t corner) const { return m_places[corner]; }
    /// The corner of a vertex by its number, see Model::vertexNumber; kNone where no triangle uses it.
    std::uint32_t cornerOfVertex(std::uint32_t vertex) const;
    /// The triangles that have a corner.
    std::pair<const std::uint32_t *, const std::uint32_t *> around(std::uint32_t corner) const;

    /// Calls visit(other) for every other triangle that has both corners.
    template <class Visit>
    void across(std::uint32_t triangle, std::uint32_t a, std::uint32_t b, const Visit &visit) const
    {
        const auto [begin, end] = around(a);
        for (const std::uint32_t *other = begin; other != end; ++other) {
            const std::array<std::uint32_t, 3> &c = m_corners[*other];
            if (*other != triangle && (c[0] == b || c[1] == b || c[2] == b))
                visit(*other);
        }
    }
    /// The only other triangle that has both corners; kNone at a rim, and where three or more meet.
    std::uint32_t onlyAcross(std::uint32_t triangle, std::uint32_t a, std::uint32_t b) const;

private:
    std::vector<glm::dvec3> m_places;
    std::vector<std::array<std::uint32_t, 3>> m_corners;
    std::vector<std::uint32_t> m_starts, m_around; ///< of each corner, the triangles that have it
    std::vector<std::uint32_t> m_ofVertex;
};

/// A place of a surface: in a triangle, with weights of its corners; those that are 0 do not hold it.
struct SurfacePlace {
    std::uint32_t triangle = 0;
    glm::dvec3 barycentric{0.0};
};

/// Where a hold is on a surface.
/// @return nothing where it is free, no triangle has it, or no corner has a weight, as files may have it
std::optional<SurfacePlace> placeOf(const landmarks::Anchor &anchor, const SurfaceMesh &mesh);

} // namespace unprojector::curves
