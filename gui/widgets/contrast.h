#pragma once

#include <QColor>

namespace unprojector::gui {

/// The contrast that easily readable text needs (WCAG 2.1, 1.4.3).
constexpr double kReadableContrast = 4.5;

/// The contrast of two opaque colours, from 1 (none) to 21 (black on white).
/// Source: WCAG 2.1, relative luminance.
double contrast(const QColor &a, const QColor &b);

/// The quietest readable ink on a base: ink mixed with the base down to kReadableContrast; the ink
/// itself if its contrast is not higher.
QColor quietInk(const QColor &ink, const QColor &base);

/// @param shareOfB  0: a, 1: b
QColor mixed(const QColor &a, const QColor &b, double shareOfB);

} // namespace unprojector::gui
