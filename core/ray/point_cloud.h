#pragma once

#include "core/ray/box_tree.h"
#include "core/ray/element_numbers.h"
#include "core/ray/ray.h"
#include "core/ray/unit_space.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace unprojector::ray {

/// Which points a click takes: those whose place in the picture is close enough to it.
struct PointAim {
    glm::dmat4 clipFromObject{1.0};
    glm::dvec2 position{0.0};           ///< NDC
    glm::dvec2 ndcOfPixel{0.0};         ///< width and height of a pixel
    double pixels = 0.0;                ///< how far from the position
    double dotPixels = 0.0;             ///< how wide and high the dot is that a point is drawn as; no more than pixels
    Ray<geometry::ObjectSpace> ray;     ///< through the position; only what lies between its ends, in depth, counts
    std::vector<glm::dvec4> clipPlanes; ///< object space
};

/// A point that a click takes.
struct PointHit {
    std::uint32_t vertex = 0; ///< counted through all vertices of the model
    double t = 0.0;           ///< of the ray, where it is as deep as the point
    bool isOnDot = false;     ///< the position is on the dot that the point is drawn as
};

/// The points of a model, for clicks. On dots, the point of the front one, which is the one that is drawn. Beside them, of those
/// near enough to the click in the picture, the front ones count: those no farther behind the first than four times the width
/// of what the click reaches; and of these the one nearest to the click. So it is neither a point of the far side, seen
/// through the gaps, nor one at the reach's rim that is nearer by a hair.
/// Immutable: any thread may ask.
class PointCloud {
public:
    /// @param model  outlives this
    /// @return nothing when progress says stop
    static std::optional<PointCloud> build(const mesh::Model &model, const UnitSpace &space, const Progress &progress);

    std::optional<PointHit> nearest(const PointAim &aim) const;

private:
    PointCloud(const mesh::Model &model, const UnitSpace &space);

    const mesh::Model *m_model;
    const UnitSpace *m_space;
    ElementNumbers m_points;   ///< the elements of meshes of points
    ElementNumbers m_vertices; ///< of all meshes
    BoxTree m_tree;
};

} // namespace unprojector::ray
