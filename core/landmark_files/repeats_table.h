#pragma once

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
    std::vector<std::string> files; ///< that the placings are of, where somebody asks for them
};

/// A table of comma-separated values with a row a landmark: specimen,name,placings,x,y,z,error,farthest. The mean of its
/// placings, the standard deviation of one of them and how far the farthest is from the mean, as landmarks::repeatsOf says;
/// what cannot be said of so few stays empty.
std::string repeatsTable(std::span<const RepeatedSpecimen> specimens,
                         text::CellTexts texts = text::CellTexts::AsTheyAre);

} // namespace unprojector::landmark_files
