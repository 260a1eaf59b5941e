#pragma once

#include <QFont>

namespace unprojector::gui {

/// The font for columns of numbers beside a text: all digits have the same width.
QFont digitsFont(const QFont &text);
/// The text's own font inside a table in digitsFont: every property is set, so that none is
/// inherited.
QFont headsFont(const QFont &text);
/// The height of one line of text, including fallback fonts: ideographs are higher than the letters
/// of most fonts.
int lineHeight(const QFont &font, const QString &text);

} // namespace unprojector::gui
