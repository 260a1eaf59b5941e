#pragma once

#include "core/landmarks/landmark.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace unprojector::landmarks {

/// The landmarks of several sets by names of which no two are the same.
struct DistinctNames {
    std::vector<std::string> names;               ///< in the order in which they first appear
    std::vector<std::vector<std::size_t>> places; ///< of each set, of each of its landmarks: the index of its name
};

/// Gives each landmark of a set a name of its own. A landmark without a name gets its number. The second landmark "NAME" of a
/// set gets "NAME (2)", in all sets alike; where some landmark has that name already, the next free number.
DistinctNames distinctNames(std::span<const LandmarkSet> sets);

} // namespace unprojector::landmarks
