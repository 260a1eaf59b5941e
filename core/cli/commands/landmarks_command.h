#pragma once

#include "core/cli/rows/byte_stream.h"
#include "core/cli/terminal/exit_code.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/sliders.h"
#include "core/landmark_files/specimen_table.h"

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {

/// `unproject landmarks`: converts landmark files, makes a table of a folder, or measures the scatter
/// of repeated placements.
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

    base::CellTexts texts() const
    {
        return isSpreadsheetSafe ? base::CellTexts::SpreadsheetSafe : base::CellTexts::ReadBack;
    }
};

/// Makes one table of the landmark files of a folder, with the measures of a protocol if there is one.
/// @return SomeRowsBad where files of the folder could not be read
ExitCode makeTable(const LandmarksOptions &options);

/// Writes the mean and the scatter of landmarks that were placed several times, and their error of
/// measurement over all specimens.
/// @return SomeRowsBad where files of a folder could not be read
ExitCode makeRepeats(const LandmarksOptions &options);

/// Reads a landmark file. Reports its notes.
landmark_files::ReadLandmarks readFile(const std::string &file, landmark_files::Format format);

/// Writes a table or a file.
/// @param inputs  inputs of the run: none of them is overwritten
ExitCode write(const std::string &file, const base::Expected<landmark_files::WrittenLandmarks, base::Error> &text,
               const InputFiles &inputs);

/// Writes the sliders of points that were written. Reports on stderr what it wrote, or why it
/// wrote nothing.
/// @param file     empty: nothing is asked for
/// @param written  exit code of the points
ExitCode writeSliders(const std::string &file, const base::Expected<landmark_files::Sliders, base::Error> &sliders,
                      const InputFiles &inputs, ExitCode written);

/// The given format of a file, else the one of its suffix.
/// @param option  "--from" or "--to"
landmark_files::Format formatOf(const std::string &file, const std::optional<landmark_files::Format> &given,
                                const char *option);

} // namespace unprojector::cli
