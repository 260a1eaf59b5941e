#pragma once

#include "core/mesh/mesh.h"
#include "core/ray/ray.h"

#include <glm/vec3.hpp>

#include <optional>

namespace unprojector::ray {

/// A ray in unit space, in single precision.
struct UnitRay {
    glm::vec3 from, along; ///< `along` has length 1
    float length;          ///< the length of the ray
    double start, scale;   ///< t = start + s / scale at the length s

    /// The length that includes everything before t.
    float lengthTo(double t) const;
};

/// The space that trees are built in: a model's box moved and scaled into [-1, 1]^3, so that single
/// precision suits models of any size and position. Its boxes are wider than their contents by
/// `kMargin`, more than the error of a ray in single precision. So a tree may find too many
/// triangles, but never too few.
class UnitSpace {
public:
    static constexpr float kMargin = 0x1p-19f;

    /// @param model  one that has triangles or points
    explicit UnitSpace(const mesh::Model &model);

    /// Converts a position relative to a mesh's origin. Its rounding to single precision is less
    /// than an eighth of kMargin.
    glm::vec3 at(const glm::dvec3 &origin, const glm::vec3 &position) const
    {
        return glm::vec3(((origin - m_center) + glm::dvec3(position)) * m_scale);
    }
    /// The centre in the conversion from unit space: object = center + unit * size.
    const glm::dvec3 &center() const { return m_center; }
    double scale() const { return m_scale; }
    /// The inverse of scale().
    double size() const { return m_size; }

    /// The part of a ray that lies in the box; nothing if it misses.
    std::optional<UnitRay> inside(const Ray<geometry::ObjectSpace> &ray) const;

private:
    glm::dvec3 m_center;
    double m_size, m_scale;
};

} // namespace unprojector::ray
