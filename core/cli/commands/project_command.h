#pragma once

#include "core/cli/rows/row_stream.h"
#include "core/cli/terminal/exit_code.h"

namespace unprojector::cli {

/// `unproject project`: points in, every stage on their way to the window out, and what `unproject points` takes: px, py and
/// the depth. That depth is window_z, but for a point that lies on the near or far plane as far as can be told: there it is
/// the plane's, though rounding may have put window_z a little outside the depth range.
/// @param options  space: world or object:NAME
ExitCode runProject(const RowOptions &options);

} // namespace unprojector::cli
