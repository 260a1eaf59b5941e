#pragma once

#include "core/doctor/diagnosis.h"

#include <QString>

namespace unprojector::gui {

// Diagnoses in words, in the language of the window.

/// The sentences of a diagnosis: the mistake, that the point is right, or why neither can be
/// decided.
QString verdictText(const doctor::Diagnosis &diagnosis);

/// The value with the decimals of its last digit.
QString coordinateText(double value, double lastDigit);
/// @param lastDigit  units of the last digit of each coordinate
QString pointText(const glm::dvec3 &point, const glm::dvec3 &lastDigit);
/// The number of leading characters of coordinateText(coordinate, lastDigit) that an answer
/// explains.
/// @param digits  number of explained digits, see Candidate::digitsOfFirst
qsizetype explainedLength(double coordinate, double lastDigit, int digits);

} // namespace unprojector::gui
