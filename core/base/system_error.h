#pragma once

#include <string>
#include <system_error>

namespace unprojector::base {

/// The system's message for an error. If tr() is not set to English, the common errors are
/// translated.
std::string systemErrorText(const std::error_code &error);

/// The same for a value of errno.
std::string systemErrorText(int number);

} // namespace unprojector::base
