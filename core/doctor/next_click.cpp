#include "core/doctor/next_click.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace unprojector::doctor {
using namespace geometry;

namespace {

/// Columns and rows of the grid.
constexpr int kColumns = 16, kRows = 12;

/// The centre of the pixel in the middle of a cell of the grid, if it is in the framebuffer.
std::optional<DevicePoint> cellAt(const Given &given, int column, int row)
{
    const Viewport &v = given.viewport;
    const double x = v.x + v.width * (column + 0.5) / kColumns;
    const double y = flippedY(given.surface, v.y + v.height * (row + 0.5) / kRows);
    if (x < 0.0 || y < 0.0 || x >= given.surface.widthPixels || y >= given.surface.heightPixels)
        return std::nullopt;
    return DevicePoint(std::floor(x) + kHalfPixel, std::floor(y) + kHalfPixel);
}

/// The distance of two hypotheses' answers, click by click; 0 where one has none.
std::vector<double> apartOf(const Given &given, std::span<const Click> clicks, const Hypothesis &a, const Hypothesis &b)
{
    std::vector<double> apart;
    for (const Click &click : clicks) {
        const std::optional<glm::dvec3> first = a.answerTo(given, click), second = b.answerTo(given, click);
        const double distance = first && second ? glm::distance(*first, *second) : 0.0;
        apart.push_back(std::isfinite(distance) ? distance : 0.0);
    }
    return apart;
}

} // namespace

std::vector<Click> clicksOverViewport(const Given &given, const Click &like,
                                      const std::function<std::optional<double>(const DevicePoint &)> &depthAt)
{
    std::vector<Click> clicks;
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const std::optional<DevicePoint> pixel = cellAt(given, column, row);
            if (!pixel)
                continue;
            const std::optional<double> depth = depthAt ? depthAt(*pixel) : like.depth;
            if (!depth)
                continue;
            Click click = like;
            click.depth = *depth;
            setPixel(given, click, *pixel);
            clicks.push_back(click);
        }
    }
    return clicks;
}

std::optional<NextClick> nextClick(const Given &given, const Click &like, std::span<const Hypothesis> hypotheses,
                                   const std::function<std::optional<double>(const DevicePoint &)> &depthAt,
                                   double tellable)
{
    const std::vector<Click> clicks = clicksOverViewport(given, like, depthAt);
    std::vector<double> least(clicks.size(), std::numeric_limits<double>::infinity());
    bool isTold = false;
    for (std::size_t i = 1; i < hypotheses.size(); ++i) {
        const std::vector<double> apart = apartOf(given, clicks, hypotheses.front(), hypotheses[i]);
        if (std::none_of(apart.begin(), apart.end(), [&](double each) { return each >= tellable; }))
            continue;
        isTold = true;
        for (std::size_t k = 0; k < least.size(); ++k)
            least[k] = std::min(least[k], apart[k]);
    }
    if (!isTold)
        return std::nullopt;
    const auto best = std::max_element(least.begin(), least.end());
    const Click &click = clicks[std::size_t(best - least.begin())];
    return NextClick{DevicePoint(click.pixel.x + click.distortedBy.x, click.pixel.y + click.distortedBy.y), *best};
}

} // namespace unprojector::doctor
