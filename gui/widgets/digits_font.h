#pragma once

#include <QFont>

namespace unprojector::gui {

/// The font of columns of numbers that stand beside a text: each digit as wide as the other.
QFont digitsFont(const QFont &text);
/// The text's own font inside a table that is set in digits: every property is given, so that none is inherited.
QFont headsFont(const QFont &text);
/// What one line of a text needs, with the fonts that stand in for characters that the font has not: ideographs are higher
/// than the letters of most fonts.
int lineHeight(const QFont &font, const QString &text);

} // namespace unprojector::gui
