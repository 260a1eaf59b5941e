#pragma once

#include "core/ray/nearest_triangle.h"
#include "core/ray/point_cloud.h"
#include "core/ray/triangle_tree.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace unprojector::ray {

/// Computes where rays hit a model in about a microsecond, exactly as testing all its triangles in
/// double precision would (see NearestTriangle). Building takes a while for large models and may
/// run on any thread. Afterwards it is immutable, and any thread may query it.
class RayCaster {
public:
    enum class Tree {
        Fastest, ///< Embree's if available
        Plain,   ///< this program's own; the answers are the same
    };

    /// @param progress  may be empty
    /// @return null if progress cancels
    /// Throws std::bad_alloc.
    static std::shared_ptr<const RayCaster> build(std::shared_ptr<const mesh::Model> model, const Progress &progress,
                                                  Tree tree = Tree::Fastest);

    const mesh::Model &model() const { return *m_model; }
    /// The numbers of the model's triangles.
    const ElementNumbers &triangleNumbers() const { return m_numbers; }

    /// The triangle that a ray in object space hits first, from either side.
    /// @return nothing without one in low <= t <= high, and for a ray that is not finite
    std::optional<TriangleHit> nearestTriangle(const Ray<geometry::ObjectSpace> &ray) const;

    /// The triangles that a bundle of rays passes, and others near them, each once.
    std::vector<std::uint32_t> trianglesAbout(const RayBundle &bundle) const;

    /// The point of the model's point clouds that a click takes, see PointCloud.
    std::optional<PointHit> nearestPoint(const PointAim &aim) const;
    bool hasPoints() const { return m_points.has_value(); }

private:
    explicit RayCaster(std::shared_ptr<const mesh::Model> model);

    std::shared_ptr<const mesh::Model> m_model;
    ElementNumbers m_numbers; ///< of its triangles
    UnitSpace m_space;
    TrianglePackets m_packets;
    std::unique_ptr<const TriangleTree> m_triangles; ///< null: the model has none
    std::optional<PointCloud> m_points;              ///< nothing: the model has none
};

} // namespace unprojector::ray
