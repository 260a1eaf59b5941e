#pragma once

#include "core/cli/rows/row_table.h"
#include "core/geometry/api_conventions.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace unprojector::cli {

/// Runs the command that the user chose, with its options.
using Run = std::function<ExitCode()>;

/// A command and the declaration of its options. The texts are those of resources/help/command/NAME.txt, and of
/// shared.txt there for what several commands have:
///
///   What the command does
///
///   [--space TEXT]
///   The description of an option or positional, under its name and the word for its value. %1 is
///   the list of the words that can be chosen, or the highest number.
///
///   [footer]
///   The end of the help. %1 are the sentences about bad rows.
class Command {
public:
    /// @param run  set if the user chooses the command
    Command(CLI::App &app, const std::string &name, Run &run);

    /// @tparam Target  std::string, std::vector<std::string>, std::optional<double> or std::vector<double>
    template <class Target>
    CLI::Option *add(const std::string &name, Target &target) const;
    CLI::Option *flag(const std::string &name, bool &target) const;
    /// @param section  empty: the name
    CLI::Option *file(const std::string &name, std::string &target, const std::string &section = {}) const;
    CLI::Option *modelOrScene(std::string &target) const { return file("SCENE", target, "MODEL-OR-SCENE")->required(); }

    /// An option that takes a word.
    /// @param names  the known words, for texts
    CLI::Option *word(const std::string &name, const std::string &names,
                      const std::function<void(const std::string &)> &take,
                      const std::function<bool(const std::string &)> &isKnown) const;
    /// An option with a fixed set of words.
    /// @param target  holds the default
    template <class Choice>
    CLI::Option *choice(const std::string &name, Choice &target, const std::map<std::string, Choice> &choices) const
    {
        std::string names, usual;
        for (const auto &[word, value] : choices) {
            names += (names.empty() ? "" : ", ") + word;
            usual = value == target ? word : usual;
        }
        return word(
                   name, names, [&target, choices](const std::string &given) { target = choices.at(given); },
                   [choices](const std::string &given) { return choices.contains(given); })
            ->default_str(usual);
    }
    CLI::Option *conventions(std::optional<geometry::Api> &target) const;
    /// An option that takes a whole number from 1.
    /// @param target  holds the default; 0: none
    template <class Count>
    void count(const std::string &name, Count &target, int highest) const
    {
        const std::string usual = target == 0 ? std::string() : std::to_string(target);
        wholeNumber(name, highest, [&target](int number) { target = static_cast<Count>(number); })->default_str(usual);
    }

    /// The options of tables of rows: --format, --no-header and --spreadsheet-safe.
    /// @return all of them
    std::vector<CLI::Option *> table(RowOptions &options) const;
    /// The options of commands that take rows of numbers.
    void rows(RowOptions &options) const;

    bool has(const std::string &option) const { return m_app->count(option) > 0; }

    /// Sets what runs if the user chose the command.
    template <class Options, class Function>
    void runs(const std::shared_ptr<Options> &options, Function function) const
    {
        onceParsed([options, function, run = m_run] { *run = [=] { return function(*options); }; });
    }

private:
    void onceParsed(const std::function<void()> &callback) const;
    CLI::Option *wholeNumber(const std::string &name, int highest, const std::function<void(int)> &take) const;
    /// The heading after the name, and the text under it.
    std::pair<std::string_view, std::string_view> section(const std::string &name) const;
    CLI::Option *described(CLI::Option *option, const std::string &section = {}, const std::string &value = {}) const;

    CLI::App *m_app;
    Run *m_run;
    std::string_view m_texts;
};

/// Adds the options of a command and its run.
using AddOptions = void(const Command &command);

AddOptions addPoints, addPick, addProject, addInfo, addScene, addCloud, addCompare, addMap, addMatrices, addCode,
    addLandmarks, addDoctor;

} // namespace unprojector::cli
