#pragma once

#include "core/maps/pixel_map.h"

#include <QColor>
#include <QImage>

#include <vector>

namespace unprojector::gui {

/// Colour maps from dark to light: distinguishable for everyone, and in grey print.
enum class ColorMap { Viridis, Cividis };

/// @param share  in [0, 1], from dark to light
/// Source: polynomials through the tables of matplotlib's viridis (within 0.006) and
/// d3-scale-chromatic's of cividis.
QColor colorAt(ColorMap map, double share);

/// A logarithmic scale of the numbers of a map, 0 < low < high.
struct LogScale {
    double low = 1.0, high = 10.0;

    /// The scale from the first percentile of the numbers to the greatest; at least a tenth of a
    /// decade.
    static LogScale of(const maps::MapStatistics &statistics);

    /// The position of a number on the scale, in [0, 1]; clamped to the ends.
    double share(double number) const;
    /// The numbers to write beside it: powers of ten, with their multiples by 2 and 5 if they are
    /// few; the ends if there is none.
    std::vector<double> ticks() const;
};

/// A map in colours, a pixel each; transparent without a number.
QImage coloredMap(const maps::PixelMap &map, const LogScale &scale, ColorMap colors);

} // namespace unprojector::gui
