#pragma once

namespace unprojector::cli {

/// What the command says to the shell.
enum class ExitCode {
    Done = 0,
    SomeRowsBad = 1,   ///< the others were computed
    UnusableInput = 2, ///< nothing could be: a scene, a header, an option, an output
};

} // namespace unprojector::cli
