#pragma once

#include "core/cli/commands/landmarks_command.h"
#include "core/cli/rows/byte_stream.h"
#include "core/cli/terminal/exit_code.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/sliders.h"

#include <optional>
#include <string>
#include <vector>

namespace unprojector::cli {

base::CellTexts textsOf(const LandmarksOptions &options);

/// Prints the notes of a file on stderr.
void tell(const std::string &name, const std::vector<landmark_files::LandmarkNote> &notes);

/// Reads a landmark file. Prints errors on stderr.
std::optional<landmark_files::ReadLandmarks> readFile(const std::string &file, landmark_files::Format format);

/// @param inputs  inputs of the run: none of them is overwritten
ExitCode write(const std::string &file,
               const geometry::Result<landmark_files::WrittenLandmarks, landmark_files::LandmarkFileError> &text,
               const InputFiles &inputs);

/// Returns whether two results would go to the same file, or both to stdout. If so, it prints that
/// on stderr. Either name may be empty: there is no such result.
bool isSameOutput(const std::string &a, const std::string &b);

/// Returns whether a table may have this name. If not, it prints the reason on stderr.
/// @param output  empty: there is no such table
/// @param format  that of the table
bool isNameOfTable(const std::string &output, landmark_files::Format format);

/// Writes the sliders of points that were written. Reports on stderr what it wrote, or why it
/// wrote nothing.
/// @param file     empty: nothing is asked for
/// @param written  exit code of the points
ExitCode writeSliders(const std::string &file,
                      const geometry::Result<landmark_files::Sliders, landmark_files::LandmarkFileError> &sliders,
                      const InputFiles &inputs, ExitCode written);

/// The given format of a file, else the one of its suffix. An unknown format is reported on stderr.
/// @param option  "--from" or "--to"
std::optional<landmark_files::Format> formatOf(const std::string &file,
                                               const std::optional<landmark_files::Format> &given, const char *option);

} // namespace unprojector::cli
