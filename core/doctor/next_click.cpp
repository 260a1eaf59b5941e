#include "core/doctor/next_click.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace unprojector::doctor {
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

std::optional<glm::dvec3> answerOf(const Given &given, const Click &click, const Hypothesis &hypothesis)
{
    const auto parts = hypothesis.inOrder();
    return answer(given, click, {parts.data(), hypothesis.count});
}

} // namespace

std::optional<NextClick> nextClick(const Given &given, const Click &like, std::span<const Hypothesis> hypotheses,
                                   const std::function<std::optional<double>(const DevicePoint &)> &depthAt)
{
    std::optional<NextClick> best;
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const std::optional<DevicePoint> pixel = cellAt(given, column, row);
            if (!pixel)
                continue;
            Click click = like;
            click.pixel = *pixel;
            if (depthAt) {
                const std::optional<double> depth = depthAt(*pixel);
                if (!depth)
                    continue;
                click.depth = *depth;
            }
            setRightEye(given, click);
            const std::optional<glm::dvec3> first = answerOf(given, click, hypotheses.front());
            double apart = std::numeric_limits<double>::infinity();
            for (std::size_t i = 1; first && i < hypotheses.size(); ++i) {
                const std::optional<glm::dvec3> other = answerOf(given, click, hypotheses[i]);
                apart = std::min(apart, other ? glm::distance(*first, *other) : 0.0);
            }
            if (first && std::isfinite(apart) && apart > (best ? best->apart : 0.0))
                best = NextClick{*pixel, apart};
        }
    }
    return best;
}

} // namespace unprojector::doctor
