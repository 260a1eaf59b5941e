#pragma once

#include "core/base/error.h"
#include "core/cli/rows/byte_stream.h"
#include "core/geometry/error_text.h"

#include <string>
#include <utility>

namespace unprojector::cli {

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
