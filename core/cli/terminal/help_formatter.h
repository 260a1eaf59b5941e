#pragma once

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace unprojector::cli {

/// The format of --help: in English the library's; in Chinese with columns counted as terminals do,
/// and wrapped to 80.
std::shared_ptr<CLI::Formatter> helpFormatter();

/// Sets the headings of the groups of options and commands, once all are added.
void nameGroups(CLI::App &app);

} // namespace unprojector::cli
