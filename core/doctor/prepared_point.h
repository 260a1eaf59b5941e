#pragma once

#include "core/doctor/hypotheses.h"

#include <cstddef>
#include <optional>
#include <span>

namespace unprojector::doctor {

/// A prepared point, with the source of its depth.
struct Prepared {
    Target target;
    Target right; ///< the right program's possible answers: for an unknown depth, anything between near and far
    Click click;
    DepthKnown depthKnown = DepthKnown::Given;
    std::optional<geometry::WorldPoint> onMesh; ///< where the depth is from the mesh
    std::optional<glm::dvec3> projected;
};

/// @return NotFinite for a number; DepthOutsideRange
geometry::Check checkPoint(const Case &scene, const WrongPoint &point);

/// The clicks and the digits of a wrong point, for diagnose().
/// @param epsilon  of the precision that the program computes in: of double or of float
Prepared prepared(const Case &scene, const Given &given, const WrongPoint &point, double epsilon);

/// The depth of the mesh at a position; empty on the background, and where there is no mesh.
std::optional<double> depthOnMesh(const Case &scene, const geometry::DevicePoint &position);

/// See Diagnosis::right.
std::optional<glm::dvec3> rightPoint(const Case &scene, const WrongPoint &point, const Prepared &prepared);
/// See Diagnosis::rightLastDigit.
double rightLastDigit(const Given &given, const Prepared &point, const glm::dvec3 &right,
                      const glm::dvec3 &lastDigitGiven);

/// The hypothesis of no mistake.
Hypothesis rightHypothesis(const Given &given, std::span<const Prepared> points);

/// The change of the projected position when the point moves within its last digits. Empty in the
/// plane of the eye.
std::optional<glm::dvec3> unsureOf(const Given &given, const Prepared &point);

/// The error of a point after projection with the right matrices.
ErrorKind wrongOf(const Given &given, const Prepared &point);

/// The count of numbers that had to agree for an explanation, see Evidence.
int agreeing(std::span<const Prepared> points, std::span<const ErrorKind> wrongs);

/// The mean over the points of the greatest coordinate, units of the last digit. Few digits near the
/// origin are explained by chance more often than their distance from the right point tells.
double sizeOf(const Given &given);

} // namespace unprojector::doctor
