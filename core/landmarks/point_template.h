#pragma once

#include "core/landmarks/landmark.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::landmarks {

// A template is a set of landmarks too: names in the order in which they are to be placed, and notes that say where. Where
// its own landmarks lie does not matter.

/// The column of a template's table that has them, see pictureFor.
constexpr const char *kPictureColumn = "picture";

/// What of a name is the same however a file had to write it: ASCII letters in lower case, and one '_' for blanks, for '_' and for
/// # " ' \, which some formats have none of. None of that counts at both ends. Empty of a name of nothing else.
std::string nameKey(std::string_view name);

/// Landmarks with those of a template that they lack put behind them, as missing: without a place, a note or an object.
/// Which are there already is told by their names, in whatever case; of a name that the template has twice, two.
std::vector<Landmark> withTemplate(std::vector<Landmark> landmarks, std::span<const Landmark> names);

/// The places of a template in its order, each with the landmark of its name where there is one, else one of the same nameKey, else
/// missing; behind them the other landmarks, in their order. Of landmarks of one name the first comes first; none is changed.
std::vector<Landmark> inTemplateOrder(std::vector<Landmark> landmarks, std::span<const Landmark> names);

/// What a template says of a landmark of this name, else of one of the same nameKey: its note. Empty where it has none.
std::string_view hintFor(std::string_view name, std::span<const Landmark> names);

/// The file of a picture that a template shows of a landmark of this name, as it stands in the template: its column
/// "picture". Empty where it has none.
std::string_view pictureFor(std::string_view name, std::span<const Landmark> names);

} // namespace unprojector::landmarks
