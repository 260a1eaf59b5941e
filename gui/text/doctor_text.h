#pragma once

#include "core/doctor/diagnosis.h"

#include <QString>

namespace unprojector::gui {

// What a diagnosis says, in the language of the window.

/// Its sentences: the mistake, that the point is right, or why neither can be said.
QString verdictText(const doctor::Diagnosis &diagnosis);
/// "y not flipped", and which of several ways to make it: "pixel corner (x only)".
QString candidateName(const doctor::Candidate &candidate);
/// "all 11 digits", "9 of 11 digits", "all 9 digits that count of the 12 given, the last not rounded but cut off".
QString explainedText(const doctor::Candidate &candidate, const doctor::Diagnosis &diagnosis);
/// Where the first point lies in the picture, by the right matrices, and what of that is wrong.
QString landingText(const doctor::Diagnosis &diagnosis);
/// How likely chance explains the point as well: "less than 0.0001 %".
QString chanceText(double chance);

/// With the decimals that the last digit allows.
QString coordinateText(double value, double lastDigit);
/// @param lastDigit  units of the last digits, of each coordinate
QString pointText(const glm::dvec3 &point, const glm::dvec3 &lastDigit);
/// How much of coordinateText(coordinate, lastDigit) an answer explains: characters from its beginning.
/// @param digits  that it explains, see Candidate::digitsOfFirst
qsizetype explainedLength(double coordinate, double lastDigit, int digits);

} // namespace unprojector::gui
