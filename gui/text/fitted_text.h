#pragma once

#include <QString>
#include <QStringList>

#include <functional>

namespace unprojector::gui {

// Numbers in too little room. A cut text of a number is another number, so texts with numbers are
// never elided: a shorter text has fewer digits, and keeps its power of ten and its unit.

/// Ever shorter texts of a number, from all its digits to one. Each is rounded from the value itself.
QStringList shorterTexts(double value);

/// The width of a text, logical pixels.
using TextWidth = std::function<int(const QString &)>;

/// The first of the texts that fits into the width; "####" without one, as in a spreadsheet.
/// @param texts  ever shorter
QString fittedText(const QStringList &texts, int width, const TextWidth &widthOf);

/// A sentence that is cut at its end, before any number there, because the rest of the number or its
/// unit would be cut off: "Moved by at most…".
QString elidedSentence(const QString &sentence, int width, const TextWidth &widthOf);

} // namespace unprojector::gui
