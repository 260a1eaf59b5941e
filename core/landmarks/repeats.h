#pragma once

#include "core/landmarks/landmark.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace unprojector::landmarks {

/// One landmark, placed several times on the same specimen, or by several observers.
struct RepeatedLandmark {
    std::string name;
    std::size_t count = 0;                    ///< number of placings
    std::optional<geometry::WorldPoint> mean; ///< empty: never placed
    /// The standard deviation of one placing, for all three coordinates together: the root of the
    /// sum of the squared distances from the mean over the count minus one. Empty for fewer than
    /// two placings, and beyond the largest double.
    std::optional<double> error;
    double farthest = 0.0; ///< largest distance from the mean; infinite beyond the largest double
};

/// The landmarks by name, see distinctNames.
std::vector<RepeatedLandmark> repeatsOf(std::span<const LandmarkSet> placings);

} // namespace unprojector::landmarks
