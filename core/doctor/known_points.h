#pragma once

#include "core/doctor/hypotheses.h"

#include <span>
#include <vector>

namespace unprojector::doctor {

/// The points of the scene that equal a wrong point, rounded or truncated to its digits: the eye,
/// the view matrix's translation, the camera's centre, the world's origin and the objects' origins.
/// Returns the ones of the first point if all points equal such a point. Empty if the given digits
/// are so few that chance would find one.
std::vector<KnownPoint> knownPoints(const Given &given, const Case &scene, std::span<const Target> points);

/// The vertex that equals the first wrong point, if all points equal a vertex. It must be the only
/// one within the given digits, because on a dense mesh every point is close to some vertex.
std::vector<KnownPoint> knownVertices(const Given &given, const Case &scene, std::span<const Target> points);

} // namespace unprojector::doctor
