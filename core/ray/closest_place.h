#pragma once

#include "core/landmarks/landmark.h"
#include "core/mesh/mesh.h"
#include "core/ray/box_tree.h"
#include "core/ray/element_numbers.h"
#include "core/ray/unit_space.h"

#include <array>
#include <memory>
#include <optional>

namespace unprojector::ray {

/// The location on a model that is closest to a point.
struct ClosestPlace {
    landmarks::Anchor anchor; ///< OnTriangle; AtVertex for a point of a point cloud
    geometry::ObjectPoint point;
    double distance = 0.0; ///< from the query point, object space
};

/// The location on a triangle that is closest to the origin.
/// @return its three barycentric coordinates, none below 0, exactly 0 and 1 at corners; also for a
///         triangle without area
glm::dvec3 closestToOrigin(const std::array<glm::dvec3, 3> &corners);

/// Finds the locations on a model that are closest to points, in double precision. The result
/// equals a test of all triangles and points, but takes far less time. Of several equally close
/// ones, the one with the lowest number. Embree does not change the answer. Building takes a while
/// for large models; afterwards it is immutable, and any thread may query it.
class ClosestPlaces {
public:
    /// @param model     one that has triangles or points
    /// @param progress  may be empty
    /// @return null if progress cancels
    /// Throws std::bad_alloc.
    static std::shared_ptr<const ClosestPlaces> build(std::shared_ptr<const mesh::Model> model,
                                                      const Progress &progress);

    /// The closest location; nothing for a point that is not finite.
    std::optional<ClosestPlace> to(const geometry::ObjectPoint &point) const;

    const mesh::Model &model() const { return *m_model; }

private:
    explicit ClosestPlaces(std::shared_ptr<const mesh::Model> model);
    /// The triangle or point of a box.
    ElementNumbers::Place elementOf(std::uint32_t box) const
    {
        return box < m_triangles.count() ? m_triangles.place(box) : m_points.place(box - m_triangles.count());
    }

    std::shared_ptr<const mesh::Model> m_model;
    ElementNumbers m_triangles, m_points;
    UnitSpace m_space;
    BoxTree m_tree; ///< of all triangles, followed by all points
};

/// The position of an anchor on a model.
/// @return nothing if it is free, or the model has no such triangle or vertex
std::optional<geometry::ObjectPoint> placeOf(const landmarks::Anchor &anchor, const mesh::Model &model);

} // namespace unprojector::ray
