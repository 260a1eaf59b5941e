#include "core/cli/terminal/help_formatter.h"

#include "core/base/translation.h"

#include <utility>

namespace unprojector::cli {
using base::tr;
std::shared_ptr<CLI::Formatter> helpFormatter()
{
    auto formatter = std::make_shared<CLI::Formatter>();
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
