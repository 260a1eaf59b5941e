#include "gui/parameters/digit_step.h"

#include "gui/text/number_text.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
namespace {

/// The parts of a plain number; positions are indices into the text.
struct Parts {
    int start = 0; ///< of the digits, after the sign
    int point = 0; ///< the decimal point or the end of the digits
    int end = 0;   ///< of the digits and decimals

    int decimals() const { return std::max(0, end - point - 1); }
    int placeOf(int index) const { return index < point ? point - 1 - index : point - index; }
    /// The index of the digit at a place; of the first or last digit if there is none.
    int indexOf(int place) const { return std::clamp(place >= 0 ? point - 1 - place : point - place, start, end - 1); }
};

std::optional<Parts> partsOf(const QString &text)
{
    static const QRegularExpression plain(
        QStringLiteral("^\\s*[-+\u2212]?(\\d*)([.,]?)(\\d*)(?:[eE][-+\u2212]?\\d+)?\\s*$"));
    const QRegularExpressionMatch match = plain.match(text);
    if (!match.hasMatch() || (match.capturedLength(1) == 0 && match.capturedLength(3) == 0))
        return std::nullopt;
    return Parts{static_cast<int>(match.capturedStart(1)), static_cast<int>(match.capturedEnd(1)),
                 static_cast<int>(match.capturedEnd(3))};
}

} // namespace

std::optional<int> digitAt(const CaretText &number)
{
    const std::optional<Parts> parts = partsOf(number.text);
    if (!parts)
        return std::nullopt;
    const auto isDigit = [&](int index) {
        return index >= parts->start && index < parts->end && number.text[index].isDigit();
    };
    const int caret = std::clamp(number.caret, parts->start, parts->end);
    for (const int index : {caret, caret - 1, caret + 1, caret - 2}) {
        if (isDigit(index))
            return parts->placeOf(index);
    }
    return std::nullopt;
}

CaretText withDigitStepped(const CaretText &number, int place, double steps)
{
    const Parts before = *partsOf(number.text);
    const int index = before.indexOf(place);
    QString digits = number.text.left(before.end).trimmed();
    digits.replace(QChar(0x2212), u'-').replace(u',', u'.');
    const double stepped = digits.toDouble() + steps * std::pow(10.0, place);
    // The digits after the stepped one stay unchanged, and 0.1 + 0.2 is 0.3.
    CaretText after{fixedText(stepped, before.decimals()) + number.text.mid(before.end).trimmed(), 0};
    const Parts now = *partsOf(after.text);
    after.caret = now.indexOf(place) + (number.caret > index ? 1 : 0);
    return after;
}

} // namespace unprojector::gui
