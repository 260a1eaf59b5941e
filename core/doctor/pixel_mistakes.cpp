#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/doctor/variant_list.h"

#include <glm/common.hpp>

#include <array>
#include <string>
#include <vector>

namespace unprojector::doctor {
using namespace geometry;
using base::marked;
namespace {

constexpr std::array kUsualRatios{2.0, 1.5, 1.25, 1.75, 3.0};
void scaleViewport(Run &run, double factor)
{
    run.viewport.x *= factor;
    run.viewport.y *= factor;
    run.viewport.width *= factor;
    run.viewport.height *= factor;
}

void addRatio(VariantList &list, double ratio)
{
    const std::string value = base::shortestText(ratio);
    const VariantName name(marked("ratio %1"), value);
    list.add(
        "ratio-logical-in-device", Stage::Pixel, [](Run &run, const Variant &v) { run.position /= v.parameter; }, ratio,
        name);
    list.add(
        "ratio-logical-both", Stage::Pixel,
        [](Run &run, const Variant &v) {
            run.position /= v.parameter;
            run.flipHeight /= v.parameter;
        },
        ratio, name);
    list.add(
        "ratio-device-in-logical", Stage::Pixel,
        [](Run &run, const Variant &v) { scaleViewport(run, 1.0 / v.parameter); }, ratio, name);
    // A ratio that is applied twice gives the same.
    list.add("ratio-device-in-logical", Stage::Pixel,
             [](Run &run, const Variant &v) {
                 scaleViewport(run, 1.0 / v.parameter);
                 run.flipHeight /= v.parameter;
             },
             ratio, {marked("ratio %1, flipped in logical pixels"), value});
}

/// Moves the position within the pixel, by device pixels to the right and up.
template <int RightHalves, int UpHalves>
void shift(Run &run, const Variant &)
{
    run.position += glm::dvec2(0.5 * RightHalves, -0.5 * UpHalves);
}

/// Moves the position to the lower left or upper left corner of its pixel.
template <int Down>
void toCorner(Run &run, const Variant &)
{
    run.position = glm::floor(run.position) + glm::dvec2(0.0, Down);
}

} // namespace

void addPixelMistakes(VariantList &list, const Given &given, const std::optional<Surface> &otherSize)
{
    std::vector<double> ratios(kUsualRatios.begin(), kUsualRatios.end());
    const double own = given.surface.devicePixelRatio;
    if (own != 1.0) {
        std::erase(ratios, own);
        ratios.insert(ratios.begin(), own);
    }
    for (const double ratio : ratios)
        addRatio(list, ratio);

    list.add("viewport-origin-ignored", Stage::Pixel,
             [](Run &run, const Variant &) { run.viewport.x = run.viewport.y = 0.0; });
    if (given.viewport.x != 0.0 && given.viewport.y != 0.0) {
        list.add(
            "viewport-origin-ignored", Stage::Pixel, [](Run &run, const Variant &) { run.viewport.y = 0.0; }, 0.0,
            marked("its y only"));
        list.add(
            "viewport-origin-ignored", Stage::Pixel, [](Run &run, const Variant &) { run.viewport.x = 0.0; }, 0.0,
            marked("its x only"));
    }
    list.add("flipped-with-viewport-height", Stage::Pixel,
             [](Run &run, const Variant &) { run.flipHeight = run.viewport.height; });
    list.add("viewport-is-window", Stage::Pixel, [](Run &run, const Variant &) {
        run.viewport = {0.0, 0.0, double(run.given.surface.widthPixels), double(run.given.surface.heightPixels)};
    });
    if (otherSize) {
        list.add(
            "viewport-stale", Stage::Pixel,
            [](Run &run, const Variant &v) {
                run.viewport = {0.0, 0.0, v.parameter, v.second};
                run.flipHeight = v.second;
            },
            *otherSize, marked("with its flip"));
        list.add(
            "viewport-stale", Stage::Pixel,
            [](Run &run, const Variant &v) {
                run.viewport = {0.0, 0.0, v.parameter, v.second};
            },
            *otherSize);
        list.add(
            "viewport-stale", Stage::Pixel, [](Run &run, const Variant &v) { run.flipHeight = v.second; }, *otherSize,
            marked("the flip only"));
    }
    list.add("viewport-y-from-top", Stage::Pixel, [](Run &run, const Variant &) {
        run.viewport.y = run.given.surface.heightPixels - run.viewport.y - run.viewport.height;
    });
    list.add("y-not-flipped", Stage::Pixel, [](Run &run, const Variant &) { run.isFlipped = false; });
    list.add(
        "y-not-flipped", Stage::Window,
        [](Run &run, const Variant &) { run.window.y = 2.0 * run.viewport.y + run.viewport.height - run.window.y; },
        0.0, marked("about the middle of the viewport"));

    list.add("pixel-corner", Stage::Pixel, shift<-1, -1>, 0.0, marked("lower left corner"));
    list.add("pixel-corner", Stage::Pixel, shift<-1, 1>, 0.0, marked("upper left corner"));
    list.add("pixel-corner", Stage::Pixel, shift<-1, 0>, 0.0, marked("x only"));
    list.add("pixel-corner", Stage::Pixel, shift<0, -1>, 0.0, marked("y only, lower edge"));
    list.add("pixel-corner", Stage::Pixel, shift<0, 1>, 0.0, marked("y only, upper edge"));
    list.add("pixel-corner", Stage::Pixel, toCorner<1>, 0.0, marked("lower left corner of the whole pixel"));
    list.add("pixel-corner", Stage::Pixel, toCorner<0>, 0.0, marked("upper left corner of the whole pixel"));
    list.add("half-pixel-twice", Stage::Pixel, shift<1, -1>, 0.0, marked("to the right and down"));
    list.add("half-pixel-twice", Stage::Pixel, shift<1, 1>, 0.0, marked("to the right and up"));
    // The first and the last pixel's centres lie on the edges: linspace(-1, 1, W).
    list.add(
        "pixel-in-size-minus-one", Stage::Window,
        [](Run &run, const Variant &) {
            const Viewport &v = run.viewport;
            run.window.x = v.x + (run.window.x - v.x - kHalfPixel) * v.width / (v.width - 1.0);
            run.window.y = v.y + (run.window.y - v.y - kHalfPixel) * v.height / (v.height - 1.0);
        },
        0.0, marked("from the pixel's centre"));
    list.add(
        "pixel-in-size-minus-one", Stage::Window,
        [](Run &run, const Variant &) {
            const Viewport &v = run.viewport;
            const double top = v.y + v.height;
            run.window.x = v.x + (run.window.x - v.x) * v.width / (v.width - 1.0);
            run.window.y = top - (top - run.window.y) * v.height / (v.height - 1.0);
        },
        0.0, marked("from the pixel's corner"));
    list.add(
        "y-is-depth", Stage::Window, [](Run &run, const Variant &) { run.window.y = run.click.depth; }, 0.0,
        marked("in the window"));
    list.add(
        "y-is-depth", Stage::Window,
        [](Run &run, const Variant &) {
            const auto &[atNear, atFar] = run.given.depthRange;
            const double depth = (run.click.depth - atNear) / (atFar - atNear);
            const double z = run.given.ndcDepth == NdcDepth::ZeroToOne ? depth : 2.0 * depth - 1.0;
            run.window.y = run.viewport.y + (z + 1.0) / 2.0 * run.viewport.height;
        },
        0.0, marked("in NDC"));
    list.add("row-above", Stage::Pixel, shift<0, 2>);
    list.add("row-below", Stage::Pixel, shift<0, -2>);
    list.add("xy-swapped", Stage::Window, [](Run &run, const Variant &) { run.window = {run.window.y, run.window.x}; });
    list.add(
        "xy-swapped", Stage::Pixel,
        [](Run &run, const Variant &) {
            run.position = {run.position.y, run.position.x};
        },
        0.0, marked("before the flip"));
}

} // namespace unprojector::doctor
