#pragma once

#include "core/base/error.h"
#include "core/geometry/error_text.h"

#include <string>
#include <string_view>
#include <utility>

namespace unprojector::cli {

/// Prints a line on stderr, formatted by base::printableLine. A progress bar is erased first.
void complain(std::string_view line);

/// Ends the run of a command as ExitCode::UnusableInput, after the reason was printed.
struct Refused {};
/// Prints the reason on stderr and ends the run.
[[noreturn]] void refuse(std::string_view reason);

/// The value, or the end of the run with the error.
/// @param name  of the input, for the message
template <class Value>
Value needed(geometry::Result<Value> result, const std::string &name)
{
    if (!result)
        refuse(name + ": " + errorText(result.error()));
    return std::move(result).value();
}

template <class Value>
Value needed(base::Expected<Value, base::Error> result)
{
    if (!result)
        refuse(result.error().message());
    return std::move(result).value();
}

} // namespace unprojector::cli
