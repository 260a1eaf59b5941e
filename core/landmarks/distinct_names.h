#pragma once

#include "core/landmarks/landmark.h"

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace unprojector::landmarks {

/// Two spellings of one nameKey, both in one set.
struct KeptSpellings {
    std::size_t set = 0; ///< index of the first such set
    std::string first, second;
};

/// The landmarks of several sets with unique names within each set.
struct DistinctNames {
    std::vector<std::string> names;               ///< in order of first appearance
    std::vector<std::vector<std::size_t>> places; ///< for each set, for each of its landmarks: the index of its name
    /// Spellings that count as another one: "nasion " as "Nasion". Each once.
    std::vector<std::pair<std::string, std::string>> respelled;
    /// Spellings that stay two names, while another set has only one of them.
    std::vector<KeptSpellings> kept;
};

/// Gives each landmark of a set a unique name. A landmark without a name gets its number. The
/// second landmark "NAME" of a set becomes "NAME (2)", in all sets alike; if some landmark has that
/// name already, the next free number is used.
///
/// Spellings of the same nameKey are one name, the first one, unless some set has several of them.
DistinctNames distinctNames(std::span<const LandmarkSet> sets);

} // namespace unprojector::landmarks
