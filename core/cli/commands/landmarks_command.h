#pragma once

#include "core/cli/terminal/exit_code.h"
#include "core/landmark_files/landmark_file.h"

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {

enum class LandmarkTable { Long, Wide, Tps, Nts };

struct LandmarksOptions {
    std::string input, output;                      ///< UTF-8; "-" is stdin and stdout
    std::optional<landmark_files::Format> from, to; ///< empty: by the suffix
    std::string mesh;                               ///< model that the landmarks lie on; empty: none
    std::string folder;                             ///< folder whose files become a table; empty: none
    std::string sliders;                            ///< file for the sliders of the written points; empty: none
    std::vector<std::string> repeats;               ///< files with repeated placements of the same points; empty: none
    LandmarkTable table = LandmarkTable::Long;
    bool isSpreadsheetSafe = false; ///< see text::CellTexts
};

/// Runs `unproject landmarks`: converts landmark files, makes a table of a folder, or measures the
/// scatter of repeated placements. Conversion losses are reported on stderr.
/// @return SomeRowsBad where files of a folder could not be read
ExitCode runLandmarks(const LandmarksOptions &options);

} // namespace unprojector::cli
