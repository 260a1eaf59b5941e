#pragma once

#include "core/cli/terminal/exit_code.h"

#include <CLI/CLI.hpp>

#include <functional>

namespace unprojector::cli {

/// Runs the command that the user chose, with its options.
using Run = std::function<ExitCode()>;

/// Adds a command, its options and its help to the program. If the user chose that command, it sets
/// the function to run.
using AddCommand = void(CLI::App &app, Run &run);

AddCommand addPoints, addPick, addProject, addInfo, addScene, addCloud, addCompare, addMap, addMatrices, addCode,
    addLandmarks, addDoctor;

} // namespace unprojector::cli
