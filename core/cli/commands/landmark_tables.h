#pragma once

#include "core/cli/commands/landmarks_command.h"
#include "core/cli/terminal/exit_code.h"

namespace unprojector::cli {

/// Makes one table of the landmark files of a folder, with the measures of a protocol if there is one.
/// @return SomeRowsBad where files of the folder could not be read
ExitCode makeTable(const LandmarksOptions &options);

/// Writes the mean and the scatter of landmarks that were placed several times, and their error of
/// measurement over all specimens.
/// @return SomeRowsBad where files of a folder could not be read
ExitCode makeRepeats(const LandmarksOptions &options);

} // namespace unprojector::cli
