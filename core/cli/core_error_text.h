#pragma once

#include "core/result.h"

#include <string>

namespace unprojector {

/// The command's wording of what core reports: names the value and says what to do.
std::string errorText(const Error &error);

} // namespace unprojector
