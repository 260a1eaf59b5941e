#pragma once

#include "core/geometry/setup.h"
#include "core/geometry/view_volume.h"

#include <glm/ext/quaternion_double.hpp>

#include <optional>
#include <vector>

namespace unprojector::geometry {

// The second camera: it views the first one, its view volume and the scene from outside.

/// The position, rotation and scale of an object: worldFromLocal = translation * rotation * scale.
struct Placement {
    glm::dvec3 position{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    double scale = 1.0; ///< > 0
};

glm::dmat4 matrixOf(const Placement &placement);

/// Interpolates from one placement (t = 0) to another (t = 1): linearly in position, about one axis
/// in rotation, and logarithmically in scale.
Placement between(const Placement &from, const Placement &to, double t);

/// The placement of a morph's unit ball in the world that changes nothing at t = 0: the inverse of
/// `unitFromEye * eyeFromWorld`.
Placement placementOf(const EyeFrame &frame, const ViewVolumeMorph &morph);

/// The observer's default camera: 35 degrees above the horizon (world y is up), to the right of the
/// watched camera and a little behind it, one unit from `center`.
LookAt observerOf(const EyeFrame &watched, const WorldPoint &center);

enum class ClipPlane { Near, Far };

/// A drag of the near or far plane. The grabbed point slides along the line that the volume's edges
/// follow, while the view stands still. The pointer gives the distance.
class ClipPlaneDrag {
public:
    /// @param grabbed        the point of the plane that is held, eye space
    /// @param widgetFromEye  homogeneous: x / w and y / w are pixels of the view
    /// @param pointer        the pointer's position at the start of the drag, pixels
    ClipPlaneDrag(const Projection &projection, ClipPlane plane, const EyePoint &grabbed,
                  const glm::dmat4 &widgetFromEye, const glm::dvec2 &pointer);

    ClipPlane plane() const { return m_plane; }
    /// The direction in the view in which the distance grows; its length is pixels per eye unit. 0
    /// where the view looks along the line: no drag is possible then.
    const glm::dvec2 &pixelsPerUnit() const { return m_rate; }

    /// The distance at the pointer, rounded to the power of ten that a pixel resolves. Empty if the
    /// pointer has passed the line's vanishing point.
    std::optional<double> distanceAt(const glm::dvec2 &pointer) const;

    /// The projection with the dragged distance, kept valid. near stays 0.1% before far and, in a
    /// perspective, above a millionth of it. far stays below a thousand times its distance at the
    /// start.
    std::optional<Projection> projectionAt(const Projection &current, const glm::dvec2 &pointer) const;

private:
    ClipPlane m_plane;
    glm::dvec4 m_origin; ///< origin of the line in the view, homogeneous: origin + distance * direction
    glm::dvec4 m_direction;
    glm::dvec2 m_rate{0.0};
    glm::dvec2 m_offset{0.0}; ///< from the held point to the pointer
    bool m_isFacing = false;  ///< the held point is in front of the observer
    double m_deepest = 0.0;   ///< the largest distance allowed
};

} // namespace unprojector::geometry
