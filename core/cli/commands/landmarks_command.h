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
    std::optional<landmark_files::Format> from, to; ///< nothing: by the suffix
    std::string mesh;                               ///< model that the points are tied to; empty: none
    std::string folder;                             ///< a table of its files is made; empty: none
    std::vector<std::string> repeats;               ///< files of the same points, each placed anew; empty: none
    LandmarkTable table = LandmarkTable::Long;
    bool isSpreadsheetSafe = false; ///< see text::CellTexts
};

/// `unproject landmarks`: landmarks from one file to another, a table of a folder of them, or how far repeated placings
/// scatter. What is lost is said on stderr.
/// @return SomeRowsBad where files of a folder could not be read
ExitCode runLandmarks(const LandmarksOptions &options);

} // namespace unprojector::cli
