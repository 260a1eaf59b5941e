#pragma once

#include "core/landmark_files/landmark_file.h"

#include <filesystem>
#include <span>
#include <string>
#include <system_error>
#include <vector>

namespace unprojector::landmark_files {

/// The landmark file beside a scan: "face.ply.points.csv" for "face.ply".
/// @param placing  counted from 1: a later one, for a repeated placement, is
///         "face.ply.points-2.csv"
std::filesystem::path landmarksBeside(const std::filesystem::path &scan, int placing = 1);

/// The template of a folder's series of scans: its names are to be placed on each scan. It is no
/// specimen.
std::filesystem::path seriesTemplate(const std::filesystem::path &folder);

/// The specimen's name according to a file name: the name without the format's suffixes, "face" for
/// "face.mrk.json" and "face.ply.points.csv". UTF-8.
std::string specimenOf(const std::filesystem::path &file);

/// The number of the placing according to a file name: 2 for "face.ply.points-2.csv", 1 for others.
int placingOf(const std::filesystem::path &file);
/// The scan that a file lies beside, "face.ply" for "face.ply.points-2.csv"; empty for others.
std::filesystem::path scanOf(const std::filesystem::path &file);

/// True for the name of a model: "face.ply".
bool isModelName(const std::filesystem::path &file);

/// The content of all landmark files in a folder.
struct LandmarkFolder {
    /// Each with a name, or a name and a placing, of its own; placings of a scan have one name.
    std::vector<landmarks::LandmarkSet> sets;
    std::vector<std::filesystem::path> files; ///< the file of each set
    std::vector<std::string> reports;         ///< changes, losses and read errors, each a sentence with its file
    std::size_t fileCount = 0;                ///< number of landmark files, including unreadable ones
    std::vector<std::string> badFiles;        ///< the unreadable ones
    /// Those of the tables that have landmarks which no other file of the folder has.
    std::vector<std::filesystem::path> tableInputs;
};

/// Reads the landmark files of a folder, by name. Skips templates, JSON that is not 3D Slicer's,
/// and this program's tables of repeats, of errors and with a row a specimen. If files lie beside
/// scans, it skips other files of several specimens too: they are tables of these.
/// @param tables  the files to be made from them: earlier ones are not read; they may be empty
/// @param error   the reason if the folder could not be read
LandmarkFolder readLandmarkFolder(const std::filesystem::path &folder, std::span<const std::filesystem::path> tables,
                                  std::error_code &error);

/// The message with the folder's name and the reason why it cannot be read.
std::string folderErrorText(const std::filesystem::path &folder, const std::error_code &error);

} // namespace unprojector::landmark_files
