#pragma once

#include "core/geometry/components.h"

#include <QString>

namespace unprojector::gui {
using namespace geometry;

// How numbers are written everywhere in the window. Copied text uses the ASCII minus, so that it can be pasted into code.

/// All digits that make the double come back when read: "0.1", "1e-17".
QString shortestText(double value);

/// So many significant digits, trailing zeros dropped: "0.8284", "5.23", "3.1e-15".
QString significantText(double value, int digits);

/// All digits that make the double come back, written out where that is hardly longer than with a power of ten: "80000",
/// "0.00001", "1e+12"; never "-0".
QString writtenText(double value);
/// The same with so many significant digits, trailing zeros dropped; those before the decimal point all count: 12345.6
/// with four of them is "12346".
QString writtenText(double value, int digits);

/// So many decimals, at most 20; never "-0.000".
QString fixedText(double value, int decimals);

/// As a person writes how far something may be off: one significant digit, two if the first is 1; without an exponent from
/// a millionth to a million: "0.05", "0.0012", "300", "8 × 10⁻⁹".
QString readableText(double value);

/// Decimals with which the largest component of a point shows `digits` significant digits; from 0.1 to 1 one less.
int decimalsFor(const Components<3> &point, int digits);

/// Decimals that stay certain when a value may be off by `radius`; at least 0, at most 15.
int certainDecimals(double radius);

/// "(x, y, z)" with so many decimals.
QString pointText(const Components<3> &point, int decimals);

} // namespace unprojector::gui
