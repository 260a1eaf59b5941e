#pragma once

#include "core/landmark_files/landmark_file.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace unprojector::landmark_files {

/// The semilandmarks that slide along their curves, as geomorph's gpagen(curves=) takes them.
struct Sliders {
    std::string text; ///< a table before,slide,after: numbers of points, from 1, a row per semilandmark
    std::size_t count = 0;
};

/// The names of a specimen's points in the order in which landmarksText writes them: landmarks, then
/// semilandmarks.
std::vector<std::string> writtenNames(const landmarks::LandmarkSet &set);

/// The sliders of a table's points. Each semilandmark slides along the direction from the point
/// before it to the one after it. The ends of a curve don't slide.
/// @param names  of the table's points, in their order
/// @return an error: a point that the table lacks, or a semilandmark between different points
base::Expected<Sliders, base::Error> slidersOf(std::span<const landmarks::LandmarkSet> sets,
                                               std::span<const std::string> names);
/// The sliders of points as landmarksText writes them.
/// @return an error: as above, or specimens with different points
base::Expected<Sliders, base::Error> slidersOf(std::span<const landmarks::LandmarkSet> sets);

/// The file of the sliders beside a table: "all.sliders.csv" for "all.tps".
std::filesystem::path slidersBeside(const std::filesystem::path &table);
/// True for the name of a file of sliders, in any case. It holds no landmarks.
bool isSlidersFile(const std::filesystem::path &file);

/// Writes the sliders beside a table.
/// @return the file; empty if no semilandmark slides
base::Expected<std::optional<std::filesystem::path>, base::Error>
writeSlidersBeside(const std::filesystem::path &table, const base::Expected<Sliders, base::Error> &sliders);

} // namespace unprojector::landmark_files
