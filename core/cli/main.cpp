#include "core/cli/command_line.h"

#include <exception>
#include <cstdio>

int main(int argc, char **argv)
{
    try {
        return static_cast<int>(unprojector::runCommandLine(argc, argv));
    } catch (const std::exception &error) { // out of memory, no thread to be had
        std::fprintf(stderr, "unproject: %s\n", error.what());
    }
    return static_cast<int>(unprojector::ExitCode::UnusableInput);
}
