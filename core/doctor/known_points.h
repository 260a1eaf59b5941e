#pragma once

#include "core/doctor/hypotheses.h"
#include "core/scene/scene.h"

#include <span>
#include <vector>

namespace unprojector::doctor {

/// Points of the scene, and the chance that an arbitrary point equals one of them in its digits.
struct KnownPoints {
    std::vector<KnownPoint> points;
    double chance = 1.0; ///< 0 if the given numbers are exactly those of a point of the scene
};

/// The points of the scene that equal a wrong point, rounded to its digits: the eye, the view
/// matrix's translation, the camera's centre, the world's origin and the objects' origins. A
/// coordinate of several digits may also be truncated. Returns the ones of the first point if all
/// points equal such a point.
KnownPoints knownPoints(const Given &given, const Case &scene);

/// The vertex that equals the first wrong point, if all points equal a vertex. It must be the only
/// one within the given digits, because on a dense mesh every point is close to some vertex.
std::vector<KnownPoint> knownVertices(const Given &given, const Case &scene);

/// The vertices of the visible objects in a box of world space, including its faces, for
/// Case::verticesIn. It tests every vertex, so no tree is needed. One per position, at most a
/// thousand.
std::vector<KnownPoint> verticesIn(std::span<const scene::SceneObject> objects, const geometry::Box &world);

} // namespace unprojector::doctor
