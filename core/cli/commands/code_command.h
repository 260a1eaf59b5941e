#pragma once

#include "core/cli/terminal/exit_code.h"
#include "core/scene_code/scene_code.h"

#include <string>

namespace unprojector::cli {

/// `unproject code`: writes a scene as source code.
struct CodeOptions {
    std::string scene;
    scene_code::CodeDialect dialect = scene_code::CodeDialect::Glu;
    std::string output = "-";
};

ExitCode runCode(const CodeOptions &options);

} // namespace unprojector::cli
