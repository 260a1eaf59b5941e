#pragma once

namespace unprojector::cli {

/// The command's exit status, the worst last.
enum class ExitCode {
    Done = 0,
    SomeRowsBad = 1,   ///< the other rows were computed
    UnusableInput = 2, ///< nothing was computed: a scene, a header, an option or an output is unusable
};

} // namespace unprojector::cli
