#pragma once

#include "core/landmarks/landmark.h"

namespace fuzz {

/// Leads the first curves of a set over a small mesh, as a window does after opening them. Ends the
/// program where a curve does not end, leaves the mesh, or is no number.
void leadCurves(const unprojector::landmarks::LandmarkSet &set);

} // namespace fuzz
