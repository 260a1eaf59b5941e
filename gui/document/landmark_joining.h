#pragma once

#include "core/landmarks/landmark.h"

#include <QString>
#include <QStringList>

#include <cstddef>
#include <string>
#include <vector>

namespace unprojector::gui {

// Merges a file's landmarks into a scene's.

/// The result of a merge, and its import notes.
struct JoinedLandmarks {
    QStringList notes;                  ///< sentences about results that a user may not expect
    std::size_t filled = 0;             ///< names to place that are placed now
    std::vector<std::string> unmatched; ///< names in the file that match none to place
};

/// Returns whether no landmark has a name: then only their order identifies them.
bool areNameless(const std::vector<landmarks::Landmark> &landmarks);

/// Gives nameless landmarks the names to place, in order, as long as there are any.
void nameByOrder(std::vector<landmarks::Landmark> &landmarks, const std::vector<landmarks::Landmark> &there);

/// Fills the names to place with the file's landmarks and appends the file's other landmarks.
/// @param set  of the file; then its curves go through its landmarks by their names in the scene
/// @param there  the scene's landmarks, placed or not
JoinedLandmarks fillLandmarks(landmarks::LandmarkSet &set, const std::vector<landmarks::Landmark> &there);

/// Replaces the scene's landmarks by the file's. Other data of the scene stays unless the file has
/// its own; units never change without a note. A name that the file had to spell differently
/// (landmarks::nameKey) gets the scene's spelling.
/// @param set  of the file; then what the scene gets
/// @param taken  how many of the set's last curves the file itself does not define as curves: the
/// scene's own stay
/// @param file  its name
JoinedLandmarks replaceLandmarks(landmarks::LandmarkSet &set, const landmarks::LandmarkSet &before, std::size_t taken,
                                 const QString &file);

/// Appends the file's landmarks. One whose name, or else its nameKey, matches a name to place fills
/// that instead. Parameters as replaceLandmarks.
JoinedLandmarks appendLandmarks(landmarks::LandmarkSet &set, const landmarks::LandmarkSet &before, std::size_t taken,
                                const QString &file);

} // namespace unprojector::gui
