#pragma once

#include "core/doctor/program.h"

namespace unprojector::doctor {

// Changes to the numbers of a projection matrix, for mistakes of the stages Lens and Eye.

/// The tangent of half the vertical angle of a symmetric frustum.
double tangentOf(const Run &run);
double verticalFov(const Run &run);
double aspectOf(const Run &run);

/// Widens both axes by a factor.
void widen(Run &run, double factor);
void setTangent(Run &run, double tangent);
void setAspect(Run &run, double aspect);

/// Sets the depth entries of the projection matrix for other clip distances; both planes keep their
/// NDC depths.
void setClipDistances(Run &run, double nearDistance, double farDistance);

// Variants with another near or far plane, their value included.

Variant withOtherPlanes(double nearDistance, double farDistance);
Variant withOtherNear(const Given &given, double nearDistance);
/// The numbers of glFrustum's window stay, so that x and y are scaled with near.
Variant withOtherNearOfFrustum(const Given &given, double nearDistance);
Variant withOtherFar(const Given &given, double farDistance);

} // namespace unprojector::doctor
