#pragma once

#include "unprojector/result.h"

#include "core/geometry/result.h"
#include "core/text/error_text.h"

namespace unprojector {

/// The public error of a value.
inline Error valueError(const geometry::Error &error)
{
    return {Error::Kind::Value, text::errorText(error)};
}

} // namespace unprojector
