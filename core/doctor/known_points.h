#pragma once

#include "core/doctor/hypotheses.h"

#include <span>
#include <vector>

namespace unprojector::doctor {

/// The points of the scene that a wrong point is, as rounded to its digits or cut off behind them: the eye, the view matrix's translation, the camera's
/// centre, the world's origin and those of the objects. Those of the first point, if all points are such ones; none where the
/// digits given would let chance find one.
std::vector<KnownPoint> knownPoints(const Given &given, const Case &scene, std::span<const Target> points);

/// The vertex that a wrong point is, that of the first point if all points are vertices. Only one that is alone within the digits
/// given: on a dense mesh every point is close to some vertex.
std::vector<KnownPoint> knownVertices(const Given &given, const Case &scene, std::span<const Target> points);

} // namespace unprojector::doctor
