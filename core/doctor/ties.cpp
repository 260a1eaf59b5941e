#include "core/doctor/ties.h"

#include "core/doctor/next_click.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

namespace unprojector::doctor {
using namespace geometry;

namespace {

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

bool isSameHere(const Given &given, std::span<const Target> points, const Hypothesis &a, const Hypothesis &b)
{
    return std::all_of(points.begin(), points.end(), [&](const Target &target) {
        return std::all_of(target.clicks.begin(), target.clicks.end(), [&](const Click &click) {
            const auto first = a.answerTo(given, click), second = b.answerTo(given, click);
            return first && second && isSameAnswer(*first, *second);
        });
    });
}

Alike alikeOf(const Given &given, std::span<const Target> points, const Hypothesis &best, const Hypothesis &other)
{
    if (isSameHere(given, points, best, other))
        return isSameEverywhere(given, points.front().clicks.front(), best, other) ? Alike::Always : Alike::Here;
    // All depth mistakes explain a point on the ray if only rays are known.
    if (std::any_of(points.begin(), points.end(), [](const Target &target) { return target.isLine; }))
        return Alike::No;
    const double allowed = best.worst <= kRounded ? kRounded : kCutOff;
    const bool isAsSimple =
        other.count == best.count && other.isSolved() == best.isSolved() && other.isExpected() == best.isExpected();
    return isAsSimple && other.worst <= allowed ? Alike::InDigits : Alike::No;
}

bool isRestated(const Given &given, std::span<const Target> points, const Hypothesis &best, const Hypothesis &pair)
{
    if (best.count != 1 || pair.count != 2)
        return false;
    const std::string_view id = mistakes()[best.parts[0]->mistake].id;
    const bool isTwoByName = id == "opencv-axes"; // y not flipped, and z of the eye point positive
    return (isTwoByName || pair.parts[0]->stage == pair.parts[1]->stage)
           && alikeOf(given, points, best, pair) == Alike::Always;
}

Shared sharedOf(const Given &given, const Click &click, const Hypothesis &a, const Hypothesis &b)
{
    const std::optional<Run> right = ran(given, click, {}), first = a.ranFor(given, click),
                             second = b.ranFor(given, click);
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

} // namespace unprojector::doctor
