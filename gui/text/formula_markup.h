#pragma once

#include <QColor>
#include <QString>

namespace unprojector::gui {

/// Converts a page with formulas in a short notation to rich text. Tables replace what Qt's rich
/// text lacks.
///
///   <formula no="9" name="w9">
///     x = {(px − v<sub>x</sub>)(r − l) z | width · n} + {l z | n}</formula>
///   <formula>T = {1, 0, 0, x; 0, 1, 0, y; 0, 0, 1, z; 0, 0, 0, 1}</formula>
///
/// `{a | b}` is a fraction, `{a, b; c, d}` a matrix with its rows separated by `;` (`{x; y}` a
/// column); both may contain fractions. Single Latin letters are set in italics, except in <sub>,
/// <sup> and <b>. `no` is printed at the right in parentheses, `name` is an anchor; both are
/// optional. Text outside <formula> is copied unchanged.
/// @param lines  colour of the fractions' bars and the matrices' brackets: the text's colour, which
/// rich text doesn't apply to lines
QString typeset(const QString &page, const QColor &lines = Qt::black);

} // namespace unprojector::gui
