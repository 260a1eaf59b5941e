#pragma once

#include "core/geometry/result.h"

#include <string>

namespace unprojector::text {

/// What is wrong with a value and what to do: names the value; without a capital and a full stop, as a part of a line:
///
///   near is 100; it must be smaller than far (100)
std::string errorText(const geometry::Error &error);

} // namespace unprojector::text
