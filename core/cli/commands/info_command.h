#pragma once

#include "core/cli/terminal/exit_code.h"

#include <string>

namespace unprojector::cli {

/// `unproject info`: describes the content of a model or a scene.
struct InfoOptions {
    std::string file; ///< a model, a scene or clicks; "-" is a scene from stdin
    bool isJson = false;
};

ExitCode runInfo(const InfoOptions &options);

} // namespace unprojector::cli
