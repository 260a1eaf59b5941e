#pragma once

#include "core/landmarks/landmark.h"

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace unprojector::landmarks {

/// The landmarks of several sets with unique names within each set.
struct DistinctNames {
    std::vector<std::string> names;               ///< in order of first appearance
    std::vector<std::vector<std::size_t>> places; ///< for each set, for each of its landmarks: the index of its name
    /// Spellings that count as another one: "nasion " as "Nasion". Each once.
    std::vector<std::pair<std::string, std::string>> respelled;
};

/// Gives each landmark of a set a unique name. A landmark without a name gets its number. The
/// second landmark "NAME" of a set becomes "NAME (2)", in all sets alike; if some landmark has that
/// name already, the next free number is used.
///
/// Spellings of the same nameKey are one name, the first one, unless some set has several of them.
DistinctNames distinctNames(std::span<const LandmarkSet> sets);

} // namespace unprojector::landmarks
