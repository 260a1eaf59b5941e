#pragma once

#include "core/landmarks/landmark.h"
#include "core/landmarks/measure.h"
#include "gui/text/number_text.h"

#include <QString>
#include <QStringList>

#include <optional>

namespace unprojector::gui {

// Landmarks in words.

/// The anchor of a landmark in one or two words: "triangle 7", "vertex 3", "edge 1–2", "free".
/// Without a position: "missing", "skipped" or "not placed".
QString heldByText(const landmarks::Landmark &landmark);
/// The same in a sentence.
QString heldByExplanation(const landmarks::Landmark &landmark);
/// The reason why a landmark has no position, a clause: "nasion is missing on this specimen".
/// @param name  as it is to be shown
QString absenceText(const landmarks::Landmark &landmark, const QString &name);
/// The uncertainty of a landmark: its length, "0.05"; "?" if unknown; nothing without a position. A
/// triangle before it marks an edge in the landmark's pixel: "▲ 4.3".
QString plusMinusText(const landmarks::Landmark &landmark);
/// The occluding edge in the pixel that the landmark was placed by, a sentence; empty without one.
QString landmarkEdgeText(const landmarks::Landmark &landmark);
/// The notation of a landmark's coordinates: two digits below the uncertainty if they fit into
/// `characters`; else only the certain ones if they fit into `most`; thousandths if the uncertainty
/// is unknown.
Notation landmarkNotation(const landmarks::Landmark &landmark, int axis, int characters, int most);

/// "12.34 ± 0.05 mm", rounded to its certain digits. "12.34567 ± ? mm" if the uncertainty is
/// unknown.
QString lengthText(const landmarks::Measure &measure, const QString &unit);
/// The same in degrees: "91.2° ± 0.4°".
/// @param measure  radians
QString angleText(const landmarks::Measure &measure);
/// The same in ever less room, see fittedText: without the error, then with ever fewer digits.
QStringList lengthTexts(const landmarks::Measure &measure, const QString &unit);
QStringList angleTexts(const landmarks::Measure &measure);
/// The reason why a measure doesn't exist.
QString measureErrorText(const landmarks::MeasureError &error);

} // namespace unprojector::gui
