#pragma once

#include "core/cli/rows/row_writer.h"
#include "core/cli/terminal/exit_code.h"
#include "core/ray/scene_rays.h"

#include <string>
#include <vector>

namespace unprojector::cli {

/// `unproject pick`: positions in the picture of a scene or a model to what their rays meet.
struct PickOptions {
    std::string scene;                  ///< a model, a scene or clicks; "-" is a scene from stdin
    std::string input = "-";            ///< CSV of positions, where there are none in `positions`
    std::vector<std::string> positions; ///< "X,Y", device pixels
    std::string size;                   ///< of the picture, "WxH"; empty: its own
    ray::Snap snap = ray::Snap::Surface;
    bool isJson = false;               ///< for `positions`
    RowFormat format = RowFormat::Csv; ///< for rows
    bool isSpreadsheetSafe = false;    ///< makes CSV RowFormat::SafeCsv
    bool isHeaderless = false;
    unsigned threads = 0; ///< 0: one a core
};

ExitCode runPick(const PickOptions &options);

} // namespace unprojector::cli
