#include "core/cli/terminal/help_formatter.h"

#include "core/base/columns.h"
#include "core/base/translation.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace unprojector::cli {
using namespace base;
namespace {

constexpr std::size_t kColumns = 80;
constexpr std::size_t kDescriptions = 30; ///< column in which descriptions begin

/// Replaces the library's colons behind Chinese words by Chinese ones; they occupy as many columns
/// as a colon and a blank.
std::string withChineseColons(const std::string &text)
{
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool isBehindChinese = i > 0 && static_cast<unsigned char>(text[i - 1]) >= 0x80;
        const char next = i + 1 < text.size() ? text[i + 1] : '\n';
        if (text[i] != ':' || !isBehindChinese || (next != ' ' && next != '\n')) {
            result += text[i];
            continue;
        }
        result += "：";
        i += next == ' ' ? 1 : 0;
    }
    return result;
}

class ChineseFormatter : public CLI::Formatter {
public:
    std::string make_help(const CLI::App *app, std::string name, CLI::AppFormatMode mode) const override
    {
        return withChineseColons(Formatter::make_help(app, std::move(name), mode));
    }
    std::string make_description(const CLI::App *app) const override
    {
        return wrapped(app->get_description(), kColumns) + '\n';
    }
    /// Examples and lists begin with blanks and stay unchanged.
    std::string make_footer(const CLI::App *app) const override
    {
        const std::string footer = app->get_footer();
        std::string result;
        for (std::size_t start = 0; start < footer.size();) {
            const std::size_t end = std::min(footer.find('\n', start), footer.size());
            const std::string line = footer.substr(start, end - start);
            result += (line.starts_with(' ') ? line : wrapped(line, kColumns)) + '\n';
            start = end + 1;
        }
        return result;
    }
    std::string make_option(const CLI::Option *option, bool isPositional) const override
    {
        return entry(make_option_name(option, isPositional) + make_option_opts(option), make_option_desc(option));
    }
    std::string make_subcommand(const CLI::App *command) const override
    {
        return entry(command->get_name(), command->get_description());
    }

private:
    static std::string entry(const std::string &name, const std::string &description)
    {
        const std::string head = "  " + name;
        return (columnsOf(head) < kDescriptions ? padded(head, kDescriptions)
                                                : head + '\n' + std::string(kDescriptions, ' '))
               + wrapped(withChineseColons(description), kColumns, kDescriptions) + '\n';
    }
};

} // namespace

std::shared_ptr<CLI::Formatter> helpFormatter()
{
    auto formatter =
        language() == Language::Chinese ? std::make_shared<ChineseFormatter>() : std::make_shared<CLI::Formatter>();
    for (const auto &[word, label] :
         {std::pair("Usage", tr("Usage")), std::pair("OPTIONS", tr("OPTIONS")),
          std::pair("SUBCOMMAND", tr("SUBCOMMAND")), std::pair("Positionals", tr("Positionals")),
          std::pair("REQUIRED", tr("REQUIRED")), std::pair("Needs", tr("Needs")),
          std::pair("Excludes", tr("Excludes"))})
        formatter->label(word, label);
    return formatter;
}

void nameGroups(CLI::App &app)
{
    for (CLI::Option *option : app.get_options())
        option->group(tr("Options"));
    for (CLI::App *command : app.get_subcommands([](CLI::App *) { return true; })) {
        command->group(tr("Subcommands"));
        nameGroups(*command);
    }
}

} // namespace unprojector::cli
