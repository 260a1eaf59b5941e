#pragma once

#include "core/cli/rows/byte_stream.h"
#include "core/geometry/error_text.h"

#include <optional>
#include <string>
#include <utility>

namespace unprojector::cli {

/// Ends the run of a command as ExitCode::UnusableInput, after the reason was printed.
struct Refused {};

/// Prints the reason on stderr and ends the run.
[[noreturn]] inline void refuse(const std::string &reason)
{
    complain(reason);
    throw Refused();
}

/// The value; without one the run ends. Its maker has printed the reason.
template <class Value>
Value needed(std::optional<Value> value)
{
    if (!value)
        throw Refused();
    return *std::move(value);
}

/// The value, or the end of the run with the error.
/// @param name  of the input, for the message
template <class Value>
Value needed(geometry::Result<Value> result, const std::string &name)
{
    if (!result)
        refuse(name + ": " + errorText(result.error()));
    return std::move(result).value();
}

/// Checks that an output is no input of the run.
/// @param output  empty: there is none
inline void checkNotInput(const std::string &output, const InputFiles &inputs)
{
    if (isOverInput(output, inputs))
        throw Refused();
}

/// A source or sink of bytes that is open; else the run ends.
template <class Stream>
struct Opened : Stream {
    template <class... Arguments>
    explicit Opened(const Arguments &...arguments) : Stream(arguments...)
    {
        if (!this->isOpen())
            throw Refused();
    }
};
using Input = Opened<ByteSource>;
using Output = Opened<ByteSink>;

} // namespace unprojector::cli
