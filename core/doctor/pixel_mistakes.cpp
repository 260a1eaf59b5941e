#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/doctor/variants.h"

#include <glm/common.hpp>

#include <string>

namespace unprojector::doctor {
using namespace geometry;
using base::marked;
namespace {

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
    const VariantName name(marked("ratio %1"), {value});
    list.add(
        "ratio-logical-in-device", Stage::Pixel, [](Run &run) { run.position /= run.parameter; }, name, ratio);
    list.add(
        "ratio-logical-both", Stage::Pixel,
        [](Run &run) {
            run.position /= run.parameter;
            run.flipHeight /= run.parameter;
        },
        name, ratio);
    list.add(
        "ratio-device-in-logical", Stage::Pixel, [](Run &run) { scaleViewport(run, 1.0 / run.parameter); }, name,
        ratio);
    // A ratio that is applied twice gives the same.
    list.add(
        "ratio-device-in-logical", Stage::Pixel,
        [](Run &run) {
            scaleViewport(run, 1.0 / run.parameter);
            run.flipHeight /= run.parameter;
        },
        {marked("ratio %1, flipped in logical pixels"), {value}}, ratio);
}

/// Moves the position by half device pixels to the right and up.
void shift(Run &run)
{
    run.position += glm::dvec2(0.5 * run.parameter, -0.5 * run.second);
}

/// Moves the position to the upper left corner of its pixel, and down.
void toCorner(Run &run)
{
    run.position = glm::floor(run.position) + glm::dvec2(0.0, run.parameter);
}

} // namespace

void addPixelMistakes(VariantList &list, const Given &given, const Case &scene)
{
    const double own = given.surface.devicePixelRatio;
    if (own != 1.0)
        addRatio(list, own);
    for (const double usual : {2.0, 1.5, 1.25, 1.75, 3.0}) {
        if (usual != own)
            addRatio(list, usual);
    }

    list.add("viewport-origin-ignored", Stage::Pixel, [](Run &run) { run.viewport.x = run.viewport.y = 0.0; });
    if (given.viewport.x != 0.0 && given.viewport.y != 0.0) {
        list.add(
            "viewport-origin-ignored", Stage::Pixel, [](Run &run) { run.viewport.y = 0.0; }, marked("its y only"));
        list.add(
            "viewport-origin-ignored", Stage::Pixel, [](Run &run) { run.viewport.x = 0.0; }, marked("its x only"));
    }
    list.add("flipped-with-viewport-height", Stage::Pixel, [](Run &run) { run.flipHeight = run.viewport.height; });
    list.add("viewport-is-window", Stage::Pixel, [](Run &run) {
        run.viewport = {0.0, 0.0, double(run.given.surface.widthPixels), double(run.given.surface.heightPixels)};
    });
    if (const auto &other = scene.otherSize) {
        list.add(
            "viewport-stale", Stage::Pixel,
            [](Run &run) {
                run.viewport = {0.0, 0.0, run.parameter, run.second};
                run.flipHeight = run.second;
            },
            marked("with its flip"), other->widthPixels, other->heightPixels);
        list.add(
            "viewport-stale", Stage::Pixel,
            [](Run &run) {
                run.viewport = {0.0, 0.0, run.parameter, run.second};
            },
            {}, other->widthPixels, other->heightPixels);
        list.add(
            "viewport-stale", Stage::Pixel, [](Run &run) { run.flipHeight = run.second; }, marked("the flip only"),
            other->widthPixels, other->heightPixels);
    }
    list.add("viewport-y-from-top", Stage::Pixel,
             [](Run &run) { run.viewport.y = run.given.surface.heightPixels - run.viewport.y - run.viewport.height; });
    list.add("y-not-flipped", Stage::Pixel, [](Run &run) { run.isFlipped = false; });
    list.add(
        "y-not-flipped", Stage::Window,
        [](Run &run) { run.window.y = 2.0 * run.viewport.y + run.viewport.height - run.window.y; },
        marked("about the middle of the viewport"));

    list.add("pixel-corner", Stage::Pixel, shift, marked("lower left corner"), -1.0, -1.0);
    list.add("pixel-corner", Stage::Pixel, shift, marked("upper left corner"), -1.0, 1.0);
    list.add("pixel-corner", Stage::Pixel, shift, marked("x only"), -1.0);
    list.add("pixel-corner", Stage::Pixel, shift, marked("y only, lower edge"), 0.0, -1.0);
    list.add("pixel-corner", Stage::Pixel, shift, marked("y only, upper edge"), 0.0, 1.0);
    list.add("pixel-corner", Stage::Pixel, toCorner, marked("lower left corner of the whole pixel"), 1.0);
    list.add("pixel-corner", Stage::Pixel, toCorner, marked("upper left corner of the whole pixel"), 0.0);
    list.add("half-pixel-twice", Stage::Pixel, shift, marked("to the right and down"), 1.0, -1.0);
    list.add("half-pixel-twice", Stage::Pixel, shift, marked("to the right and up"), 1.0, 1.0);
    // The first and the last pixel's centres lie on the edges: linspace(-1, 1, W).
    list.add(
        "pixel-in-size-minus-one", Stage::Window,
        [](Run &run) {
            const Viewport &v = run.viewport;
            run.window.x = v.x + (run.window.x - v.x - kHalfPixel) * v.width / (v.width - 1.0);
            run.window.y = v.y + (run.window.y - v.y - kHalfPixel) * v.height / (v.height - 1.0);
        },
        marked("from the pixel's centre"));
    list.add(
        "pixel-in-size-minus-one", Stage::Window,
        [](Run &run) {
            const Viewport &v = run.viewport;
            const double top = v.y + v.height;
            run.window.x = v.x + (run.window.x - v.x) * v.width / (v.width - 1.0);
            run.window.y = top - (top - run.window.y) * v.height / (v.height - 1.0);
        },
        marked("from the pixel's corner"));
    list.add(
        "y-is-depth", Stage::Window, [](Run &run) { run.window.y = run.click.depth; }, marked("in the window"));
    list.add(
        "y-is-depth", Stage::Window,
        [](Run &run) {
            const double z = run.given.ndcZ(run.given.unitDepth(run.click.depth));
            run.window.y = run.viewport.y + (z + 1.0) / 2.0 * run.viewport.height;
        },
        marked("in NDC"));
    list.add("row-above", Stage::Pixel, shift, {}, 0.0, 2.0);
    list.add("row-below", Stage::Pixel, shift, {}, 0.0, -2.0);
    list.add("xy-swapped", Stage::Window, [](Run &run) { run.window = {run.window.y, run.window.x}; });
    list.add(
        "xy-swapped", Stage::Pixel,
        [](Run &run) {
            run.position = {run.position.y, run.position.x};
        },
        marked("before the flip"));
}

} // namespace unprojector::doctor
