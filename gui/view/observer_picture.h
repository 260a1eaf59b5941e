#pragma once

#include "core/geometry/observer_camera.h"
#include "core/scene/scene.h"
#include "core/unproject/pick.h"

#include <array>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// The second view's picture in numbers: what both the drawing and the hand go by.
///
/// The space that the observer moves in is called drawn: it is the world at t = 0; at t = 1 the cube stands in it.
struct ObserverPicture {
    geometry::EyeFrame watched; ///< the first view's camera, world space
    geometry::Projection projection;
    std::array<geometry::EyePoint, 8> corners;
    geometry::ViewVolumeMorph morph;
    double t = 0.0;
    geometry::Placement placement; ///< of the unit ball in the drawn space
    glm::dmat4 drawnFromEye;       ///< homogeneous
    glm::dmat4 drawnFromWorld;     ///< homogeneous
    glm::dmat4 clipFromDrawn;
    glm::dmat4 observerFromDrawn;     ///< rigid
    glm::dmat4 observerFromWorld;     ///< rigid: how the axes of the world stand to the observer; for light
    std::array<glm::dvec4, 6> planes; ///< world space; what they do not hold is not drawn
    geometry::Setup observer;         ///< with clip distances that hold all that is drawn
    geometry::EyeFrame observerFrame;

    /// Of an eye-space point in the drawn space; nothing where it has receded to infinity.
    std::optional<geometry::WorldPoint> drawnPoint(const geometry::EyePoint &point) const;
    bool holds(const geometry::WorldPoint &point) const;
};

/// The eye of a perspective recedes as t grows: how much of it is left, 1 to 0. That of a box stays.
float eyeOpacity(const geometry::Projection &projection, double t);

/// @param watched    the first view
/// @param extent     of the scene and the ground, world space
/// @param reference  where the cube stands at t = 1; until then it comes from where the watched camera is
/// @param observer   its camera, its surface and a symmetric perspective
/// @return nothing when the geometry or the observer is not valid
std::optional<ObserverPicture> observerPicture(const geometry::Setup &watched, const geometry::Box &extent,
                                               const geometry::Placement &reference, const geometry::Setup &observer,
                                               double t);

/// The ray through a clicked pixel, world space: from the eye (in a perspective) or the near plane (in a box) to the far
/// plane. While the camera is the one of the click, it ends on the planes as they are now.
/// @return nothing when the ray could not be computed
std::optional<geometry::Segment> rayThrough(const unproject::Pick &pick, const ObserverPicture &picture);

/// What a fitted picture holds: the eye, and the volume's corners at both ends of the morph. Each corner goes straight
/// from the one to the other, so the picture holds them all the way.
/// @param picture  with its reference where the watched camera is
std::vector<geometry::WorldPoint> pointsToFit(const ObserverPicture &picture);

/// The near or far plane whose edge is under the pointer, ready to be dragged. Nothing where none is within a few pixels, or
/// where the plane would hardly move in the picture.
/// @param size     of the widget, logical pixels
/// @param pointer  logical pixels, origin top-left
std::optional<geometry::ClipPlaneDrag> clipPlaneAt(const ObserverPicture &picture, const glm::dvec2 &size,
                                                   const glm::dvec2 &pointer);

} // namespace unprojector::gui
