#pragma once

#include "core/mesh/mesh.h"
#include "core/ray/ray.h"

#include <glm/vec3.hpp>

#include <optional>

namespace unprojector::ray {

/// A ray in unit space, in single precision.
struct UnitRay {
    glm::vec3 from, along; ///< `along` has length 1
    float length;          ///< it ends after so much
    double start, scale;   ///< t = start + s / scale at the length s

    /// The length at which nothing before t is cut off.
    float lengthTo(double t) const;
};

/// The space that trees are built in: a model's box moved and shrunk into [-1, 1]^3, so that single precision serves models of
/// any size, anywhere. Boxes in it are wider than what they hold by `kMargin`, which is more than a ray in single
/// precision strays from the exact one inside: a tree may name too many triangles, but never leaves one out.
class UnitSpace {
public:
    static constexpr float kMargin = 0x1p-19f;

    /// @param bounds  object space, not empty, finite
    explicit UnitSpace(const geometry::Box &bounds);

    /// A position relative to a mesh's origin. Its rounding to single precision is less than an eighth of kMargin.
    glm::vec3 at(const glm::dvec3 &origin, const glm::vec3 &position) const
    {
        return glm::vec3(((origin - m_center) + glm::dvec3(position)) * m_scale);
    }
    /// From unit space back: object = center + unit * size.
    const glm::dvec3 &center() const { return m_center; }
    double scale() const { return m_scale; }
    /// Its inverse.
    double size() const { return m_size; }

    /// The part of a ray that lies in the box; nothing where it misses it.
    std::optional<UnitRay> inside(const Ray<geometry::ObjectSpace> &ray) const;

private:
    glm::dvec3 m_center;
    double m_size, m_scale;
};

} // namespace unprojector::ray
