#pragma once

#include "core/base/translation.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <map>
#include <string>

namespace unprojector::cli {

// Options shared by several commands. Descriptions are in the language of base::tr().

/// Adds an option with a fixed set of words.
/// @param target  holds the default
template <class Choice>
CLI::Option *addChoice(CLI::App &command, const std::string &name, Choice &target,
                       const std::map<std::string, Choice> &choices, const std::string &description)
{
    std::string names, usual;
    for (const auto &[word, choice] : choices) {
        names += (names.empty() ? "" : ", ") + word;
        usual = choice == target ? word : usual;
    }
    return command
        .add_option_function<std::string>(
            name, [&target, choices](const std::string &given) { target = choices.at(given); },
            description + ": " + names)
        ->type_name("WORD")
        ->default_str(usual)
        ->check([choices, names](const std::string &given) {
            return choices.contains(given) ? std::string() : base::tr("\"%1\" is not one of %2", given, names);
        });
}

/// The check of an option that takes a whole number from 1 to `highest`.
std::function<std::string(const std::string &)> wholeNumber(int highest);

/// @param target  holds the default
template <class Count>
void addCount(CLI::App &command, const std::string &name, Count &target, int highest, const std::string &description)
{
    command.add_option(name, target, base::tr("%1, 1 to %2", description, highest))
        ->type_name("N")
        ->default_str(std::to_string(target))
        ->check(wholeNumber(highest));
}

/// Adds the spreadsheet-safe option, for commands that write tables with names.
CLI::Option *addSpreadsheetSafe(CLI::App &command, bool &target);
CLI::Option *addFile(CLI::App &command, const std::string &name, std::string &target, const std::string &description);
void addSceneFile(CLI::App &command, std::string &target);
CLI::Option *addModelOrScene(CLI::App &command, std::string &target);

} // namespace unprojector::cli
