#pragma once

#include "core/geometry/result.h"

#include <string>

namespace unprojector::text {
using namespace geometry;

/// The command's wording of what core reports: names the value and says what to do.
std::string errorText(const Error &error);

} // namespace unprojector::text
