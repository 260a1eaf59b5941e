#pragma once

#include "core/landmarks/landmark.h"

#include <span>
#include <string_view>
#include <vector>

namespace unprojector::landmarks {

// A template is a set of landmarks too: names in the order in which they are to be placed, and notes that say where. Where
// its own landmarks lie does not matter.

/// The column of a template's table that has them, see pictureFor.
constexpr const char *kPictureColumn = "picture";

/// Landmarks with those of a template that they lack put behind them, as missing: without a place, a note or an object.
/// Which are there already is told by their names, in whatever case; of a name that the template has twice, two.
std::vector<Landmark> withTemplate(std::vector<Landmark> landmarks, std::span<const Landmark> names);

/// The places of a template in its order, each with the landmark of its name where there is one, in whatever case, else missing;
/// behind them the other landmarks, in theirs. Of landmarks of one name the first comes first; none is changed.
std::vector<Landmark> inTemplateOrder(std::vector<Landmark> landmarks, std::span<const Landmark> names);

/// What a template says of a landmark of this name, in whatever case: its note. Empty where it has none.
std::string_view hintFor(std::string_view name, std::span<const Landmark> names);

/// The file of a picture that a template shows of a landmark of this name, as it stands in the template: its column
/// "picture". Empty where it has none.
std::string_view pictureFor(std::string_view name, std::span<const Landmark> names);

} // namespace unprojector::landmarks
