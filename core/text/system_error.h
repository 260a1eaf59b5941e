#pragma once

#include <string>
#include <system_error>

namespace unprojector::text {

/// What the system says of an error; where tr() does not speak English, the usual ones in its words.
std::string systemErrorText(const std::error_code &error);

/// The same of what errno says.
std::string systemErrorText(int number);

} // namespace unprojector::text
