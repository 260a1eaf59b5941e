#include "core/doctor/ties.h"

#include "core/doctor/mistakes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

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
        const auto first = a.answerTo(given, click), second = b.answerTo(given, click);
        const double distance = first && second ? glm::distance(*first, *second) : 0.0;
        apart.push_back(std::isfinite(distance) ? distance : 0.0);
    }
    return apart;
}

/// Clicks of the same program on a grid over the viewport, where a surface is visible.
/// @param like, depthAt  see nextClick
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

bool isSame(const glm::dvec3 &a, const glm::dvec3 &b)
{
    return isSameAnswer(a, b);
}

bool isSame(const glm::dmat4 &a, const glm::dmat4 &b)
{
    double size = 1.0, off = 0.0;
    for (int i = 0; i < 16; ++i) {
        const double difference = std::abs(a[i / 4][i % 4] - b[i / 4][i % 4]);
        if (!std::isfinite(difference))
            return false;
        size = std::max(size, std::abs(b[i / 4][i % 4]));
        off = std::max(off, difference);
    }
    return off <= 1e-9 * size;
}

/// Clicks all over the viewport, each at a different depth.
std::vector<Click> clicksEverywhere(const Given &given, const Click &like)
{
    constexpr double kGoldenShare = 0.6180339887498949, kFromPlane = 0.05;
    const auto [low, high] = std::minmax(given.depthRange.atNear, given.depthRange.atFar);
    std::size_t count = 0;
    return clicksOverViewport(given, like, [&, low = low, high = high](const DevicePoint &) {
        const double turns = double(++count) * kGoldenShare, share = turns - std::floor(turns);
        return std::optional(low + (kFromPlane + (1.0 - 2.0 * kFromPlane) * share) * (high - low));
    });
}

bool isSameEverywhere(const Given &given, const Click &like, const Hypothesis &a, const Hypothesis &b)
{
    const std::vector<Click> clicks = clicksEverywhere(given, like);
    return std::all_of(clicks.begin(), clicks.end(), [&](const Click &click) {
        const auto first = a.answerTo(given, click), second = b.answerTo(given, click);
        return !first || !second ? first.has_value() == second.has_value() : isSameAnswer(*first, *second);
    });
}

} // namespace

bool isSameHere(const Given &given, const Hypothesis &a, const Hypothesis &b)
{
    return std::all_of(given.points.begin(), given.points.end(), [&](const Target &target) {
        return std::all_of(target.clicks.begin(), target.clicks.end(), [&](const Click &click) {
            const auto first = a.answerTo(given, click), second = b.answerTo(given, click);
            return first && second && isSameAnswer(*first, *second);
        });
    });
}

Alike alikeOf(const Given &given, const Hypothesis &best, const Hypothesis &other)
{
    if (isSameHere(given, best, other))
        return isSameEverywhere(given, given.points.front().clicks.front(), best, other) ? Alike::Always : Alike::Here;
    // All depth mistakes explain a point on the ray if only rays are known.
    if (std::any_of(given.points.begin(), given.points.end(), [](const Target &target) { return target.isLine; }))
        return Alike::No;
    const double allowed = best.worst <= kRounded ? kRounded : kCutOff;
    const bool isAsSimple =
        other.count == best.count && other.isSolved() == best.isSolved() && other.isExpected() == best.isExpected();
    return isAsSimple && other.worst <= allowed ? Alike::InDigits : Alike::No;
}

bool isRestated(const Given &given, const Hypothesis &best, const Hypothesis &pair)
{
    if (best.count != 1 || pair.count != 2)
        return false;
    const std::string_view id = mistakes()[best.parts[0]->mistake].id;
    const bool isTwoByName = id == "opencv-axes"; // y not flipped, and z of the eye point positive
    return (isTwoByName || pair.parts[0]->stage == pair.parts[1]->stage) && alikeOf(given, best, pair) == Alike::Always;
}

Shared sharedOf(const Given &given, const Click &click, const Hypothesis &a, const Hypothesis &b)
{
    const auto right = ran(given, click, {}), first = a.ranFor(given, click), second = b.ranFor(given, click);
    if (!right || !first || !second)
        return Shared::Point;
    const auto isShared = [&](const auto &partOf) {
        return isSame(partOf(*first), partOf(*second)) && !isSame(partOf(*first), partOf(*right));
    };
    if (isShared([](const Run &run) { return glm::dvec3(run.window, 0.0); }))
        return Shared::Window;
    if (isShared([](const Run &run) { return glm::dvec3(run.depth, 0.0, 0.0); }))
        return Shared::Depth;
    if (isShared([](const Run &run) { return run.clipFromEye; }))
        return Shared::Projection;
    if (isShared([](const Run &run) { return run.eyeFromWorld; }))
        return Shared::View;
    if (isShared([](const Run &run) { return run.ndc; }))
        return Shared::Ndc;
    const bool haveMatrices = !first->isClosedForm && !second->isClosedForm;
    return haveMatrices && isShared([](const Run &run) { return run.spaceFromClip; }) ? Shared::Matrix : Shared::Point;
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
