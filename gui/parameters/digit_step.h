#pragma once

#include <QString>

#include <optional>

namespace unprojector::gui {

/// A number's text with the caret in it.
struct CaretText {
    QString text;
    int caret = 0;
};

/// The place of the digit at a caret: the digit right of it, or left of it before a point, the
/// exponent or the end. As a power of ten, before the exponent: 0 for "12|.34" and "1|2.34", -2 for
/// "12.3|4" and "12.34|e5". Nothing if the text is not a plain number.
std::optional<int> digitAt(const CaretText &number);

/// The number with that digit stepped, with as many decimals as before, and the caret at the same
/// digit.
/// @pre digitAt(number)
CaretText withDigitStepped(const CaretText &number, int place, double steps);

} // namespace unprojector::gui
