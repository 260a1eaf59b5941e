#pragma once

#include "core/geometry/result.h"

#include <string>

namespace unprojector::text {
using namespace geometry;

/// The command's wording of what core reports: names the value and says what to do.
std::string errorText(const Error &error);

/// What of a view matrix is not rigid, by row and column.
/// @pre the error is ViewNotRigid
std::string viewFault(const Error &error);

} // namespace unprojector::text
