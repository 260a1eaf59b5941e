#pragma once

#include "core/landmarks/landmark.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::landmarks {

// A template is a set of landmarks too: names in the order of placing, and notes with instructions.
// The positions of its landmarks are not used.

/// The column of a template's table with image files, see pictureFor.
constexpr const char *kPictureColumn = "picture";

/// Appends the landmarks of a template that are absent, to be placed: without a position, a note or
/// an object. A spelling that is there comes first, else one of the same nameKey counts. If the
/// template has a name twice, two landmarks must exist.
std::vector<Landmark> withTemplate(std::vector<Landmark> landmarks, std::span<const Landmark> names);

/// The landmarks in the order of a template: for each name the landmark of that name, else one of
/// the same nameKey, else one to place. The other landmarks follow in their order. Landmarks of
/// one name are used in their order; none is changed.
std::vector<Landmark> inTemplateOrder(std::vector<Landmark> landmarks, std::span<const Landmark> names);

/// The template's note for a landmark of this name, else of the same nameKey. Empty if it has none.
std::string_view hintFor(std::string_view name, std::span<const Landmark> names);

/// The image file that a template shows for a landmark of this name, as written in its column
/// "picture". Empty if it has none.
std::string_view pictureFor(std::string_view name, std::span<const Landmark> names);

} // namespace unprojector::landmarks
