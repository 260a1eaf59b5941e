#include "core/cli/commands/usage_options.h"

#include <charconv>
#include <system_error>

namespace unprojector::cli {
using base::tr;

std::function<std::string(const std::string &)> wholeNumber(int highest)
{
    return [highest](const std::string &given) {
        int number = 0;
        const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), number);
        const bool isOne = error == std::errc{} && end == given.data() + given.size();
        return isOne && number >= 1 && number <= highest ? std::string()
                                                         : tr("Value %1 not in range 1 to %2", given, highest);
    };
}

CLI::Option *addSpreadsheetSafe(CLI::App &command, bool &target)
{
    return command.add_flag(
        "--spreadsheet-safe", target,
        tr("In CSV, put an apostrophe before texts that a spreadsheet would read as formulas (=, +, -, @)"));
}

CLI::Option *addFile(CLI::App &command, const std::string &name, std::string &target, const std::string &description)
{
    return command.add_option(name, target, description)->type_name("FILE")->check([](const std::string &given) {
        return given.empty() ? std::string(tr("give the name of a file")) : std::string();
    });
}

void addSceneFile(CLI::App &command, std::string &target)
{
    addFile(command, "SCENE", target, tr("Scene file (JSON), or clicks on one scene; - is standard input"))->required();
}

CLI::Option *addModelOrScene(CLI::App &command, std::string &target)
{
    return addFile(command, "SCENE", target,
                   tr("Model (OBJ, STL, PLY, OFF, glTF, GLB), scene file (JSON), or clicks on one\n"
                      "scene; - is a scene from standard input"))
        ->required();
}

} // namespace unprojector::cli
