#pragma once

#include "core/doctor/program.h"

namespace unprojector::doctor {

// Changes to the numbers of a projection matrix, for mistakes of the stages Lens and Eye.

double verticalFov(const Run &run);
double aspectOf(const Run &run);

/// Widens both axes by a factor.
void widen(Run &run, double factor);
void setTangent(Run &run, double tangent);
void setAspect(Run &run, double aspect);

// Variants with another near or far plane, their value included.

Variant withOtherPlanes(double nearDistance, double farDistance);
Variant withOtherNear(const Given &given, double nearDistance);
/// The numbers of glFrustum's window stay, so that x and y are scaled with near.
Variant withOtherNearOfFrustum(const Given &given, double nearDistance);
Variant withOtherFar(const Given &given, double farDistance);

} // namespace unprojector::doctor
