#pragma once

#include "core/cli/terminal/exit_code.h"

#include <CLI/CLI.hpp>

#include <functional>

namespace unprojector::cli {

/// The command that was asked for, with its options.
using Run = std::function<ExitCode()>;

// What each command is called with, and its help. Each is added to the program; when it is the one that is asked for, it sets
// what is to be run.

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
