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
/// @return an error: a row without a name, with an unknown kind, a wrong number of landmarks, or a
///         name of another row
base::Expected<std::vector<landmarks::KeptMeasure>, base::Error> parseMeasures(std::string_view text,
                                                                               const std::string &name);
base::Expected<std::vector<landmarks::KeptMeasure>, base::Error> readMeasures(const std::filesystem::path &file);

std::string measuresText(std::span<const landmarks::KeptMeasure> measures);

} // namespace unprojector::landmark_files
