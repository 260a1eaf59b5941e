#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/doctor/lens_changes.h"
#include "core/doctor/solved_mistakes.h"
#include "core/geometry/numbers.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace unprojector::doctor {
using namespace geometry;
using base::marked;
namespace {

bool isAhead(double distance)
{
    return std::isfinite(distance) && distance > 0.0;
}

/// True if a plane hides all points and is not round.
bool isUnlikely(const Solution &plane, std::span<const double> known, bool hidesAll)
{
    return hidesAll && written(plane, known).coincidence > kRoundByChance;
}

void addFar(VariantList &list, const Given &given)
{
    const auto solved = solvedFar(given, given.nearDistance);
    if (!solved)
        return;
    const std::array known{given.nearDistance, given.farDistance};
    if (isUnlikely(*solved, known, hideAll(given, given.nearDistance, solved->value)))
        return;
    addSolvedNumber(list, "far-differs", given, *solved, known,
                    [&](double value) { return withOtherFar(given, value); });
}

void addNear(VariantList &list, const Given &given)
{
    const auto solved = solvedNear(given, given.farDistance);
    if (!solved)
        return;
    const std::array known{given.nearDistance, given.farDistance};
    if (isUnlikely(*solved, known, hideAll(given, solved->value, given.farDistance)))
        return;
    addSolvedNumber(list, "near-differs", given, *solved, known,
                    [&](double value) { return withOtherNear(given, value); });
    if (given.isFrustum)
        addSolvedNumber(list, "near-differs", given, *solved, known,
                        [&](double value) { return withOtherNearOfFrustum(given, value); });
}

/// Another vertical angle: both axes are widened by the same factor.
void addFovy(VariantList &list, const Given &given)
{
    const double tangent = std::abs(1.0 / given.clipFromEye[1][1]);
    const auto tangentsOf = [&](const glm::dvec3 &eye) { return glm::dvec2(eye) / (given.side * eye.z); };
    const auto solved = solvedFrom(given, [&](const Answered &of) -> Value {
        const glm::dvec2 right = tangentsOf(of.click.eye), wrong = tangentsOf(eyeFromGot(given, of));
        if (glm::length(right) < 1e-9)
            return std::nullopt;
        return degreesFromRadians(2.0 * std::atan(tangent * glm::dot(right, wrong) / glm::dot(right, right)));
    });
    if (!solved || !(solved->value > 0.0))
        return;
    const double fovy = degreesFromRadians(2.0 * std::atan(tangent));
    const double fovx = degreesFromRadians(2.0 * std::atan(std::abs(1.0 / given.clipFromEye[0][0])));
    const std::array known{fovx, fovy / 2.0, fovx / 2.0};
    addSolvedNumber(list, "fovy-differs", given, *solved, known, [&](double value) {
        return Variant{.stage = Stage::Lens,
                       .apply =
                           [](Run &run) {
                               setTangent(run, std::copysign(std::tan(radiansFromDegrees(run.parameter) / 2.0),
                                                             run.clipFromEye[1][1]));
                           },
                       .parameter = value,
                       .name = {marked("fovy is %1 degrees, the scene has %2"),
                                {valueText(value), base::significantText(fovy, 6)},
                                marked("Your program's field of view is %1 degrees, the scene's is %2.")},
                       .values = {{"fovy", {value}}}};
    });
}

/// Another height of an orthographic box: both axes are widened by the same factor about its middle.
void addBoxSize(VariantList &list, const Given &given)
{
    const glm::dmat4 &m = given.clipFromEye;
    const glm::dvec2 middle(-m[3][0] / m[0][0], -m[3][1] / m[1][1]);
    const double height = 2.0 / std::abs(m[1][1]), width = 2.0 / std::abs(m[0][0]);
    const auto solved = solvedFrom(given, [&](const Answered &of) -> Value {
        const glm::dvec2 right = glm::dvec2(of.click.eye) - middle;
        const glm::dvec2 wrong = glm::dvec2(eyeFromGot(given, of)) - middle;
        if (glm::length(right) < 1e-9 * height)
            return std::nullopt;
        return height * glm::dot(right, wrong) / glm::dot(right, right);
    });
    if (!solved || !(solved->value > 0.0))
        return;
    const std::array known{height / 2.0, 2.0 * height, width};
    addSolvedNumber(list, "box-size-differs", given, *solved, known, [&](double value) {
        return Variant{.stage = Stage::Lens,
                       .apply =
                           [](Run &run) {
                               widen(run, run.parameter);
                               run.clipFromEye[3][0] /= run.parameter;
                               run.clipFromEye[3][1] /= run.parameter;
                           },
                       .parameter = value / height,
                       .name = {marked("the box is %1 high, the scene's %2"),
                                {valueText(value), valueText(height)},
                                marked("Your program's box is %1 high, the scene's %2.")},
                       .values = {{"height", {value}}}};
    });
}

/// A position in the window that is off by the same number of pixels at every click.
void addShift(VariantList &list, const Given &given)
{
    std::optional<std::array<Solution, 2>> shift = solvedShift(given);
    if (!shift)
        return;
    for (Solution &along : *shift)
        along.ofScene = 0.0;
    addSolved(list, "pixel-shifted", *shift, {}, [](std::span<const double> values) {
        return shifted(values[0], values[1],
                       {marked("%1 to the right, %2 down"),
                        {valueText(values[0]), valueText(values[1])},
                        marked("Your program's pixel is %1 to the right and %2 down.")},
                       {{"dx", {values[0]}}, {"dy", {values[1]}}});
    });
}

/// The program's use of a viewport's wrong size.
struct UseOfSize {
    bool isFlip;   ///< its height flips y
    bool isAspect; ///< its aspect is the projection's
    VariantList::Apply apply;
    const char *words, *sentence; ///< of a VariantName
};

template <bool isFlip, bool isAspect>
void useSize(Run &run)
{
    run.viewport.width = run.parameter;
    run.viewport.height = run.second;
    if (isFlip && run.isFlipped)
        run.window.y += run.second - run.flipHeight;
    if (isAspect)
        setAspect(run, run.parameter / run.second);
}

constexpr UseOfSize kUsesOfSize[] = {
    {false, false, useSize<false, false>, marked("%1 pixels"),
     marked("Your program's viewport has %1 pixels; the scene's has %2.")},
    {true, false, useSize<true, false>, marked("%1 pixels, y flipped with this height"),
     marked("Your program's viewport has %1 pixels, and its height flips y; the scene's has %2.")},
    {false, true, useSize<false, true>, marked("%1 pixels, with their aspect"),
     marked("Your program's viewport has %1 pixels and their aspect; the scene's has %2.")},
    {true, true, useSize<true, true>, marked("%1 pixels, with their aspect, y flipped with this height"),
     marked("Your program's viewport has %1 pixels and their aspect, and its height flips y; the scene's has %2.")},
};

std::string sizeText(double width, double height)
{
    return valueText(width) + " x " + valueText(height);
}

/// A viewport of another size, its origin the scene's.
void addViewportSize(VariantList &list, const Given &given, std::span<const double> known, const UseOfSize &use)
{
    const Viewport &v = given.viewport;
    const auto ndcOf = [&](const Answered &of) {
        return ndcXy(v, glm::dvec2(of.there->x, flippedY(given.surface, of.there->y)));
    };
    const auto heightOf = [&](const Answered &of) -> Value {
        if (!of.there)
            return std::nullopt;
        return use.isFlip ? 2.0 * (of.click.pixel.y + v.y) / (1.0 - ndcOf(of).y)
                          : 2.0 * (flippedY(given.surface, of.click.pixel.y) - v.y) / (ndcOf(of).y + 1.0);
    };
    const double aspect = given.clipFromEye[1][1] / given.clipFromEye[0][0];
    const auto widthOf = [&](const Answered &of) -> Value {
        if (!of.there)
            return std::nullopt;
        const double fromLeft = 2.0 * (of.click.pixel.x - v.x), x = ndcOf(of).x;
        return use.isAspect ? fromLeft - x * aspect * *heightOf(of) : fromLeft / (x + 1.0);
    };
    const auto width = solvedFrom(given, widthOf), height = solvedFrom(given, heightOf);
    if (!width || !height || !(width->value > 0.0) || !(height->value > 0.0))
        return;
    const std::array size{Solution{width->value, width->unsure, v.width},
                          Solution{height->value, height->unsure, v.height}};
    addSolved(
        list, "viewport-size-differs", size, known,
        [&](std::span<const double> values) {
            return Variant{
                .stage = Stage::Lens,
                .apply = use.apply,
                .parameter = values[0],
                .second = values[1],
                .name = {use.words, {sizeText(values[0], values[1]), sizeText(v.width, v.height)}, use.sentence},
                .values = {{"width", {values[0]}}, {"height", {values[1]}}}};
        },
        int(std::size(kUsesOfSize)));
}

void addViewportSizes(VariantList &list, const Given &given, const Case &scene)
{
    const std::vector<double> known = usualSizes(given, scene);
    // The entries of a projection's centre belong to its own aspect.
    const bool hasCentre = given.clipFromEye[2][0] != 0.0 || given.clipFromEye[3][0] != 0.0;
    for (const UseOfSize &use : kUsesOfSize) {
        if (!use.isAspect || !hasCentre)
            addViewportSize(list, given, known, use);
    }
}

/// A free ratio, by the corner that it scales from and the pixels that it takes for the others.
struct FreeRatio {
    const char *words, *sentence; ///< of a VariantName
    const char *fixedForm;        ///< the mistake of a usual ratio
};
constexpr FreeRatio kFromTopDevice{
    marked("ratio %1, device pixels in a logical viewport, flipped in logical pixels"),
    marked("Your program has device pixels in a logical viewport, and flips y in logical pixels; the ratio is %1."),
    "ratio-device-in-logical"};
constexpr FreeRatio kFromTopLogical{marked("ratio %1, logical pixels in a device viewport"),
                                    marked("Your program has logical pixels in a device viewport; the ratio is %1."),
                                    "ratio-logical-in-device"};
constexpr FreeRatio kFromBottomDevice{marked("ratio %1, device pixels in a logical viewport"),
                                      marked("Your program has device pixels in a logical viewport; the ratio is %1."),
                                      "ratio-device-in-logical"};
constexpr FreeRatio kFromBottomLogical{
    marked("ratio %1, pixel and flip in logical pixels"),
    marked("Your program has the pixel and the flip in logical pixels; the ratio is %1."), "ratio-logical-both"};

/// A pixel ratio: the position is scaled from the window's top-left or bottom-left corner.
void addRatio(VariantList &list, const Given &given, const Case &scene, bool isFromTop)
{
    const auto fromCorner = [&](double x, double y) {
        return glm::dvec2(x, isFromTop ? y : flippedY(given.surface, y));
    };
    const auto solved = solvedFrom(given, [&](const Answered &of) -> Value {
        const glm::dvec2 right = fromCorner(of.click.pixel.x, of.click.pixel.y);
        if (!of.there || !(glm::length(right) > 0.0))
            return std::nullopt;
        const double scale = glm::dot(fromCorner(of.there->x, of.there->y), right) / glm::dot(right, right);
        return scale < 1.0 ? 1.0 / scale : -scale;
    });
    // A negative number is the factor of device pixels in a logical viewport.
    if (!solved || !(std::abs(solved->value) > 1.0))
        return;
    std::vector<double> known{given.surface.devicePixelRatio};
    if (scene.otherSize) {
        known.push_back(double(given.surface.widthPixels) / scene.otherSize->widthPixels);
        known.push_back(double(given.surface.heightPixels) / scene.otherSize->heightPixels);
    }
    const bool isLogical = solved->value > 0.0;
    const Solution ratio{std::abs(solved->value), solved->unsure};
    const FreeRatio &form = isFromTop   ? isLogical ? kFromTopLogical : kFromTopDevice
                            : isLogical ? kFromBottomLogical
                                        : kFromBottomDevice;
    addSolvedNumber(list, "ratio-differs", given, ratio, known, [&](double value) {
        const double factor = isLogical ? 1.0 / value : value;
        return Variant{.stage = Stage::Pixel,
                       .apply =
                           [](Run &run) {
                               run.position *= run.parameter;
                               run.flipHeight *= run.second;
                           },
                       .parameter = factor,
                       .second = isFromTop ? 1.0 : factor,
                       .name = {form.words, {valueText(value)}, form.sentence},
                       .values = {{"ratio", {value}}, {"as", {}, form.fixedForm}}};
    });
}

/// Factors between units of length, and their inverses.
std::vector<double> unitFactors()
{
    std::vector<double> factors;
    for (const double factor : {10.0, 100.0, 1000.0, 25.4, 2.54, 0.0254, 0.3048, 0.9144, 12.0, 2.0, 3.0}) {
        factors.push_back(factor);
        factors.push_back(1.0 / factor);
    }
    return factors;
}

/// The eye in the space of a click's answer.
glm::dvec3 eyeIn(const Given &given, const Click &click)
{
    if (click.space == PointSpace::Eye)
        return glm::dvec3(0.0);
    return transformed(glm::inverse(click.worldFromObject), given.eyePosition);
}

/// Another unit of length, or distances of another unit.
void addScale(VariantList &list, const Given &given, bool isAboutEye)
{
    const auto solved = solvedFrom(given, [&](const Answered &of) -> Value {
        const auto right = answer(given, of.click, {});
        const glm::dvec3 centre = isAboutEye ? eyeIn(given, of.click) : glm::dvec3(0.0);
        if (!right || !(glm::length(*right - centre) > 0.0))
            return std::nullopt;
        return glm::dot(of.got - centre, *right - centre) / glm::dot(*right - centre, *right - centre);
    });
    // A factor of 0 gives one point for all clicks, which knownPoints() names.
    if (!solved || std::abs(solved->value) <= solved->unsure)
        return;
    static const std::vector<double> known = unitFactors();
    addSolvedNumber(list, "scaled", given, *solved, known, [&](double value) {
        Variant variant;
        variant.stage = Stage::Point;
        if (isAboutEye)
            variant.apply = [](Run &run) {
                const glm::dvec3 eye = eyeIn(run.given, run.click);
                run.point = eye + run.parameter * (run.point - eye);
            };
        else
            variant.apply = [](Run &run) { run.point *= run.parameter; };
        variant.parameter = value;
        variant.name = {isAboutEye ? marked("by %1 from the eye") : marked("by %1 from the origin"),
                        {valueText(value)},
                        isAboutEye ? marked("Your program scales its points by %1 about the eye.")
                                   : marked("Your program scales its points by %1 about the origin.")};
        variant.values = {{"factor", {value}}, {"about", {}, isAboutEye ? "eye" : "origin"}};
        return variant;
    });
    // In a perspective, both planes at a multiple of their distances give the same points. At one
    // depth there is always such a multiple, so it says something only if it is round.
    const std::vector<Lack> lacks = lackOf(given);
    const bool isOneDepth = given.points.size() == 1 || std::count(lacks.begin(), lacks.end(), Lack::OtherDepth) > 0;
    if (!isAboutEye || !given.isPerspective || !std::isfinite(given.nearDistance) || !(solved->value > 0.0))
        return;
    const bool hidesAll = hideAll(given, solved->value * given.nearDistance, solved->value * given.farDistance);
    if (isUnlikely(*solved, known, isOneDepth || hidesAll))
        return;
    addSolvedNumber(list, "near-far-differ", given, *solved, known, [&](double value) {
        Variant variant =
            withOtherPlanes(withoutNoise(value * given.nearDistance), withoutNoise(value * given.farDistance));
        variant.coincidence = 2.0; // it takes two planes
        return variant;
    });
}

/// A depth that is read in another scale.
void addDepthScale(VariantList &list, const Given &given)
{
    const auto solved = solvedFrom(given, [&](const Answered &of) -> Value {
        return of.there && of.click.depth != 0.0 ? std::optional(of.there->z / of.click.depth) : std::nullopt;
    });
    if (!solved || !(solved->value > 0.0))
        return;
    constexpr std::array kUsual{1.0 / 255.0, 1.0 / 65535.0, 65535.0 / 65536.0, 0.5, 2.0};
    addSolvedNumber(list, "depth-scaled", given, *solved, kUsual, [](double value) {
        return Variant{.stage = Stage::Depth,
                       .apply = [](Run &run) { run.depth = run.given.unitDepth(run.parameter * run.click.depth); },
                       .parameter = value,
                       .name = {marked("by %1"), {valueText(value)}, marked("Your program scales the depth by %1.")},
                       .values = {{"factor", {value}}}};
    });
}

} // namespace

std::vector<double> usualSizes(const Given &given, const Case &scene)
{
    std::vector<double> sizes{640, 480, 800, 600, 1024, 768, 1280, 720, 1366, 1920, 1080, 512, 256};
    for (const double ratio : {1.0, given.surface.devicePixelRatio}) {
        for (const double size : {double(given.surface.widthPixels), double(given.surface.heightPixels),
                                  given.viewport.width, given.viewport.height})
            sizes.push_back(size / ratio);
    }
    if (scene.otherSize) {
        sizes.push_back(scene.otherSize->widthPixels);
        sizes.push_back(scene.otherSize->heightPixels);
    }
    return sizes;
}

// 1/z is linear in the depth in a perspective, z in a box.

std::optional<Solution> solvedFar(const Given &given, double nearDistance)
{
    const double n = nearDistance;
    const auto solved = solvedFrom(given, [&](const Answered &of) -> Value {
        const double share = shareFromNear(given, of.click), z = given.side * eyeFromGot(given, of).z;
        if (share == 0.0)
            return std::nullopt;
        return given.isPerspective ? share / (1.0 / z - (1.0 - share) / n) : n + (z - n) / share;
    });
    return solved && solved->value > n ? solved : std::nullopt;
}

std::optional<Solution> solvedNear(const Given &given, double farDistance)
{
    const double f = farDistance;
    const auto solved = solvedFrom(given, [&](const Answered &of) -> Value {
        const double share = shareFromNear(given, of.click), z = given.side * eyeFromGot(given, of).z;
        if (share == 1.0)
            return std::nullopt;
        return given.isPerspective ? (1.0 - share) / (1.0 / z - share / f) : (z - share * f) / (1.0 - share);
    });
    const bool isPossible = solved && solved->value < f && (!given.isPerspective || isAhead(solved->value));
    return isPossible ? solved : std::nullopt;
}

void addSolvedFromOne(VariantList &list, const Given &given, const Case &scene)
{
    if (areDepthsKnown(given)) {
        if (std::isfinite(given.nearDistance)) {
            addFar(list, given);
            addNear(list, given);
        }
        addDepthScale(list, given);
        if (given.points.front().clicks.front().space != PointSpace::Eye)
            addScale(list, given, false);
        addScale(list, given, true);
    }
    if (given.isPerspective)
        addFovy(list, given);
    else
        addBoxSize(list, given);
    addShift(list, given);
    addViewportSizes(list, given, scene);
    addRatio(list, given, scene, true);
    addRatio(list, given, scene, false);
    addLetterboxes(list, given, scene);
}

} // namespace unprojector::doctor
