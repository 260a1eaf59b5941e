#pragma once

#include "core/doctor/diagnosis.h"

#include <QString>

namespace unprojector::gui {

// What a diagnosis says, in the language of the window.

/// Its sentences: the mistake, that the point is right, or why neither can be said.
QString verdictText(const doctor::Diagnosis &diagnosis);

/// With the decimals that the last digit allows.
QString coordinateText(double value, double lastDigit);
/// @param lastDigit  units of the last digits, of each coordinate
QString pointText(const glm::dvec3 &point, const glm::dvec3 &lastDigit);
/// How much of coordinateText(coordinate, lastDigit) an answer explains: characters from its beginning.
/// @param digits  that it explains, see Candidate::digitsOfFirst
qsizetype explainedLength(double coordinate, double lastDigit, int digits);

} // namespace unprojector::gui
