#pragma once

#include "core/cli/rows/row_stream.h"
#include "core/cli/terminal/exit_code.h"

#include <string>

namespace unprojector::cli {

/// Runs `unproject project`: reads points, writes every stage on their way to the window and the
/// input of `unproject points`: px, py and the depth. That depth is window_z. For a point on the
/// near or far plane within rounding it is the plane's depth, because window_z may lie slightly
/// outside the depth range.
/// @param options  space: world or object:NAME
/// @param distortion  coefficients or a file, see sceneLens: px and py are then of the distorted
///         image; empty: of the pinhole's, as all other columns
ExitCode runProject(const RowOptions &options, const std::string &distortion);

} // namespace unprojector::cli
