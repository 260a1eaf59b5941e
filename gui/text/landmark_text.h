#pragma once

#include "core/landmarks/landmark.h"
#include "core/landmarks/measure.h"
#include "gui/text/number_text.h"

#include <QString>

#include <optional>

namespace unprojector::gui {

// Placed points in words.

/// What holds a point, in a word: "triangle 7", "vertex 3", "edge 1–2", "free"; "missing" for one without a place.
QString heldByText(const landmarks::Landmark &landmark);
/// The same in a sentence.
QString heldByExplanation(const landmarks::Landmark &landmark);
/// How far a point can be off: the length of its uncertainty, "0.05"; "?" where that is not known.
QString plusMinusText(const landmarks::Landmark &landmark);
/// How a point's coordinates are written: with two digits below what is certain where that many characters have room for them, and
/// with all that are certain where `most` of them have; with thousandths where that is not known.
Notation landmarkNotation(const landmarks::Landmark &landmark, int axis, int characters, int most);

/// "12.34 ± 0.05 mm"; the value with the digits that its error leaves certain. "12.34567 ± ? mm" where that is not known.
QString lengthText(const landmarks::Measure &measure, const QString &unit);
/// The same in degrees: "91.2° ± 0.4°".
/// @param measure  radians
QString angleText(const landmarks::Measure &measure);
/// Why there is no such measure.
QString measureErrorText(const landmarks::MeasureError &error);

} // namespace unprojector::gui
