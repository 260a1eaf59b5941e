#pragma once

#include "core/geometry/result.h"

#include <string>

namespace unprojector::geometry {

/// Describes an error of a value and the remedy. Names the value; no capital and no full stop,
/// since it is a part of a line:
///
///   near is 100; it must be smaller than far (100)
std::string errorText(const geometry::Error &error);

} // namespace unprojector::geometry
