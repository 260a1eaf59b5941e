#include "core/base/translation.h"
#include "core/doctor/solved_mistakes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>

/// Pixels that are scaled and moved: those of a letterboxed window, or of a larger surface that the
/// view is fitted into.
namespace unprojector::doctor {
using namespace geometry;
using base::marked;
namespace {

/// The surface whose pixels the program uses. It shows the view between two bars of one size.
struct Letterbox {
    int barAxis = 0;          ///< 0: the bars are left and right; 1: above and below
    bool isFlippedIn = false; ///< its own height flips y
    glm::dvec2 surface{0.0};  ///< the scene's sizes, device pixels
    glm::dvec2 viewport{0.0};
    int freeAxis() const { return 1 - barAxis; }
};

/// The scale and the bar.
using Fit = glm::dvec2;

/// One point determines both, because the axis without bars is scaled only.
std::optional<Fit> fitOf(const Given &given, const Letterbox &box, const Click &click, const glm::dvec3 &got)
{
    const auto there = projected(given, click, got);
    if (!there)
        return std::nullopt;
    const auto fromCorner = [&](double x, double y) {
        return glm::dvec2(x, box.isFlippedIn ? flippedY(given.surface, y) : y);
    };
    const glm::dvec2 right = fromCorner(click.pixel.x, click.pixel.y), wrong = fromCorner(there->x, there->y);
    const double scale = wrong[box.freeAxis()] / right[box.freeAxis()];
    return Fit(scale, wrong[box.barAxis] - scale * right[box.barAxis]);
}

/// Two numbers that give the fit, as a program may have them.
struct Numbers {
    glm::dvec2 (*of)(const Letterbox &box, const Fit &fit);
    Fit (*fit)(const Letterbox &box, const glm::dvec2 &numbers);
};

constexpr Numbers kNumbers[] = {
    // The scale and the bar themselves
    {[](const Letterbox &, const Fit &fit) { return fit; }, [](const Letterbox &, const glm::dvec2 &n) { return n; }},
    // The size of the surface
    {[](const Letterbox &box, const Fit &fit) {
         return glm::dvec2(fit.x * box.surface[box.freeAxis()], fit.x * box.surface[box.barAxis] + 2.0 * fit.y);
     },
     [](const Letterbox &box, const glm::dvec2 &n) {
         const double scale = n.x / box.surface[box.freeAxis()];
         return Fit(scale, (n.y - scale * box.surface[box.barAxis]) / 2.0);
     }},
    // The size of the view before it is fitted into the viewport, and the viewport's origin
    {[](const Letterbox &box, const Fit &fit) { return glm::dvec2(box.viewport[box.freeAxis()] / fit.x, fit.y); },
     [](const Letterbox &box, const glm::dvec2 &n) { return Fit(box.viewport[box.freeAxis()] / n.x, n.y); }},
    // The scale and the bar of the scene's own surface, which the program undoes
    {[](const Letterbox &, const Fit &fit) { return glm::dvec2(1.0 / fit.x, -fit.y / fit.x); },
     [](const Letterbox &, const glm::dvec2 &n) { return Fit(1.0 / n.x, -n.y / n.x); }},
};
constexpr int kLetterboxes = 4;

Variant variantOf(const Letterbox &box, const Fit &fit)
{
    glm::dvec2 moved(0.0);
    moved[box.barAxis] = fit.y;
    Variant variant = scaledAndMoved(fit.x, moved.x, moved.y);
    if (!box.isFlippedIn)
        return variant;
    const double height = withoutNoise(fit.x * box.surface.y + 2.0 * moved.y);
    variant.apply = [](Run &run) {
        run.position = (*run.matrix)[0][0] * run.position + glm::dvec2(run.parameter, run.second);
        run.flipHeight = (*run.matrix)[0][1];
    };
    variant.matrix[0][1] = height;
    variant.name.words = marked("scaled by %1 and moved by (%2), y flipped with a height of %3");
    variant.name.sentence =
        marked("Your program's pixel is scaled by %1 and moved by (%2), and a height of %3 flips its y.");
    variant.name.values.push_back(valueText(height));
    variant.values.push_back({"flipHeight", {height}});
    return variant;
}

/// True if a fit is more than a shift and more than a scale, and a window can show it.
bool isLetterbox(const Letterbox &box, const Solution &scale, const Solution &bar)
{
    constexpr double kMostScale = 20.0;
    const glm::dvec2 size = kNumbers[1].of(box, Fit(scale.value, bar.value));
    return std::abs(scale.value - 1.0) > scale.unsure && std::abs(bar.value) > bar.unsure && scale.value < kMostScale
           && scale.value * kMostScale > 1.0 && size.x > 0.0 && size.y > 0.0;
}

void addLetterbox(VariantList &list, const Given &given, const Letterbox &box, std::span<const double> known)
{
    const auto solved = [&](const Numbers &numbers, int k) {
        return solvedFrom(given, [&](const Answered &of) -> Value {
            const auto fit = fitOf(given, box, of.click, of.got);
            return fit ? std::optional(numbers.of(box, *fit)[k]) : std::nullopt;
        });
    };
    const auto scale = solved(kNumbers[0], 0), bar = solved(kNumbers[0], 1);
    if (!scale || !bar || !isLetterbox(box, *scale, *bar))
        return;
    for (const Numbers &numbers : kNumbers) {
        const auto first = solved(numbers, 0), second = solved(numbers, 1);
        if (!first || !second)
            continue;
        const std::array two{*first, *second};
        addSolved(
            list, "pixel-scaled-and-moved", two, known,
            [&](std::span<const double> n) { return variantOf(box, numbers.fit(box, glm::dvec2(n[0], n[1]))); },
            kLetterboxes * int(std::size(kNumbers)));
    }
}

} // namespace

Variant scaledAndMoved(double scale, double dx, double dy)
{
    dx = withoutNoise(dx);
    dy = withoutNoise(dy);
    scale = withoutNoise(scale);
    Variant variant{
        .stage = Stage::Pixel,
        .apply =
            [](Run &run) { run.position = (*run.matrix)[0][0] * run.position + glm::dvec2(run.parameter, run.second); },
        .parameter = dx,
        .second = dy,
        .name = {marked("scaled by %1 and moved by (%2)"),
                 {valueText(scale), valueText(dx) + ", " + valueText(dy)},
                 marked("Your program's pixel is scaled by %1 and moved by (%2).")},
        .values = {{"scale", {scale}}, {"dx", {dx}}, {"dy", {dy}}}};
    variant.matrix[0][0] = scale;
    return variant;
}

void addLetterboxes(VariantList &list, const Given &given, const Case &scene)
{
    const Viewport &v = given.viewport;
    std::vector<double> known = usualSizes(given, scene);
    for (const double place : {v.x, v.y, flippedY(given.surface, v.y + v.height)}) {
        if (place != 0.0)
            known.push_back(place);
    }
    for (const bool isFlippedIn : {false, true}) {
        for (const int barAxis : {0, 1})
            addLetterbox(
                list, given,
                {barAxis, isFlippedIn, {given.surface.widthPixels, given.surface.heightPixels}, {v.width, v.height}},
                known);
    }
}

} // namespace unprojector::doctor
