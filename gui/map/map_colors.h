#pragma once

#include "core/maps/pixel_map.h"

#include <QColor>
#include <QImage>

#include <vector>

namespace unprojector::gui {

/// Colours that go from dark to light, so that they can be told apart by anybody, and printed grey.
enum class ColorMap { Viridis, Cividis };

/// @param share  in [0, 1], from dark to light
/// Source: polynomials through the tables of matplotlib's viridis (within 0.006) and d3-scale-chromatic's of cividis.
QColor colorAt(ColorMap map, double share);

/// A logarithmic scale of the numbers of a map, 0 < low < high.
struct LogScale {
    double low = 1.0, high = 10.0;

    /// From the number that one pixel in a hundred is below, to the greatest; at least a tenth of a decade.
    static LogScale of(const maps::MapStatistics &statistics);

    /// Where a number lies on it, in [0, 1]; what is below or above, at its ends.
    double share(double number) const;
    /// Numbers to write beside it: powers of ten, with their multiples by 2 and 5 where there are few; their ends where
    /// there is none.
    std::vector<double> ticks() const;
};

/// A map in colours, a pixel each; where it has no number, clear.
QImage coloredMap(const maps::PixelMap &map, const LogScale &scale, ColorMap colors);

} // namespace unprojector::gui
