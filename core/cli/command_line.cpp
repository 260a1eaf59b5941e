#include "core/cli/command_line.h"

#include "core/base/columns.h"
#include "core/base/translation.h"
#include "core/cli/commands/command.h"
#include "core/cli/rows/byte_stream.h"
#include "core/cli/terminal/console.h"
#include "core/cli/terminal/refusal.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

namespace unprojector::cli {
using base::tr;
namespace {

constexpr std::pair<const char *, AddOptions *> kCommands[] = {
    {"points", addPoints},     {"pick", addPick},   {"project", addProject},     {"info", addInfo},
    {"scene", addScene},       {"cloud", addCloud}, {"compare", addCompare},     {"map", addMap},
    {"matrices", addMatrices}, {"code", addCode},   {"landmarks", addLandmarks}, {"doctor", addDoctor},
};

/// The library's format of --help, which counts columns as terminals do instead of bytes, and has
/// full-width colons behind Chinese.
class HelpFormatter : public CLI::Formatter {
    std::string make_option(const CLI::Option *option, bool isPositional) const override
    {
        const std::string head = "  " + make_option_name(option, isPositional) + make_option_opts(option);
        const std::string margin = '\n' + std::string(get_column_width(), ' ');
        return (base::columnsOf(head) < get_column_width() ? base::padded(head, get_column_width()) : head + margin)
               + CLI::detail::find_and_replace(make_option_desc(option), "\n", margin) + '\n';
    }
    std::string make_help(const CLI::App *app, std::string name, CLI::AppFormatMode mode) const override
    {
        std::string help = Formatter::make_help(app, std::move(name), mode);
        for (std::size_t at = help.find(':'); at != help.npos; at = help.find(':', at + 1)) {
            if (at > 0 && static_cast<unsigned char>(help[at - 1]) >= 0x80)
                help.replace(at, help.substr(at + 1).starts_with(' ') ? 2 : 1, "：");
        }
        return help;
    }
};

/// The same with its words in the user's language.
std::shared_ptr<CLI::Formatter> helpFormatter()
{
    auto formatter = std::make_shared<HelpFormatter>();
    for (const auto &[word, label] :
         {std::pair("Usage", tr("Usage")), std::pair("OPTIONS", tr("OPTIONS")),
          std::pair("SUBCOMMAND", tr("SUBCOMMAND")), std::pair("Positionals", tr("Positionals")),
          std::pair("REQUIRED", tr("REQUIRED")), std::pair("Needs", tr("Needs")),
          std::pair("Excludes", tr("Excludes"))})
        formatter->label(word, label);
    return formatter;
}

/// Sets the headings of the groups of options and commands, once all are added.
void nameGroups(CLI::App &app)
{
    for (CLI::Option *option : app.get_options())
        option->group(tr("Options"));
    for (CLI::App *command : app.get_subcommands([](CLI::App *) { return true; })) {
        command->group(tr("Subcommands"));
        nameGroups(*command);
    }
}

/// An option or positional as the user wrote it: "--at 1,2".
std::string asGiven(const CLI::App &command, const std::string &name)
{
    std::string words = name;
    if (const CLI::Option *option = command.get_option_no_throw(name)) {
        for (const std::string &word : option->results())
            words += ' ' + word;
    }
    return words;
}

/// The error in the command's words. The library's own sentence does not always name the value and
/// never gives a remedy.
std::string mistakeText(const CLI::App &app, const CLI::ParseError &error)
{
    const std::vector<const CLI::App *> commands = app.get_subcommands([](const CLI::App *) { return true; });
    const auto parsed =
        std::find_if(commands.begin(), commands.end(), [](const CLI::App *command) { return command->parsed(); });
    const CLI::App &command = parsed == commands.end() ? app : **parsed;
    const std::string called = parsed == commands.end() ? "unproject" : "unproject " + command.get_name();
    // A word that looks like an option may explain why something else is missing.
    const std::vector<std::string> left = command.remaining();
    const auto unknown = std::find_if(left.begin(), left.end(),
                                      [](const std::string &word) { return word.size() > 1 && word.front() == '-'; });
    if (unknown != left.end())
        return tr("%1 is not an option of '%2'; '%2 --help' lists them", *unknown, called);
    std::string what = error.what();
    // Words behind -- do not reach the command; the library's sentence ends with them.
    if (dynamic_cast<const CLI::ExtrasError *>(&error) != nullptr)
        return tr("\"%1\" is one argument too many for '%2'; see '%2 --help'",
                  left.empty() ? what.substr(what.find_last_of(" :") + 1) : left.back(), called);

    // The library's sentence is English, so the names are extracted from it.
    const auto parts = [&what](std::string_view between) -> std::optional<std::pair<std::string, std::string>> {
        const std::size_t at = what.find(between);
        if (at == what.npos)
            return std::nullopt;
        return std::pair(what.substr(0, at), what.substr(at + between.size()));
    };
    if (const auto both = parts(" excludes "); both && dynamic_cast<const CLI::ExcludesError *>(&error) != nullptr)
        return tr("%1 and %2 exclude each other; leave one of them out", asGiven(command, both->first),
                  asGiven(command, both->second));
    constexpr std::string_view kNoNumber = "Could not convert: ";
    if (what.starts_with(kNoNumber))
        return tr("%1: give a number",
                  asGiven(command, what.substr(kNoNumber.size(), what.find(" = ") - kNoNumber.size())));
    if (dynamic_cast<const CLI::ValidationError *>(&error) != nullptr)
        return what; // from this program's own checks, which use the user's language
    if (const auto both = parts(" requires "); both && dynamic_cast<const CLI::RequiresError *>(&error) != nullptr)
        return tr("%1 requires %2; see '%3 --help'", both->first, both->second, called);
    if (dynamic_cast<const CLI::RequiredError *>(&error) != nullptr) {
        if (what == "A subcommand is required")
            return tr("A subcommand is required; see '%1 --help'", called);
        if (const auto both = parts(" is required"))
            return tr("%1 is required; see '%2 --help'", both->first, called);
    }
    const CLI::Option *option = command.get_option_no_throw(what.substr(0, what.find(':')));
    if (option == nullptr || dynamic_cast<const CLI::ArgumentMismatch *>(&error) == nullptr)
        return tr("%1; see '%2 --help'", what, called);
    const int needed = option->get_items_expected_min();
    const std::string given = asGiven(command, option->get_name());
    return needed > 1 ? tr("%1 needs %2 or more values and got %3; see '%4 --help'", given, needed,
                           option->results().size(), called)
                      : tr("%1 needs a value, %2; see '%3 --help'", given, option->get_type_name(), called);
}

} // namespace

ExitCode runCommandLine(const std::vector<std::string> &arguments)
{
    CLI::App app(
        tr("Computes the world coordinates of pixels twice: by closed-form formulas and by the inverted matrix."),
        "unproject");
    app.allow_windows_style_options(false); // on Windows too, /scans/face.json is a file
    app.require_subcommand(1);
    app.set_help_flag("-h,--help", tr("Print this help message and exit"));
    app.set_version_flag("--version", "unproject " UNPROJECTOR_VERSION,
                         tr("Display program version information and exit"));
    app.footer(tr("For the options of a command: unproject COMMAND --help\n\nExit code: 0 done, 1 some rows bad, 2 "
                  "unusable input."));
    app.formatter(helpFormatter());
    Run run;
    std::string names;
    bool isKnown = false;
    for (const auto &[name, addOptions] : kCommands) {
        const Command command(app, name, run);
        names += (names.empty() ? "" : ", ") + std::string(name);
        isKnown = isKnown || (arguments.size() > 1 && arguments[1] == name);
        // Only a command among the words needs its options.
        if (std::find(arguments.begin(), arguments.end(), name) != arguments.end())
            addOptions(command);
    }
    nameGroups(app);
    // The library would only report that a command is missing.
    if (arguments.size() > 1 && !arguments[1].starts_with('-') && !isKnown) {
        complain(tr("\"%1\" is not a command; give one of %2", arguments[1], names));
        return ExitCode::UnusableInput;
    }
    try {
        std::vector<const char *> words;
        words.reserve(arguments.size());
        for (const std::string &argument : arguments)
            words.push_back(argument.c_str());
        app.parse(static_cast<int>(words.size()), words.data());
        return run(); // it may find that an option is missing
    } catch (const Refused &) {
        return ExitCode::UnusableInput;
    } catch (const CLI::ParseError &error) {
        std::ostringstream output, errors;
        const bool isDone = app.exit(error, output, errors) == 0; // help and version arrive here too
        if (!errors.str().empty())
            complain(mistakeText(app, error));
        ByteSink sink("-", {});
        sink.print(output.str());
        const ExitCode written = sink.finish();
        return isDone ? written : ExitCode::UnusableInput;
    }
}

} // namespace unprojector::cli
