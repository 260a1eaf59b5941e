#pragma once

#include "core/cli/exit_code.h"
#include "core/cli/row_writer.h"

#include <string>

namespace unprojector {

/// `unproject project`: points in, every stage on their way to the window out.
struct ProjectOptions {
    std::string scene;
    std::string input = "-";     ///< a CSV file, "-" for stdin
    std::string space = "world"; ///< of the points: "world" or "object:NAME"
    RowFormat format = RowFormat::Csv;
    unsigned threads = 2;
};

ExitCode runProject(const ProjectOptions &options);

} // namespace unprojector
