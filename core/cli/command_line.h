#pragma once

#include "core/cli/terminal/exit_code.h"

#include <string>
#include <vector>

namespace unprojector::cli {

/// The `unproject` command.
/// @param arguments  UTF-8, the program's name first
ExitCode runCommandLine(const std::vector<std::string> &arguments);

} // namespace unprojector::cli
