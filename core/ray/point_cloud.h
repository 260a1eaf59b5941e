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

/// The query for the point that a click takes: points close enough to it in the view.
struct PointAim {
    glm::dmat4 clipFromObject{1.0};
    glm::dvec2 position{0.0};           ///< NDC
    glm::dvec2 ndcOfPixel{0.0};         ///< width and height of a pixel
    double pixels = 0.0;                ///< the largest distance from the position
    double dotPixels = 0.0;             ///< width and height of the dot that a point is drawn as; at most `pixels`
    Ray<geometry::ObjectSpace> ray;     ///< through the position; only points between the depths of its ends count
    std::vector<glm::dvec4> clipPlanes; ///< object space
};

/// The point that a click takes.
struct PointHit {
    std::uint32_t vertex = 0; ///< numbered across all vertices of the model
    double t = 0.0;           ///< of the ray, at the point's depth
    bool isOnDot = false;     ///< the position is on the point's dot
};

/// Selects points of a model by clicks. On dots, the click takes the front one, which is the
/// visible one. Beside them, candidates are the points within reach in the view that lie at most
/// four reach widths behind the first. Of these, the click takes the one nearest to it. So it takes
/// neither a point of the far side, seen through the gaps, nor a point at the rim that is in front
/// by a hair.
///
/// Immutable: any thread may query it.
class PointCloud {
public:
    /// @param model, space  outlive this
    /// Throws base::Stopped.
    PointCloud(const mesh::Model &model, const UnitSpace &space, const Progress &progress);

    std::optional<PointHit> nearest(const PointAim &aim) const;

private:
    const mesh::Model &m_model;
    const UnitSpace &m_space;
    ElementNumbers m_points;   ///< the elements of point meshes
    ElementNumbers m_vertices; ///< of all meshes
    BoxTree m_tree;
};

} // namespace unprojector::ray
