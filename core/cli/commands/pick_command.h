#pragma once

#include "core/cli/rows/row_writer.h"
#include "core/cli/terminal/exit_code.h"
#include "core/ray/scene_rays.h"

#include <string>
#include <vector>

namespace unprojector::cli {

/// `unproject pick`: finds the hits of the rays through positions in the view of a scene or a
/// model.
struct PickOptions {
    std::string scene;                  ///< a model, a scene or clicks; "-" is a scene from stdin
    std::string input = "-";            ///< CSV of positions, read if `positions` is empty
    std::vector<std::string> positions; ///< "X,Y", device pixels
    std::string size;                   ///< size of the view, "WxH"; empty: its own
    ray::Snap snap = ray::Snap::Surface;
    bool hasEdges = false;             ///< adds columns with the edge inside each pixel, for rows
    bool isJson = false;               ///< for `positions`
    RowFormat format = RowFormat::Csv; ///< for rows
    bool isSpreadsheetSafe = false;    ///< makes CSV RowFormat::SafeCsv
    bool isHeaderless = false;
    unsigned threads = 0; ///< 0: one per core
};

ExitCode runPick(const PickOptions &options);

} // namespace unprojector::cli
