#pragma once

#include "core/landmarks/landmark.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace unprojector::landmarks {

// One rule tells whether two landmarks have the same name, in files, templates, series and measures:
// the same spelling, else, if no landmark has that spelling, the same nameKey.

/// The part of a name that survives every file format. Letters of the Latin, Greek and Cyrillic
/// alphabets become lower case; other letters must match exactly. One '_' replaces blanks, '_' and the
/// characters # " ' \, which some formats lack; at both ends they are removed. Empty for a name of only
/// such characters: it matches its own spelling only.
std::string nameKey(std::string_view name);

/// Returns whether two names have the same spelling or the same nameKey.
bool isSameName(std::string_view a, std::string_view b);

/// The index of the landmark with this name: of the first in this spelling, else of the first with
/// the same nameKey.
std::optional<std::size_t> indexOfName(std::span<const Landmark> landmarks, std::string_view name);

} // namespace unprojector::landmarks
