#pragma once

#include "core/landmark_files/landmark_file.h"
#include "core/landmarks/landmark.h"
#include "core/text/csv.h"

#include <span>
#include <string>
#include <vector>

namespace unprojector::landmark_files {

/// A specimen whose landmarks were placed several times, or by several observers.
struct RepeatedSpecimen {
    std::string name; ///< UTF-8
    std::vector<landmarks::LandmarkSet> placings;
    std::vector<std::string> files; ///< that the placings are of, UTF-8; one a placing
};

/// A table of comma-separated values with a row a landmark: specimen,name,placings,x,y,z,error,farthest. The mean of its
/// placings, the standard deviation of one of them and how far the farthest is from the mean, as landmarks::repeatsOf says;
/// what cannot be said of so few stays empty. Placings without a unit are noted, and taken to be in that of the others.
/// @return CannotHold: placings of one specimen in several units
geometry::Result<WrittenLandmarks, LandmarkFileError> repeatsTable(std::span<const RepeatedSpecimen> specimens,
                                                                   text::CellTexts texts = text::CellTexts::AsTheyAre);

} // namespace unprojector::landmark_files
