#pragma once

#include "core/landmarks/landmark.h"

#include <QString>
#include <QStringList>

#include <cstddef>
#include <string>
#include <vector>

namespace unprojector::gui {

// How the points that a file has come to those that a scene has.

/// What was done, and what is to be said of it.
struct JoinedLandmarks {
    QStringList notes;                  ///< sentences about what is not as somebody may think
    std::size_t filled = 0;             ///< names that waited and have their point now
    std::vector<std::string> unmatched; ///< names of the file that none waited for
};

/// Whether none of the points has a name: their order says which is which.
bool areNameless(const std::vector<landmarks::Landmark> &landmarks);

/// Gives nameless points the names of those that wait, in their order, as far as there are any.
void nameByOrder(std::vector<landmarks::Landmark> &landmarks, const std::vector<landmarks::Landmark> &there);

/// The names that wait with the file's points in their places, and behind them its other points.
/// @param set  of the file; its curves go through its points by their names now
/// @param there  what waits for its place, and what has one
JoinedLandmarks fillLandmarks(landmarks::LandmarkSet &set, const std::vector<landmarks::Landmark> &there);

/// The file's points instead of those before. What the scene has besides points stays where the file says nothing of it, and units
/// are never changed in silence. A name that the file had to write otherwise, see landmarks::nameKey, is the scene's again.
/// @param set  of the file; then what the scene gets
/// @param taken  how many of the set's last curves are none that the file itself calls so: those of the scene stay
/// @param file  its name
JoinedLandmarks replaceLandmarks(landmarks::LandmarkSet &set, const landmarks::LandmarkSet &before, std::size_t taken,
                                 const QString &file);

/// The file's points behind those before; one whose name waits for a place there takes that, by its name or else by its nameKey.
/// Parameters as replaceLandmarks.
JoinedLandmarks appendLandmarks(landmarks::LandmarkSet &set, const landmarks::LandmarkSet &before, std::size_t taken,
                                const QString &file);

} // namespace unprojector::gui
