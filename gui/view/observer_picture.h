#pragma once

#include "core/geometry/observer_camera.h"
#include "core/scene/scene.h"
#include "core/unproject/pick.h"

#include <array>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// The geometry of the second view, for drawing and for mouse input.
///
/// The space that the observer moves in is called drawn: it is the world at t = 0; at t = 1 it
/// contains the cube.
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
    glm::dmat4 observerFromWorld;     ///< rigid: the orientation of the world's axes to the observer; for light
    std::array<glm::dvec4, 6> planes; ///< world space; points outside them are not drawn
    geometry::Setup observer;         ///< with clip distances that enclose everything drawn
    geometry::EyeFrame observerFrame;

    /// An eye-space point in the drawn space; nothing if it has receded to infinity.
    std::optional<geometry::WorldPoint> drawnPoint(const geometry::EyePoint &point) const;
    bool holds(const geometry::WorldPoint &point) const;
};

/// The opacity of a perspective's eye, 1 to 0: it recedes as t grows. The eye of a box stays.
float eyeOpacity(const geometry::Projection &projection, double t);

/// @param watched    the first view
/// @param extent     of the scene and the ground, world space
/// @param reference  the cube's placement at t = 1; it moves there from the watched camera
/// @param observer   its camera, its surface and a symmetric perspective
/// @return nothing if the setup or the observer is not valid
std::optional<ObserverPicture> observerPicture(const geometry::Setup &watched, const geometry::Box &extent,
                                               const geometry::Placement &reference, const geometry::Setup &observer,
                                               double t);

/// The ray through a clicked pixel, world space: from the eye (in a perspective) or the near plane
/// (in a box) to the far plane. While the camera is the one of the click, it ends on the current
/// planes.
/// @return nothing if the ray could not be computed
std::optional<geometry::Segment> rayThrough(const unproject::Pick &pick, const ObserverPicture &picture);

/// The points that a fitted view contains: the eye, and the volume's corners at both ends of the
/// morph. Each corner moves straight, so the view contains them at every t.
/// @param picture  with its reference at the watched camera
std::vector<geometry::WorldPoint> pointsToFit(const ObserverPicture &picture);

/// The near or far plane whose edge is under the pointer, ready to be dragged. Nothing if none is
/// within a few pixels, or if the plane would hardly move in the view.
/// @param size     of the widget, logical pixels
/// @param pointer  logical pixels, origin top-left
std::optional<geometry::ClipPlaneDrag> clipPlaneAt(const ObserverPicture &picture, const glm::dvec2 &size,
                                                   const glm::dvec2 &pointer);

} // namespace unprojector::gui
