#pragma once

#include <QColor>

namespace unprojector::gui {

/// What text on a surface needs to be read with ease (WCAG 2.1, 1.4.3).
constexpr double kReadableContrast = 4.5;

/// The contrast of two opaque colours, from 1 (none) to 21 (black on white).
/// Source: WCAG 2.1, relative luminance.
double contrast(const QColor &a, const QColor &b);

/// As quiet as text can be and still be read on a base: ink mixed with the base down to kReadableContrast; the ink itself
/// where that has no more.
QColor quietInk(const QColor &ink, const QColor &base);

/// @param shareOfB  0: a, 1: b
QColor mixed(const QColor &a, const QColor &b, double shareOfB);

} // namespace unprojector::gui
