#pragma once

#include "core/landmark_files/landmark_file.h"
#include "core/landmarks/landmark.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::landmark_files {

// A protocol as a file: a table with a row a measure, name,kind,landmarks. Each landmark has a cell of
// its own, so rows have different lengths:
//
//   name,kind,landmarks
//   nose height,distance,nasion,subnasale
//   nose angle,angle,nasion,pronasale,subnasale
//   brow,surface,eye left,glabella,eye right

/// The name of the protocol beside the scans of a series.
inline constexpr const char *kSeriesMeasures = "series.measures.csv";

/// Returns whether the name ends in ".measures.csv": no file of landmarks.
bool isMeasuresFile(const std::filesystem::path &file);

/// Reads a protocol. Kinds are landmarks::kMeasureKinds.
/// @param name  of the file, for errors
/// @return Malformed: a row without a name, with an unknown kind, a wrong number of landmarks, or a
///         name of another row
geometry::Result<std::vector<landmarks::KeptMeasure>, LandmarkFileError> parseMeasures(std::string_view text,
                                                                                       const std::string &name);
/// @return NotFound, IsDirectory, NotReadable, TooLarge, and the errors of parseMeasures
geometry::Result<std::vector<landmarks::KeptMeasure>, LandmarkFileError>
readMeasures(const std::filesystem::path &file);

std::string measuresText(std::span<const landmarks::KeptMeasure> measures);

} // namespace unprojector::landmark_files
