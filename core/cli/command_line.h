#pragma once

#include "core/cli/exit_code.h"

namespace unprojector {

/// The `unproject` command.
ExitCode runCommandLine(int argc, char **argv);

} // namespace unprojector
