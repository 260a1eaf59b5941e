#pragma once

#include "core/cli/terminal/exit_code.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/specimen_table.h"

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {

struct LandmarksOptions {
    std::string input, output;                      ///< UTF-8; "-" is stdin and stdout
    std::optional<landmark_files::Format> from, to; ///< empty: by the suffix
    std::string mesh;                               ///< model that the landmarks lie on; empty: none
    std::string folder;                             ///< folder whose files become a table; empty: none
    std::string sliders;                            ///< file for the sliders of the written points; empty: none
    std::vector<std::string> repeats;               ///< files and folders with repeated placements; empty: none
    std::string errors;                             ///< the table of the error of measurement; empty: none
    std::string measures;                           ///< protocol whose measures the table of a folder has; empty: none
    std::optional<landmark_files::TableForm> table; ///< form of the table; empty: by the suffix
    bool isSpreadsheetSafe = false;                 ///< see base::CellTexts
};

/// Runs `unproject landmarks`: converts landmark files, makes a table of a folder, or measures the
/// scatter of repeated placements. Conversion losses are reported on stderr.
/// @return SomeRowsBad where files of a folder could not be read
ExitCode runLandmarks(const LandmarksOptions &options);

} // namespace unprojector::cli
