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

/// A landmark without a name has its number. Of two that share a name in one set the second is "NAME (2)", as the second of
/// the other sets is; a name that a landmark of any set has already is passed over, and the next number taken.
DistinctNames distinctNames(std::span<const LandmarkSet> sets);

} // namespace unprojector::landmarks
