#pragma once

#include "core/geometry/components.h"

#include <QString>

namespace unprojector::gui {

// The notation of all numbers in the window. Copied text uses the ASCII minus, so that it can be
// pasted into code.
//
// Values in the scene's units or in pixels are written out, so that the coordinates of a survey are
// readable: from a ten-thousandth to ten thousand million. Only larger values, and smaller ones
// where it is much shorter, have a power of ten. Differences and ratios have few digits, and a
// power of ten sooner: zeros would suggest more digits than are known.

/// The shortest text that is read back as the same double: "0.1", "4000000", "1e-17".
QString shortestText(double value);
/// The same; never "-0".
QString writtenText(double value);
/// The same with so many significant digits and without trailing zeros; all digits before the
/// decimal point stay: 12345.6 with four digits is "12346".
QString writtenText(double value, int digits);
/// A coordinate in pixels, to a hundredth at most: "412.5".
QString pixelText(double pixels);
/// A magnitude with `digits` significant digits, without trailing zeros: "0.83", "5.2", "3.1e-15",
/// "1.2e+06".
QString significantText(double value, int digits);

/// A window depth that gives its point with the precision of the depth buffer: 12 significant
/// digits, five more than single precision. Near the far plane, far over near magnifies a step of
/// the last digit, like the buffer's own steps.
QString depthText(double depth);

/// The value with so many decimals, at most 20; never "-0.000".
QString fixedText(double value, int decimals);

/// An uncertainty as people write it: one significant digit, two if the first is 1; without an
/// exponent from a millionth to a million: "0.05", "0.0012", "300", "8 × 10⁻⁹".
QString readableText(double value);
/// An upper bound in that form: rounded up.
/// @param bound  not below 0
QString boundText(double bound);

/// The certain place of a number that may be off by `uncertainty`: the exponent of the smallest
/// power of ten that is not below it, -2 for 0.007 and for 0.01, 3 for 300. -20 for an uncertainty
/// of 0.
int certainPlace(double uncertainty);

/// The value rounded to the certain place: "-3.0" for -2.9999994 ± 0.05, "1000" for 1234 ± 300. Has
/// a power of ten if there would be many zeros: "1.23e-09", "1.25e+20".
QString certainText(double value, double uncertainty);

/// The notation of a point's coordinates in a column.
struct Notation {
    int decimals = 15;         ///< of the mantissa if it has a power of ten
    bool isScientific = false; ///< "-1.234e-09"
    QString text(double value) const;
    /// The number of characters of text(value) down to the certain place: "1.98" for 1.9890016 ±
    /// 0.008. Rounded there, the value is certainText: 1.99. If all its digits are below that place
    /// and it rounds up to it, the first digit; 0 if it rounds to zero.
    /// @param uncertainty  of the value
    qsizetype certainLength(double value, double uncertainty) const;
    /// The place of the last digit of text(value), counted as in certainPlace.
    int lastPlace(double value) const;
};

/// The notation with the most digits that fit into a column, up to `digits` significant ones of the
/// largest coordinate: all coordinates get the same number of decimals. If those would be less than
/// thousandths, coordinates with room get up to three: a shorter one keeps its decimals although
/// the largest has none.
/// @param coordinate  the one to write
/// @param characters  the column's room, with a sign and the decimal point
Notation notationOf(const geometry::Components<3> &point, double coordinate, int digits, int characters);

/// The notation with the meaningful digits of a coordinate: the certain ones and two more, for
/// comparisons. For an uncertainty of 0, ten digits of the point's largest coordinate.
/// @param uncertainty  of the coordinate
Notation notationWithin(const geometry::Components<3> &point, double coordinate, double uncertainty);

/// The number of decimals with which a point's largest component shows `digits` significant digits;
/// one less from 0.1 to 1.
int decimalsFor(const geometry::Components<3> &point, int digits);

/// "(x, y, z)", each coordinate rounded to its certain place.
QString pointText(const geometry::Components<3> &point, const geometry::Components<3> &uncertainty);

} // namespace unprojector::gui
