#pragma once

#include "core/landmarks/landmark.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace unprojector::landmarks {

/// One landmark as it was placed several times on the same specimen, or by several observers.
struct RepeatedLandmark {
    std::string name;
    std::size_t count = 0;                    ///< how often it was placed
    std::optional<geometry::WorldPoint> mean; ///< nothing: never
    /// The standard deviation of one placing, of all three coordinates together: the root of the sum of the squares of the
    /// distances from the mean, divided by one less than their number. Nothing before it was placed twice, and
    /// where that is beyond the largest double.
    std::optional<double> error;
    double farthest = 0.0; ///< from the mean; infinite beyond the largest double
};

/// By name, as distinctNames tells them apart.
std::vector<RepeatedLandmark> repeatsOf(std::span<const LandmarkSet> placings);

} // namespace unprojector::landmarks
