#pragma once

#include "core/geometry/components.h"

#include <QString>

namespace unprojector::gui {

// How numbers are written everywhere in the window. Copied text uses the ASCII minus, so that it can be pasted into code.
//
// What is measured in the scene's units or in pixels is written out, so that the coordinates of a survey can be read: from
// a ten-thousandth to ten thousand million. Only beyond, and below where it is much shorter, there is a power of ten. How
// large a difference or a ratio is has few digits, and a power of ten sooner: the zeros would say more than is known.

/// All digits that make the double come back when read: "0.1", "4000000", "1e-17".
QString shortestText(double value);
/// The same; never "-0".
QString writtenText(double value);
/// The same with so many significant digits, trailing zeros dropped; those before the decimal point all count: 12345.6
/// with four of them is "12346".
QString writtenText(double value, int digits);
/// A coordinate in pixels, to a hundredth at most: "412.5".
QString pixelText(double pixels);
/// How large something is: so many significant digits, trailing zeros dropped: "0.83", "5.2", "3.1e-15", "1.2e+06".
QString significantText(double value, int digits);

/// A window depth from which its point comes out as sure as the depth buffer is: 12 significant digits, five more than single
/// precision has. Close to a far plane a step of the last is stretched by far over near, as the buffer's own steps are.
QString depthText(double depth);

/// So many decimals, at most 20; never "-0.000".
QString fixedText(double value, int decimals);

/// As a person writes how far something may be off: one significant digit, two if the first is 1; without an exponent from
/// a millionth to a million: "0.05", "0.0012", "300", "8 × 10⁻⁹".
QString readableText(double value);
/// The same of what nothing exceeds: rounded up.
/// @param bound  not below 0
QString boundText(double bound);

/// Where the digits of a number that may be off by `uncertainty` end: the exponent of the smallest power of ten that is no
/// smaller than it, -2 for 0.007 and for 0.01, 3 for 300. -20 where nothing is uncertain.
int certainPlace(double uncertainty);

/// Rounded to the certain place: "-3.0" for -2.9999994 that may be off by 0.05, "1000" for 1234 that may be off by 300. With
/// a power of ten where there would be many zeros: "1.23e-09", "1.25e+20".
QString certainText(double value, double uncertainty);

/// How the coordinates of a point are written one under the other.
struct Notation {
    int decimals = 15;         ///< of the mantissa where it has a power of ten
    bool isScientific = false; ///< "-1.234e-09"
    QString text(double value) const;
    /// Characters of text(value) down to the certain place, as far as they reach: "1.98" of 1.9890016 that may be off by 0.008.
    /// Rounded there, the value is what certainText says, 1.99. Where all its digits stand below that place and it rounds up
    /// to it, the first digit; 0 where it rounds to nothing.
    /// @param uncertainty  of the value
    qsizetype certainLength(double value, double uncertainty) const;
    /// The place of the last digit of text(value), as certainPlace counts.
    int lastPlace(double value) const;
};

/// The most digits of a point's coordinates that a column has room for, up to `digits` significant ones of the largest: as many
/// decimals of each. Where that would be less than thousandths, coordinates that have room for more have up to those: what
/// is shorter than the largest need not lose its place for it.
/// @param coordinate  the one of them that is to be written
/// @param characters  the column's room, with a sign and the decimal point
Notation notationOf(const geometry::Components<3> &point, double coordinate, int digits, int characters);

/// The digits of a coordinate that say something: those that are certain and two more, which a comparison is made by. Of one that
/// nothing is uncertain of, ten of the point's largest coordinate.
/// @param uncertainty  of the coordinate
Notation notationWithin(const geometry::Components<3> &point, double coordinate, double uncertainty);

/// Decimals with which the largest component of a point shows `digits` significant digits; from 0.1 to 1 one less.
int decimalsFor(const geometry::Components<3> &point, int digits);

/// "(x, y, z)", each coordinate rounded to the place that its uncertainty leaves certain.
QString pointText(const geometry::Components<3> &point, const geometry::Components<3> &uncertainty);

} // namespace unprojector::gui
