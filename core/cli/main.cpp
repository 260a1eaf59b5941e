#include "core/cli/command_line.h"
#include "core/cli/console.h"

#include <cstdio>
#include <exception>

int main(int argc, char **argv)
{
    const unprojector::cli::Utf8Console console;
    try {
        return static_cast<int>(unprojector::cli::runCommandLine(unprojector::cli::utf8Arguments(argc, argv)));
    } catch (const std::exception &error) { // out of memory
        std::fprintf(stderr, "unproject: %s\n", error.what());
    }
    return static_cast<int>(unprojector::cli::ExitCode::UnusableInput);
}
