#pragma once

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace unprojector::cli {

/// The library's format of --help, with its words in the user's language.
std::shared_ptr<CLI::Formatter> helpFormatter();

/// Sets the headings of the groups of options and commands, once all are added.
void nameGroups(CLI::App &app);

} // namespace unprojector::cli
