#pragma once

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace unprojector::cli {

/// How --help looks: in English as the library has it; in Chinese with columns counted as terminals do, and wrapped to 80.
std::shared_ptr<CLI::Formatter> helpFormatter();

/// Gives the groups of options and commands their headings, once all are there.
void nameGroups(CLI::App &app);

/// What is to be typed, as "FILE" says it.
std::string typeName(const std::string &english);

} // namespace unprojector::cli
