#include "core/cli/commands/command.h"

#include "core/base/resource.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"

#include <algorithm>
#include <cassert>

namespace unprojector::cli {
using namespace base;
namespace {

std::string_view textsOf(const std::string &name)
{
    return resource("help/command/" + name + (language() == Language::Chinese ? "_zh_CN.txt" : ".txt"));
}

} // namespace

Command::Command(CLI::App &app, const std::string &name, Run &run) : m_run(&run), m_texts(textsOf(name))
{
    m_app = app.add_subcommand(name, std::string(m_texts.substr(0, m_texts.find('\n'))));
}

void Command::onceParsed(const std::function<void()> &callback) const
{
    m_app->footer(filled(section("footer").second, {std::string(section("bad rows").second)}));
    m_app->callback(callback);
}

std::pair<std::string_view, std::string_view> Command::section(const std::string &name) const
{
    for (const std::string_view texts : {m_texts, textsOf("shared")}) {
        for (const char *end : {"]", " "}) {
            const std::string start = "\n[" + name + end;
            const std::size_t at = texts.find(start);
            if (at == texts.npos)
                continue;
            const std::size_t word = at + start.size() - (*end == ']' ? 1 : 0), text = texts.find("]\n", word) + 2;
            const std::size_t next = std::min(texts.find("\n\n[", text), texts.size() - 1);
            return {texts.substr(word, text - 2 - word), texts.substr(text, next - text)};
        }
    }
    assert(false && "each option has its text in resources/help/command");
    return {};
}

CLI::Option *Command::described(CLI::Option *option, const std::string &name, const std::string &value) const
{
    const auto [word, text] = section(name.empty() ? option->get_name(true, true) : name);
    if (!word.empty())
        option->type_name(std::string(word));
    return option->description(value.empty() ? std::string(text) : filled(text, {value}));
}

template <class Target>
CLI::Option *Command::add(const std::string &name, Target &target) const
{
    return described(m_app->add_option(name, target));
}

// The library's templates take long to compile, so no other file has them.
template CLI::Option *Command::add(const std::string &name, std::string &target) const;
template CLI::Option *Command::add(const std::string &name, std::vector<std::string> &target) const;
template CLI::Option *Command::add(const std::string &name, std::optional<double> &target) const;
template CLI::Option *Command::add(const std::string &name, std::vector<double> &target) const;

CLI::Option *Command::flag(const std::string &name, bool &target) const
{
    return described(m_app->add_flag(name, target));
}

CLI::Option *Command::file(const std::string &name, std::string &target, const std::string &section) const
{
    return described(m_app->add_option(name, target), section)->check([](const std::string &given) {
        return given.empty() ? tr("give the name of a file") : std::string();
    });
}

CLI::Option *Command::word(const std::string &name, const std::string &names,
                           const std::function<void(const std::string &)> &take,
                           const std::function<bool(const std::string &)> &isKnown) const
{
    return described(m_app->add_option_function<std::string>(name, take), {}, names)
        ->check([names, isKnown](const std::string &given) {
            std::string inLine = names;
            std::erase(inLine, '\n');
            return isKnown(given) ? std::string() : tr("\"%1\" is not one of %2", given, inLine);
        });
}

CLI::Option *Command::wholeNumber(const std::string &name, int highest, const std::function<void(int)> &take) const
{
    const auto takeWord = [take](const std::string &given) { take(numberIn<int>(given).value_or(1)); };
    return described(m_app->add_option_function<std::string>(name, takeWord), {}, std::to_string(highest))
        ->check([highest](const std::string &given) {
            const int number = numberIn<int>(given).value_or(0);
            return number >= 1 && number <= highest ? "" : tr("Value %1 not in range 1 to %2", given, highest);
        });
}

CLI::Option *Command::conventions(std::optional<geometry::Api> &target) const
{
    std::map<std::string, std::optional<geometry::Api>> choices;
    for (const geometry::Api api : geometry::kApis)
        choices.emplace(geometry::conventionsOf(api).key, api);
    return choice("--conventions", target, choices);
}

std::vector<CLI::Option *> Command::table(RowOptions &options) const
{
    return {choice("--format", options.isJson, {{"csv", false}, {"jsonl", true}}),
            flag("--no-header", options.isHeaderless), flag("--spreadsheet-safe", options.isSpreadsheetSafe)};
}

void Command::rows(RowOptions &options) const
{
    file("SCENE", options.scene)->required();
    file("POINTS", options.input);
    add("--space", options.space)->default_str("world");
    table(options);
    count("--threads", options.threads, 64);
}

} // namespace unprojector::cli
