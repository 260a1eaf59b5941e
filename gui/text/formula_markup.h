#pragma once

#include <QColor>
#include <QString>

namespace unprojector::gui {

/// The rich text of a page whose formulas are written in a short form. What Qt's rich text lacks is set with tables.
///
///   <formula no="9" name="w9">x = {(px − v<sub>x</sub>)(r − l) z | width · n} + {l z | n}</formula>
///   <formula>T = {1, 0, 0, x; 0, 1, 0, y; 0, 0, 1, z; 0, 0, 0, 1}</formula>
///
/// `{a | b}` is a fraction, `{a, b; c, d}` a matrix with its rows separated by `;` (`{x; y}` a column); both may hold
/// fractions. Single Latin letters are set in italics, except in <sub>, <sup> and <b>. `no` is printed at the right in parentheses, `name` is an anchor;
/// both may be missing. Everything outside <formula> is passed on as it is.
/// @param lines  of the fractions' bars and the matrices' brackets: as the text, which rich text does not take for lines
QString typeset(const QString &page, const QColor &lines = Qt::black);

} // namespace unprojector::gui
