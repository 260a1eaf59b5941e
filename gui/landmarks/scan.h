#pragma once

#include "core/geometry/result.h"
#include "core/landmarks/landmark.h"
#include "core/scene/scene.h"

#include <QString>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace unprojector::gui {

using landmarks::kMostPlacings;

/// A scan of a series, with its landmarks.
struct Scan {
    std::filesystem::path file;
    landmarks::LandmarkSet points; ///< saved or current, in coordinates of the scan's own file
    QString problem;               ///< why the scan or its landmarks could not be read; empty: no error
    bool isKept = false;           ///< it has a landmark file
    bool isDamaged = false;        ///< that file could not be read
    std::size_t placedCount() const;
    /// The number of landmarks that this specimen does not have.
    std::size_t missingCount() const;
    /// Returns whether each of these names has a landmark that is placed or missing on purpose.
    bool isComplete(const std::vector<landmarks::Landmark> &names) const;
};

/// The model files of a folder, sorted by name, without their landmarks.
/// @return the reason if there is none, or if the folder cannot be read
geometry::Result<std::vector<Scan>, QString> scansIn(const std::filesystem::path &folder);

/// Reads the landmarks of one placing that are saved beside the scan.
void readKept(Scan &scan, int placing);

std::size_t placedCount(const landmarks::LandmarkSet &set);

/// A scan as in its file: not moved, turned or scaled.
scene::SceneObject asInItsFile(const std::filesystem::path &file, const scene::SceneObject &shown);

/// Returns whether two landmarks have the same position, up to rounding.
bool isStill(const landmarks::Landmark &now, const landmarks::Landmark &was);

/// Gives landmarks that kept their position the exact coordinates that they had: a transform and
/// its inverse leave rounding.
void takeExact(std::vector<landmarks::Landmark> &landmarks, const std::vector<landmarks::Landmark> &were);

/// A landmark by its name, which several landmarks of a scan may have.
struct NamedLandmark {
    std::string name;
    std::size_t before = 0; ///< number of earlier landmarks of the same name
};

/// @pre index < landmarks.size()
NamedLandmark namedLandmark(const std::vector<landmarks::Landmark> &landmarks, std::size_t index);
/// The index of a landmark; nothing if the list lacks it.
std::optional<std::size_t> indexOf(const std::vector<landmarks::Landmark> &landmarks, const NamedLandmark &landmark);

/// Returns whether there is a landmark of this name, up to blanks and case.
bool has(const std::vector<landmarks::Landmark> &landmarks, const std::string &name);

/// Removes names to place that are not wanted.
void withoutUnwanted(std::vector<landmarks::Landmark> &landmarks, const std::vector<landmarks::Landmark> &wanted);

/// Adds the curves through landmarks that a list lacks, by name.
void addCurves(std::vector<landmarks::Curve> &curves, const std::vector<landmarks::Curve> &others);

/// Returns whether a list has all placed landmarks of another one, at the same positions, and the
/// same ones marked as missing.
bool holds(const std::vector<landmarks::Landmark> &all, const std::vector<landmarks::Landmark> &others);

} // namespace unprojector::gui
