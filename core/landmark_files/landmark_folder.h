#pragma once

#include "core/landmark_files/landmark_file.h"

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace unprojector::landmark_files {

/// Where the landmarks of a scan are kept beside it: "face.ply.points.csv" of "face.ply".
/// @param placing  counted from 1: a later one, of a scan that was gone through again, is "face.ply.points-2.csv"
std::filesystem::path landmarksBeside(const std::filesystem::path &scan, int placing = 1);

/// What a file calls its specimen: its name without what says its format, "face" of "face.mrk.json" and of
/// "face.ply.points.csv". UTF-8.
std::string specimenOf(const std::filesystem::path &file);

/// All that a folder's files of landmarks hold.
struct LandmarkFolder {
    std::vector<landmarks::LandmarkSet> sets; ///< each with a name of its own
    std::vector<std::string>
        reports;               ///< what was not kept as it was and what was not read, each a sentence with its file
    std::size_t fileCount = 0; ///< of landmarks, those that could not be read among them
    std::vector<std::string> badFiles; ///< that could not be read
    bool isTableInput = false; ///< the table to be made would replace landmarks that no other file of the folder has
};

/// Reads the files of a folder, by name. Templates are left out; JSON that is not 3D Slicer's is none of them.
/// @param error  why the folder could not be read
/// @param table  the file that is to be made of them: an earlier one is none of them; may be empty
LandmarkFolder readLandmarkFolder(const std::filesystem::path &folder, const std::filesystem::path &table,
                                  std::error_code &error);

/// Names the folder, and why it cannot be read.
std::string folderErrorText(const std::filesystem::path &folder, const std::error_code &error);

} // namespace unprojector::landmark_files
