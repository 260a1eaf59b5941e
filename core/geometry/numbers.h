#pragma once

#include "core/base/angle.h"
#include "core/base/double_double.h"

/// Angles and numbers of 32 digits, under the names that formulas use.
namespace unprojector::geometry {

using base::Angle, base::degreesFromRadians, base::kPi, base::kRadiansPerDegree, base::radiansFromDegrees;
using base::DoubleDouble, base::DoubleDouble3, base::kPrecisePi, base::preciseSineCosine, base::preciseTangent;
using base::lostByProduct, base::lostBySum, base::Halves, base::SineCosine, base::kPreciseRadiansPerDegree;

} // namespace unprojector::geometry
