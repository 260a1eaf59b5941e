#include "core/base/printable.h"
#include "core/base/standard_streams.h"
#include "core/base/translation.h"
#include "core/cli/command_line.h"
#include "core/cli/terminal/console.h"
#include "core/cli/terminal/language_choice.h"

#include <cstdio>
#include <exception>
#include <new>

int main(int argc, char **argv)
{
    const unprojector::base::Utf8Console console;
    try {
        unprojector::base::setLanguage(unprojector::cli::chosenLanguage(unprojector::cli::languageWishes()));
        return static_cast<int>(unprojector::cli::runCommandLine(unprojector::cli::utf8Arguments(argc, argv)));
    } catch (const std::bad_alloc &) {
        std::fputs("unproject: out of memory; the results are not complete\n", stderr);
    } catch (const std::exception &error) {
        std::fprintf(stderr, "unproject: an error of this program (%s); the results are not complete\n",
                     unprojector::base::printableLine(error.what()).c_str());
    }
    return static_cast<int>(unprojector::cli::ExitCode::UnusableInput);
}
