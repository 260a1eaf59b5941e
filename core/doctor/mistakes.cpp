#include "core/doctor/mistakes.h"

#include "core/geometry/angle.h"
#include "core/text/number_text.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <iterator>

namespace unprojector::doctor {
namespace {

constexpr Mistake kMistakes[] = {
    {"y-not-flipped", Family::Pixel, 10},
    {"row-above", Family::Pixel, 6},
    {"pixel-corner", Family::Pixel, 6},
    {"ratio-logical-in-device", Family::Pixel, 18},
    {"ratio-logical-both", Family::Pixel, 18},
    {"ratio-device-in-logical", Family::Pixel, 18},
    {"viewport-origin-ignored", Family::Pixel, 18},
    {"flipped-with-viewport-height", Family::Pixel, 18},
    {"viewport-is-window", Family::Pixel, 18},
    {"aspect-integer", Family::Lens, 9},
    {"aspect-inverted", Family::Lens, 9},
    {"fov-degrees-as-radians", Family::Lens, 9},
    {"fov-half", Family::Lens, 9},
    {"fov-double", Family::Lens, 9},
    {"fov-horizontal", Family::Lens, 9},
    {"depth-not-remapped", Family::Depth, 11},
    {"depth-remapped-twice", Family::Depth, 11},
    {"depth-linear", Family::Depth, 7},
    {"depth-zero", Family::Depth, 11},
    {"depth-one", Family::Depth, 11},
    {"depth-is-eye-distance", Family::Depth, 7},
    {"depth-reversed", Family::Depth, 5},
    {"near-differs", Family::Depth, 13},
    {"far-differs", Family::Depth, 13},
    {"ray-length-as-z", Family::Depth, 7},
    {"z-as-ray-length", Family::Depth, 7},
    {"linear-angle", Family::Lens, 1},
    {"no-w-divide", Family::Matrix, 4},
    {"projection-transposed", Family::Matrix, 11},
    {"view-transposed", Family::Matrix, 11},
    {"both-transposed", Family::Matrix, 11},
    {"product-transposed", Family::Matrix, 11},
    {"inverse-order", Family::Matrix, 11},
    {"not-inverted", Family::Matrix, 11},
    {"view-inverse-as-view", Family::Matrix, 11},
    {"view-left-out", Family::Matrix, 11},
    {"model-left-in", Family::Point, 3},
    {"model-left-out", Family::Point, 3},
    {"eye-added", Family::Point, 3},
    {"eye-z-positive", Family::Lens, 3},
    {"eye-xy-mirrored", Family::Lens, 3},
    {"xy-swapped", Family::Pixel, 3},
    {"ortho-formula", Family::Lens, 13},
    {"divided-by-far", Family::Lens, 13},
    {"overwritten-in-place", Family::Matrix, 11},
    {"viewport-y-from-top", Family::Pixel, 1},
    {"row-below", Family::Pixel, 1},
    {"aspect-of-window", Family::Lens, 9},
    {"aspect-left-out", Family::Lens, 1},
    {"fov-radians-as-degrees", Family::Lens, 9},
    {"frustum-centred", Family::Lens, 1},
    {"perspective-formula", Family::Lens, 13},
    {"depth-of-another-row", Family::Depth, 1},
    {"depth-rounded", Family::Depth, 1},
    {"depth-range-ignored", Family::Depth, 1},
    {"w-divided-twice", Family::Matrix, 4},
    {"projection-left-out", Family::Matrix, 1},
    {"eye-subtracted", Family::Point, 1},
    {"axes-swapped", Family::Point, 3},
};

constexpr std::array kUsualRatios{2.0, 1.5, 1.25, 1.75, 3.0};
/// What near and far are off by where they are another frustum's.
constexpr std::array kClipFactors{0.1, 10.0, 0.01, 100.0};

using Apply = void (*)(Run &, const Variant &);

/// Collects the variants, each under the mistake it is one of.
class List {
public:
    void add(std::string_view id, Stage stage, Apply apply, double parameter = 0.0, std::string words = {})
    {
        const auto *place = std::find_if(std::begin(kMistakes), std::end(kMistakes),
                                         [&](const Mistake &mistake) { return mistake.id == id; });
        m_variants.push_back(
            {std::size_t(place - kMistakes), stage, apply, parameter, glm::dmat4(1.0), std::move(words)});
    }
    void add(std::string_view id, Apply apply, const PlacedModel &model)
    {
        add(id, Stage::Point, apply, 0.0, "of " + model.name);
        m_variants.back().matrix = model.worldFromObject;
    }

    std::vector<Variant> sorted() &&
    {
        std::stable_sort(m_variants.begin(), m_variants.end(),
                         [](const Variant &a, const Variant &b) { return a.mistake < b.mistake; });
        return std::move(m_variants);
    }

private:
    std::vector<Variant> m_variants;
};

// ---- pixel, flip and viewport ------------------------------------------------------------------------------------

void scaleViewport(Run &run, double factor)
{
    run.viewport.x *= factor;
    run.viewport.y *= factor;
    run.viewport.width *= factor;
    run.viewport.height *= factor;
}

void addRatio(List &list, double ratio)
{
    const std::string words = "ratio " + text::shortestText(ratio);
    list.add(
        "ratio-logical-in-device", Stage::Pixel, [](Run &run, const Variant &v) { run.position /= v.parameter; }, ratio,
        words);
    list.add(
        "ratio-logical-both", Stage::Pixel,
        [](Run &run, const Variant &v) {
            run.position /= v.parameter;
            run.flipHeight /= v.parameter;
        },
        ratio, words);
    list.add(
        "ratio-device-in-logical", Stage::Pixel,
        [](Run &run, const Variant &v) { scaleViewport(run, 1.0 / v.parameter); }, ratio, words);
    // A ratio that is applied twice gives the same.
    list.add(
        "ratio-device-in-logical", Stage::Pixel,
        [](Run &run, const Variant &v) {
            scaleViewport(run, 1.0 / v.parameter);
            run.flipHeight /= v.parameter;
        },
        ratio, words + ", flipped in logical pixels");
}

/// A place in the pixel other than the one clicked, device pixels to the right and up.
template <int RightHalves, int UpHalves>
void shift(Run &run, const Variant &)
{
    run.position += glm::dvec2(0.5 * RightHalves, -0.5 * UpHalves);
}

/// The lower left or upper left corner of the pixel that the position lies in, wherever in it.
template <int Down>
void toCorner(Run &run, const Variant &)
{
    run.position = glm::floor(run.position) + glm::dvec2(0.0, Down);
}

void addPixel(List &list, const Given &given)
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
            "its y only");
        list.add(
            "viewport-origin-ignored", Stage::Pixel, [](Run &run, const Variant &) { run.viewport.x = 0.0; }, 0.0,
            "its x only");
    }
    list.add("flipped-with-viewport-height", Stage::Pixel,
             [](Run &run, const Variant &) { run.flipHeight = run.viewport.height; });
    list.add("viewport-is-window", Stage::Pixel, [](Run &run, const Variant &) {
        run.viewport = {0.0, 0.0, double(run.given.surface.widthPixels), double(run.given.surface.heightPixels)};
    });
    list.add("viewport-y-from-top", Stage::Pixel, [](Run &run, const Variant &) {
        run.viewport.y = run.given.surface.heightPixels - run.viewport.y - run.viewport.height;
    });
    list.add("y-not-flipped", Stage::Pixel, [](Run &run, const Variant &) { run.isFlipped = false; });
    list.add(
        "y-not-flipped", Stage::Window,
        [](Run &run, const Variant &) { run.window.y = 2.0 * run.viewport.y + run.viewport.height - run.window.y; },
        0.0, "about the middle of the viewport");

    list.add("pixel-corner", Stage::Pixel, shift<-1, -1>, 0.0, "lower left corner");
    list.add("pixel-corner", Stage::Pixel, shift<-1, 1>, 0.0, "upper left corner");
    list.add("pixel-corner", Stage::Pixel, shift<-1, 0>, 0.0, "x only");
    list.add("pixel-corner", Stage::Pixel, shift<0, -1>, 0.0, "y only, lower edge");
    list.add("pixel-corner", Stage::Pixel, shift<0, 1>, 0.0, "y only, upper edge");
    list.add("pixel-corner", Stage::Pixel, toCorner<1>, 0.0, "lower left corner of the whole pixel");
    list.add("pixel-corner", Stage::Pixel, toCorner<0>, 0.0, "upper left corner of the whole pixel");
    list.add("row-above", Stage::Pixel, shift<0, 2>);
    list.add("row-below", Stage::Pixel, shift<0, -2>);
    list.add("xy-swapped", Stage::Window, [](Run &run, const Variant &) { run.window = {run.window.y, run.window.x}; });
    list.add(
        "xy-swapped", Stage::Pixel,
        [](Run &run, const Variant &) {
            run.position = {run.position.y, run.position.x};
        },
        0.0, "before the flip");
}

// ---- depth -------------------------------------------------------------------------------------------------------

/// The unit depth of what is read as a depth in the depth range.
double unitDepth(const Run &run, double depth)
{
    const auto &[atNear, atFar] = run.given.depthRange;
    return (depth - atNear) / (atFar - atNear);
}

/// The distance of the right point.
double rightDistance(const Run &run)
{
    return run.given.side * run.click.eye.z;
}

void addMeaningOfDepth(List &list)
{
    list.add(
        "depth-linear", Stage::Depth,
        [](Run &run, const Variant &) {
            const double n = run.given.nearDistance, f = run.given.farDistance;
            run.depth = (rightDistance(run) - n) / (f - n);
        },
        0.0, "a share of the way is passed for the depth");
    list.add(
        "depth-linear", Stage::Eye,
        [](Run &run, const Variant &) {
            const double n = run.nearDistance, f = run.farDistance;
            run.setDistance(n + run.shareFromNear(run.depth) * (f - n));
        },
        0.0, "the depth is taken for a share of the way");
    list.add(
        "depth-linear", Stage::Eye, [](Run &run, const Variant &) { run.setDistance(run.depth * run.farDistance); },
        0.0, "the depth is taken for a share of far");
    list.add(
        "depth-is-eye-distance", Stage::Depth,
        [](Run &run, const Variant &) { run.depth = unitDepth(run, rightDistance(run)); }, 0.0,
        "the distance is passed for the depth");
    list.add(
        "depth-is-eye-distance", Stage::Depth,
        [](Run &run, const Variant &) { run.depth = unitDepth(run, glm::length(run.click.eye)); }, 0.0,
        "the length of the ray is passed for the depth");
    list.add(
        "depth-is-eye-distance", Stage::Eye, [](Run &run, const Variant &) { run.setDistance(run.click.depth); }, 0.0,
        "the depth is taken for the distance");
    list.add("ray-length-as-z", Stage::Eye, [](Run &run, const Variant &) { run.setDistance(glm::length(run.eye)); });
    list.add("z-as-ray-length", Stage::Eye, [](Run &run, const Variant &) {
        const double distance = run.distance();
        run.setDistance(distance * distance / glm::length(run.eye));
    });
}

/// The depth entries of the projection matrix for other clip distances: both planes keep their NDC depths.
void setClipDistances(Run &run, double nearDistance, double farDistance)
{
    glm::dmat4 &m = run.clipFromEye;
    const double z0 = run.given.side * nearDistance, z1 = run.given.side * farDistance;
    const double old0 = run.given.side * run.nearDistance, old1 = run.given.side * run.farDistance;
    run.nearDistance = nearDistance;
    run.farDistance = farDistance;
    if (!(nearDistance < farDistance)) {
        run.isLost = true;
        return;
    }
    if (run.given.isPerspective) {
        const double w = m[2][3];
        const double atNear = m[2][2] + m[3][2] / old0, atFar = m[2][2] + m[3][2] / old1; // w z_n
        m[3][2] = (atNear - atFar) / (1.0 / z0 - 1.0 / z1);
        m[2][2] = atNear - m[3][2] / z0;
        run.isLost = run.isLost || w == 0.0;
    } else {
        const double atNear = m[2][2] * old0 + m[3][2], atFar = m[2][2] * old1 + m[3][2];
        m[2][2] = (atNear - atFar) / (z0 - z1);
        m[3][2] = atNear - m[2][2] * z0;
    }
}

void addClipDistances(List &list, const Given &given)
{
    for (const double factor : kClipFactors) {
        const std::string times = " times " + text::shortestText(factor);
        list.add(
            "near-differs", Stage::Lens,
            [](Run &run, const Variant &v) { setClipDistances(run, run.nearDistance * v.parameter, run.farDistance); },
            factor, "near" + times);
        list.add(
            "far-differs", Stage::Lens,
            [](Run &run, const Variant &v) { setClipDistances(run, run.nearDistance, run.farDistance * v.parameter); },
            factor, "far" + times);
        if (given.isFrustum)
            list.add(
                "near-differs", Stage::Lens,
                [](Run &run, const Variant &v) {
                    run.clipFromEye[0][0] *= v.parameter;
                    run.clipFromEye[1][1] *= v.parameter;
                    setClipDistances(run, run.nearDistance * v.parameter, run.farDistance);
                },
                factor, "near" + times + ", the window of glFrustum as it was");
    }
}

void addDepth(List &list, const Given &given)
{
    list.add("depth-not-remapped", Stage::Depth,
             [](Run &run, const Variant &) { run.depth = (1.0 + run.depth) / 2.0; });
    list.add("depth-remapped-twice", Stage::Depth,
             [](Run &run, const Variant &) { run.depth = 2.0 * run.depth - 1.0; });
    list.add("depth-zero", Stage::Depth, [](Run &run, const Variant &) { run.depth = unitDepth(run, 0.0); });
    list.add("depth-one", Stage::Depth, [](Run &run, const Variant &) { run.depth = unitDepth(run, 1.0); });
    list.add("depth-reversed", Stage::Depth, [](Run &run, const Variant &) { run.depth = 1.0 - run.depth; });
    if (given.depthRange != DepthRange{}) {
        list.add(
            "depth-not-remapped", Stage::Depth,
            [](Run &run, const Variant &) { run.depth = (1.0 + run.click.depth) / 2.0; }, 0.0,
            "nor mapped by the depth range");
        list.add("depth-range-ignored", Stage::Depth, [](Run &run, const Variant &) { run.depth = run.click.depth; });
        list.add(
            "depth-zero", Stage::Depth, [](Run &run, const Variant &) { run.depth = 0.0; }, 0.0, "in the depth range");
        list.add(
            "depth-one", Stage::Depth, [](Run &run, const Variant &) { run.depth = 1.0; }, 0.0, "in the depth range");
        list.add(
            "depth-reversed", Stage::Depth,
            [](Run &run, const Variant &) { run.depth = unitDepth(run, 1.0 - run.click.depth); }, 0.0,
            "before the depth range");
    }
    for (const int bits : {16, 24, 8}) {
        list.add(
            "depth-rounded", Stage::Depth,
            [](Run &run, const Variant &v) { run.depth = std::round(run.depth * v.parameter) / v.parameter; },
            double((std::int64_t{1} << bits) - 1), "to " + std::to_string(bits) + " bits");
    }
    list.add(
        "depth-of-another-row", Stage::Depth,
        [](Run &run, const Variant &) {
            run.isLost = !run.click.depthAbove;
            run.depth = unitDepth(run, run.click.depthAbove.value_or(0.0));
        },
        0.0, "the row above");
    list.add(
        "depth-of-another-row", Stage::Depth,
        [](Run &run, const Variant &) {
            run.isLost = !run.click.depthBelow;
            run.depth = unitDepth(run, run.click.depthBelow.value_or(0.0));
        },
        0.0, "the row below");
    addMeaningOfDepth(list);
    addClipDistances(list, given);
}

// ---- lens --------------------------------------------------------------------------------------------------------

/// Of the half angle that spans the height, as a symmetric frustum has it.
double tangentOf(const Run &run)
{
    return 1.0 / run.clipFromEye[1][1];
}

double verticalFov(const Run &run)
{
    return 2.0 * std::atan(tangentOf(run));
}

double aspectOf(const Run &run)
{
    return run.clipFromEye[1][1] / run.clipFromEye[0][0];
}

/// Both axes wider by a factor.
void widen(Run &run, double factor)
{
    run.clipFromEye[0][0] /= factor;
    run.clipFromEye[1][1] /= factor;
}

void setTangent(Run &run, double tangent)
{
    widen(run, tangent / tangentOf(run));
}

void setAspect(Run &run, double aspect)
{
    run.isLost = run.isLost || aspect == 0.0;
    run.clipFromEye[0][0] = run.clipFromEye[1][1] / aspect;
}

void addPerspective(List &list)
{
    list.add("fov-degrees-as-radians", Stage::Lens,
             [](Run &run, const Variant &) { setTangent(run, std::tan(degreesFromRadians(verticalFov(run)) / 2.0)); });
    list.add("fov-radians-as-degrees", Stage::Lens,
             [](Run &run, const Variant &) { setTangent(run, std::tan(radiansFromDegrees(verticalFov(run)) / 2.0)); });
    list.add("fov-half", Stage::Lens,
             [](Run &run, const Variant &) { setTangent(run, std::tan(verticalFov(run) / 4.0)); });
    list.add("fov-double", Stage::Lens, [](Run &run, const Variant &) { setTangent(run, std::tan(verticalFov(run))); });
    list.add(
        "fov-horizontal", Stage::Lens, [](Run &run, const Variant &) { widen(run, 1.0 / aspectOf(run)); }, 0.0,
        "the vertical angle spans the width");
    list.add(
        "fov-horizontal", Stage::Lens, [](Run &run, const Variant &) { widen(run, aspectOf(run)); }, 0.0,
        "the horizontal angle spans the height");
    list.add("frustum-centred", Stage::Lens,
             [](Run &run, const Variant &) { run.clipFromEye[2][0] = run.clipFromEye[2][1] = 0.0; });
    list.add("ortho-formula", Stage::Eye, [](Run &run, const Variant &) {
        const double factor = run.nearDistance / run.distance();
        run.eye.x *= factor;
        run.eye.y *= factor;
    });
    list.add(
        "ortho-formula", Stage::Eye,
        [](Run &run, const Variant &) {
            const double factor = run.nearDistance / run.distance();
            const double n = run.nearDistance, f = run.farDistance;
            run.eye = {run.eye.x * factor, run.eye.y * factor,
                       run.given.side * (n + run.shareFromNear(run.depth) * (f - n))};
        },
        0.0, "the depth too");
    list.add("divided-by-far", Stage::Eye, [](Run &run, const Variant &) {
        const double factor = run.nearDistance / run.farDistance;
        run.eye.x *= factor;
        run.eye.y *= factor;
    });
    // Each axis between the angles of the frustum's edges.
    list.add("linear-angle", Stage::Eye, [](Run &run, const Variant &) {
        const glm::dmat4 &m = run.clipFromEye;
        const double z = run.distance();
        for (int axis = 0; axis < 2; ++axis) {
            const double centre = -run.given.side * m[2][axis], scale = m[axis][axis] / std::abs(m[2][3]);
            const double low = std::atan((centre - 1.0) / scale), high = std::atan((centre + 1.0) / scale);
            run.eye[axis] = z * std::tan(low + (run.ndc[axis] + 1.0) / 2.0 * (high - low));
        }
    });
    list.add(
        "linear-angle", Stage::Eye,
        [](Run &run, const Variant &) {
            const double z = run.distance(), half = verticalFov(run) / 2.0;
            run.eye.x = z * std::tan(run.ndc.x * half * aspectOf(run));
            run.eye.y = z * std::tan(run.ndc.y * half);
        },
        0.0, "the horizontal angle is the vertical one times the aspect");
}

void addBox(List &list)
{
    list.add("perspective-formula", Stage::Eye, [](Run &run, const Variant &) {
        const double factor = run.distance() / run.nearDistance;
        run.eye.x *= factor;
        run.eye.y *= factor;
    });
    list.add(
        "perspective-formula", Stage::Eye,
        [](Run &run, const Variant &) {
            const double n = run.nearDistance, f = run.farDistance;
            const double d = run.shareFromNear(run.depth), z = n * f / (f * (1.0 - d) + n * d);
            run.eye = {run.eye.x * z / n, run.eye.y * z / n, run.given.side * z};
        },
        0.0, "the depth too");
    list.add(
        "perspective-formula", Stage::Eye,
        [](Run &run, const Variant &) {
            const double n = run.nearDistance, f = run.farDistance;
            const double d = run.shareFromNear(run.depth);
            run.setDistance(n * f / (f * (1.0 - d) + n * d));
        },
        0.0, "the depth only");
}

void addLens(List &list, const Given &given)
{
    if (given.isPerspective)
        addPerspective(list);
    else
        addBox(list);
    list.add("aspect-integer", Stage::Lens,
             [](Run &run, const Variant &) { setAspect(run, std::floor(run.viewport.width / run.viewport.height)); });
    list.add(
        "aspect-integer", Stage::Lens, [](Run &run, const Variant &) { setAspect(run, std::floor(aspectOf(run))); },
        0.0, "of the projection");
    list.add("aspect-inverted", Stage::Lens, [](Run &run, const Variant &) { setAspect(run, 1.0 / aspectOf(run)); });
    list.add("aspect-of-window", Stage::Lens, [](Run &run, const Variant &) {
        setAspect(run, double(run.given.surface.widthPixels) / run.given.surface.heightPixels);
    });
    list.add("aspect-left-out", Stage::Lens, [](Run &run, const Variant &) { setAspect(run, 1.0); });
    list.add("eye-z-positive", Stage::Eye, [](Run &run, const Variant &) { run.eye.z = -run.eye.z; });
    list.add("eye-xy-mirrored", Stage::Eye, [](Run &run, const Variant &) {
        run.eye.x = -run.eye.x;
        run.eye.y = -run.eye.y;
    });
    list.add(
        "eye-xy-mirrored", Stage::Window,
        [](Run &run, const Variant &) {
            const Viewport &v = run.viewport;
            run.window = glm::dvec2(2.0 * v.x + v.width, 2.0 * v.y + v.height) - run.window;
        },
        0.0, "about the middle of the viewport");
}

// ---- matrices ----------------------------------------------------------------------------------------------------

void addMatrices(List &list)
{
    list.add("projection-transposed", Stage::Factors,
             [](Run &run, const Variant &) { run.clipFromEye = glm::transpose(run.clipFromEye); });
    list.add("view-transposed", Stage::Factors,
             [](Run &run, const Variant &) { run.eyeFromWorld = glm::transpose(run.eyeFromWorld); });
    list.add("both-transposed", Stage::Factors, [](Run &run, const Variant &) {
        run.clipFromEye = glm::transpose(run.clipFromEye);
        run.eyeFromWorld = glm::transpose(run.eyeFromWorld);
    });
    list.add("view-inverse-as-view", Stage::Factors,
             [](Run &run, const Variant &) { run.eyeFromWorld = glm::inverse(run.eyeFromWorld); });
    list.add("view-left-out", Stage::Factors, [](Run &run, const Variant &) { run.eyeFromWorld = glm::dmat4(1.0); });
    list.add("projection-left-out", Stage::Factors,
             [](Run &run, const Variant &) { run.clipFromEye = glm::dmat4(1.0); });
    list.add("product-transposed", Stage::Product,
             [](Run &run, const Variant &) { run.order = Run::Order::InverseOfTransposed; });
    list.add("inverse-order", Stage::Product,
             [](Run &run, const Variant &) { run.order = Run::Order::InversesInTheOrderOfTheFactors; });
    list.add("not-inverted", Stage::Product, [](Run &run, const Variant &) { run.order = Run::Order::NotInverted; });
    list.add("overwritten-in-place", Stage::Divide, [](Run &run, const Variant &) { run.isInPlace = true; });
    list.add("no-w-divide", Stage::Divide, [](Run &run, const Variant &) { run.divisions = 0; });
    list.add("w-divided-twice", Stage::Divide, [](Run &run, const Variant &) { run.divisions = 2; });
}

glm::dvec3 transformed(const glm::dmat4 &m, const glm::dvec3 &point)
{
    const glm::dvec4 result = m * glm::dvec4(point, 1.0);
    return glm::dvec3(result) / result.w;
}

void addPoint(List &list, std::span<const PlacedModel> models)
{
    for (const PlacedModel &model : models) {
        list.add(
            "model-left-in",
            [](Run &run, const Variant &v) { run.point = transformed(glm::inverse(v.matrix), run.point); }, model);
        list.add(
            "model-left-out", [](Run &run, const Variant &v) { run.point = transformed(v.matrix, run.point); }, model);
    }
    list.add("eye-added", Stage::Point, [](Run &run, const Variant &) { run.point += run.given.eyePosition; });
    list.add("eye-subtracted", Stage::Point, [](Run &run, const Variant &) { run.point -= run.given.eyePosition; });
    list.add(
        "axes-swapped", Stage::Point,
        [](Run &run, const Variant &) {
            run.point = {run.point.x, -run.point.z, run.point.y};
        },
        0.0, "z up given for y up");
    list.add(
        "axes-swapped", Stage::Point,
        [](Run &run, const Variant &) {
            run.point = {run.point.x, run.point.z, -run.point.y};
        },
        0.0, "y up given for z up");
    list.add(
        "axes-swapped", Stage::Point,
        [](Run &run, const Variant &) {
            run.point = {run.point.x, run.point.z, run.point.y};
        },
        0.0, "y and z exchanged");
}

} // namespace

std::span<const Mistake> mistakes()
{
    return kMistakes;
}

std::vector<Variant> variants(const Given &given, std::span<const PlacedModel> models)
{
    List list;
    addPixel(list, given);
    addDepth(list, given);
    addLens(list, given);
    addMatrices(list);
    addPoint(list, models);
    return std::move(list).sorted();
}

} // namespace unprojector::doctor
