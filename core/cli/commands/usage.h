#pragma once

#include "core/cli/terminal/exit_code.h"

#include <CLI/CLI.hpp>

#include <functional>

namespace unprojector::cli {

/// Runs the command that the user chose, with its options.
using Run = std::function<ExitCode()>;

// Each function adds a command, its options and its help to the program. If the user chose that
// command, it sets the function to run.

// usage_of_points.cpp
void addPoints(CLI::App &app, Run &run);
void addPick(CLI::App &app, Run &run);
void addProject(CLI::App &app, Run &run);
void addCloud(CLI::App &app, Run &run);
void addDoctor(CLI::App &app, Run &run);

// usage_of_scenes.cpp
void addInfo(CLI::App &app, Run &run);
void addScene(CLI::App &app, Run &run);
void addMatrices(CLI::App &app, Run &run);
void addCode(CLI::App &app, Run &run);
void addCompare(CLI::App &app, Run &run);
void addMap(CLI::App &app, Run &run);
void addLandmarks(CLI::App &app, Run &run);

} // namespace unprojector::cli
