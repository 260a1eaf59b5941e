#pragma once

#include "core/geometry/setup.h"
#include "core/geometry/view_volume.h"

#include <glm/ext/quaternion_double.hpp>

#include <optional>
#include <vector>

namespace unprojector::geometry {

// The second camera: it looks at the first one, at its view volume and at the scene, from outside.

/// Where something stands: worldFromLocal = translation * rotation * scale.
struct Placement {
    glm::dvec3 position{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    double scale = 1.0; ///< > 0
};

glm::dmat4 matrixOf(const Placement &placement);

/// From one placement (t = 0) to another (t = 1): evenly along the line, about one axis, and in the logarithm of the scale.
Placement between(const Placement &from, const Placement &to, double t);

/// Where the unit ball of a morph stands in the world, so that at t = 0 all is where it is: the inverse of
/// `unitFromEye * eyeFromWorld`.
Placement placementOf(const EyeFrame &frame, const ViewVolumeMorph &morph);

/// The default place of the observer: 35 degrees above the horizon (world y is up), at the watched camera's right and a
/// little behind it, one unit from `center`.
LookAt observerOf(const EyeFrame &watched, const WorldPoint &center);

enum class ClipPlane { Near, Far };

/// The near or far plane in the hand: a point of it slides on the line that the volume's edges follow, in a picture
/// that stands still, and the pointer says how far.
class ClipPlaneDrag {
public:
    /// @param grabbed        the point of the plane that is held, eye space
    /// @param widgetFromEye  homogeneous: x / w and y / w are pixels of the picture
    /// @param pointer        where the hand took hold, pixels
    ClipPlaneDrag(const Projection &projection, ClipPlane plane, const EyePoint &grabbed,
                  const glm::dmat4 &widgetFromEye, const glm::dvec2 &pointer);

    ClipPlane plane() const { return m_plane; }
    /// The direction in the picture in which the distance grows; its length is pixels per eye unit. 0 when the picture
    /// looks along the line: then nothing can be dragged.
    const glm::dvec2 &pixelsPerUnit() const { return m_rate; }

    /// The distance that the pointer asks for, rounded to the power of ten that a pixel resolves; nothing when the pointer
    /// has passed the line's vanishing point.
    std::optional<double> distanceAt(const glm::dvec2 &pointer) const;

    /// The projection with the dragged distance, kept valid: near stays 0.1% before far (and, in a perspective, above
    /// a millionth of it), far comes no farther than a thousand times its place at the start.
    std::optional<Projection> projectionAt(const Projection &current, const glm::dvec2 &pointer) const;

private:
    ClipPlane m_plane;
    glm::dvec4 m_origin; ///< of the line in the picture, homogeneous: origin + distance * direction
    glm::dvec4 m_direction;
    glm::dvec2 m_rate{0.0};
    glm::dvec2 m_offset{0.0}; ///< from the held point to the pointer
    bool m_isFacing = false;  ///< the held point stands in front of the observer
    double m_deepest = 0.0;   ///< the largest distance allowed
};

} // namespace unprojector::geometry
