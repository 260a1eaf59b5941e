#pragma once

#include "core/geometry/projection.h"

#include <glm/vec2.hpp>

namespace unprojector::geometry {

/// The box of a parallel projection; null for a perspective.
Ortho *boxOf(Projection &projection);

/// The shear of a projection: how far a box's x and y shift per unit in front of the eye. 0 unless it is
/// oblique.
glm::dvec2 shearOf(const Projection &projection);

} // namespace unprojector::geometry
