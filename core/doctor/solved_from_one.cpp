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

void addFar(VariantList &list, const Given &given, std::span<const Target> points)
{
    const auto solved = solvedFar(given, points, given.nearDistance);
    if (!solved)
        return;
    const std::array known{given.nearDistance, given.farDistance};
    if (isUnlikely(*solved, known, hideAll(given, points, given.nearDistance, solved->value)))
        return;
    addSolvedNumber(list, "far-differs", given, points, *solved, known,
                    [&](double value) { return withOtherFar(given, value); });
}

void addNear(VariantList &list, const Given &given, std::span<const Target> points)
{
    const auto solved = solvedNear(given, points, given.farDistance);
    if (!solved)
        return;
    const std::array known{given.nearDistance, given.farDistance};
    if (isUnlikely(*solved, known, hideAll(given, points, solved->value, given.farDistance)))
        return;
    addSolvedNumber(list, "near-differs", given, points, *solved, known,
                    [&](double value) { return withOtherNear(given, value); });
    if (given.isFrustum)
        addSolvedNumber(list, "near-differs", given, points, *solved, known,
                        [&](double value) { return withOtherNearOfFrustum(given, value); });
}

/// Another vertical angle: both axes are widened by the same factor.
void addFovy(VariantList &list, const Given &given, std::span<const Target> points)
{
    const double tangent = std::abs(1.0 / given.clipFromEye[1][1]);
    const auto tangentsOf = [&](const glm::dvec3 &eye) { return glm::dvec2(eye) / (given.side * eye.z); };
    const auto solved =
        solvedFrom(given, points, [&](const Click &click, const glm::dvec3 &got) -> std::optional<double> {
            const glm::dvec2 right = tangentsOf(click.eye), wrong = tangentsOf(eyeFromGot(given, click, got));
            if (glm::length(right) < 1e-9)
                return std::nullopt;
            return degreesFromRadians(2.0 * std::atan(tangent * glm::dot(right, wrong) / glm::dot(right, right)));
        });
    if (!solved || !(solved->value > 0.0))
        return;
    const double fovy = degreesFromRadians(2.0 * std::atan(tangent));
    const double fovx = degreesFromRadians(2.0 * std::atan(std::abs(1.0 / given.clipFromEye[0][0])));
    const std::array known{fovx, fovy / 2.0, fovx / 2.0};
    addSolvedNumber(list, "fovy-differs", given, points, *solved, known, [&](double value) {
        return Variant{.stage = Stage::Lens,
                       .apply =
                           [](Run &run, const Variant &v) {
                               setTangent(run, std::copysign(std::tan(radiansFromDegrees(v.parameter) / 2.0),
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
void addBoxSize(VariantList &list, const Given &given, std::span<const Target> points)
{
    const glm::dmat4 &m = given.clipFromEye;
    const glm::dvec2 middle(-m[3][0] / m[0][0], -m[3][1] / m[1][1]);
    const double height = 2.0 / std::abs(m[1][1]), width = 2.0 / std::abs(m[0][0]);
    const auto solved =
        solvedFrom(given, points, [&](const Click &click, const glm::dvec3 &got) -> std::optional<double> {
            const glm::dvec2 right = glm::dvec2(click.eye) - middle;
            const glm::dvec2 wrong = glm::dvec2(eyeFromGot(given, click, got)) - middle;
            if (glm::length(right) < 1e-9 * height)
                return std::nullopt;
            return height * glm::dot(right, wrong) / glm::dot(right, right);
        });
    if (!solved || !(solved->value > 0.0))
        return;
    const std::array known{height / 2.0, 2.0 * height, width};
    addSolvedNumber(list, "box-size-differs", given, points, *solved, known, [&](double value) {
        return Variant{.stage = Stage::Lens,
                       .apply =
                           [](Run &run, const Variant &v) {
                               widen(run, v.parameter);
                               run.clipFromEye[3][0] /= v.parameter;
                               run.clipFromEye[3][1] /= v.parameter;
                           },
                       .parameter = value / height,
                       .name = {marked("the box is %1 high, the scene's %2"),
                                {valueText(value), valueText(height)},
                                marked("Your program's box is %1 high, the scene's %2.")},
                       .values = {{"height", {value}}}};
    });
}

/// A position in the window that is off by the same number of pixels at every click.
void addShift(VariantList &list, const Given &given, std::span<const Target> points)
{
    std::optional<std::array<Solution, 2>> shift = solvedShift(given, points);
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
    bool isFlip = false;   ///< its height flips y
    bool isAspect = false; ///< its aspect is the projection's
};

/// The number of uses that are tried.
constexpr int kUsesOfSize = 4;

void useSize(Run &run, const Variant &v, const UseOfSize &use)
{
    run.viewport.width = v.parameter;
    run.viewport.height = v.second;
    if (use.isFlip && run.isFlipped)
        run.window.y += v.second - run.flipHeight;
    if (use.isAspect)
        setAspect(run, v.parameter / v.second);
}

std::string sizeText(double width, double height)
{
    return valueText(width) + " x " + valueText(height);
}

/// A viewport of another size, its origin the scene's.
void addViewportSize(VariantList &list, const Given &given, std::span<const Target> points,
                     std::span<const double> known, const UseOfSize &use, VariantList::Apply apply, const char *words,
                     const char *sentence)
{
    const Viewport &v = given.viewport;
    const auto ndcOf = [&](const Click &click, const glm::dvec3 &got) -> std::optional<glm::dvec2> {
        const auto there = projected(given, click, got);
        if (!there)
            return std::nullopt;
        const glm::dvec2 window(there->x, flippedY(given.surface, there->y));
        return glm::dvec2(2.0 * (window.x - v.x) / v.width - 1.0, 2.0 * (window.y - v.y) / v.height - 1.0);
    };
    const auto heightOf = [&](const Click &click, const glm::dvec3 &got) -> std::optional<double> {
        const auto ndc = ndcOf(click, got);
        if (!ndc)
            return std::nullopt;
        return use.isFlip ? 2.0 * (click.pixel.y + v.y) / (1.0 - ndc->y)
                          : 2.0 * (flippedY(given.surface, click.pixel.y) - v.y) / (ndc->y + 1.0);
    };
    const double aspect = given.clipFromEye[1][1] / given.clipFromEye[0][0];
    const auto widthOf = [&](const Click &click, const glm::dvec3 &got) -> std::optional<double> {
        const auto ndc = ndcOf(click, got);
        const std::optional<double> height = use.isAspect ? heightOf(click, got) : 0.0;
        if (!ndc || !height)
            return std::nullopt;
        const double fromLeft = 2.0 * (click.pixel.x - v.x);
        return use.isAspect ? fromLeft - ndc->x * aspect * *height : fromLeft / (ndc->x + 1.0);
    };
    const auto width = solvedFrom(given, points, widthOf), height = solvedFrom(given, points, heightOf);
    if (!width || !height || !(width->value > 0.0) || !(height->value > 0.0))
        return;
    const std::array size{Solution{width->value, width->unsure, v.width},
                          Solution{height->value, height->unsure, v.height}};
    addSolved(
        list, "viewport-size-differs", size, known,
        [&](std::span<const double> values) {
            return Variant{.stage = Stage::Lens,
                           .apply = apply,
                           .parameter = values[0],
                           .second = values[1],
                           .name = {words, {sizeText(values[0], values[1]), sizeText(v.width, v.height)}, sentence},
                           .values = {{"width", {values[0]}}, {"height", {values[1]}}}};
        },
        kUsesOfSize);
}

void addViewportSizes(VariantList &list, const Given &given, const Case &scene, std::span<const Target> points)
{
    const std::vector<double> known = usualSizes(given, scene);
    addViewportSize(
        list, given, points, known, {}, [](Run &run, const Variant &v) { useSize(run, v, {}); }, marked("%1 pixels"),
        marked("Your program's viewport has %1 pixels; the scene's has %2."));
    addViewportSize(
        list, given, points, known, {true, false},
        [](Run &run, const Variant &v) {
            useSize(run, v, {true, false});
        },
        marked("%1 pixels, y flipped with this height"),
        marked("Your program's viewport has %1 pixels, and its height flips y; the scene's has %2."));
    // The entries of a projection's centre belong to its own aspect.
    if (given.clipFromEye[2][0] != 0.0 || given.clipFromEye[3][0] != 0.0)
        return;
    addViewportSize(
        list, given, points, known, {false, true},
        [](Run &run, const Variant &v) {
            useSize(run, v, {false, true});
        },
        marked("%1 pixels, with their aspect"),
        marked("Your program's viewport has %1 pixels and their aspect; the scene's has %2."));
    addViewportSize(
        list, given, points, known, {true, true},
        [](Run &run, const Variant &v) {
            useSize(run, v, {true, true});
        },
        marked("%1 pixels, with their aspect, y flipped with this height"),
        marked("Your program's viewport has %1 pixels and their aspect, and its height flips y; the scene's has %2."));
}

/// A pixel ratio: the position is scaled from the window's top-left or bottom-left corner.
void addRatio(VariantList &list, const Given &given, const Case &scene, std::span<const Target> points, bool isFromTop)
{
    const auto fromCorner = [&](double x, double y) {
        return glm::dvec2(x, isFromTop ? y : flippedY(given.surface, y));
    };
    const auto solved =
        solvedFrom(given, points, [&](const Click &click, const glm::dvec3 &got) -> std::optional<double> {
            const auto there = projected(given, click, got);
            const glm::dvec2 right = fromCorner(click.pixel.x, click.pixel.y);
            if (!there || !(glm::length(right) > 0.0))
                return std::nullopt;
            const double scale = glm::dot(fromCorner(there->x, there->y), right) / glm::dot(right, right);
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
    addSolvedNumber(list, "ratio-differs", given, points, ratio, known, [&](double value) {
        Variant variant;
        variant.stage = Stage::Pixel;
        if (isFromTop)
            variant.apply = [](Run &run, const Variant &v) { run.position *= v.parameter; };
        else
            variant.apply = [](Run &run, const Variant &v) {
                run.position *= v.parameter;
                run.flipHeight *= v.parameter;
            };
        variant.parameter = isLogical ? 1.0 / value : value;
        const char *words = isFromTop   ? isLogical ? marked("ratio %1, logical pixels in a device viewport")
                                                    : marked("ratio %1, device pixels in a logical viewport, flipped "
                                                               "in logical pixels")
                              : isLogical ? marked("ratio %1, pixel and flip in logical pixels")
                                        : marked("ratio %1, device pixels in a logical viewport");
        const char *sentence =
            isFromTop   ? isLogical ? marked("Your program has logical pixels in a device viewport; the ratio is %1.")
                                    : marked("Your program has device pixels in a logical viewport, and flips y in "
                                               "logical pixels; the ratio is %1.")
              : isLogical ? marked("Your program has the pixel and the flip in logical pixels; the ratio is %1.")
                        : marked("Your program has device pixels in a logical viewport; the ratio is %1.");
        variant.name = {words, {valueText(value)}, sentence};
        const char *fixedForm = !isLogical  ? "ratio-device-in-logical"
                                : isFromTop ? "ratio-logical-in-device"
                                            : "ratio-logical-both";
        variant.values = {{"ratio", {value}}, {"as", {}, fixedForm}};
        return variant;
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
void addScale(VariantList &list, const Given &given, std::span<const Target> points, bool isAboutEye)
{
    const auto solved =
        solvedFrom(given, points, [&](const Click &click, const glm::dvec3 &got) -> std::optional<double> {
            const auto right = answer(given, click, {});
            const glm::dvec3 centre = isAboutEye ? eyeIn(given, click) : glm::dvec3(0.0);
            if (!right || !(glm::length(*right - centre) > 0.0))
                return std::nullopt;
            return glm::dot(got - centre, *right - centre) / glm::dot(*right - centre, *right - centre);
        });
    // A factor of 0 gives one point for all clicks, which knownPoints() names.
    if (!solved || std::abs(solved->value) <= solved->unsure)
        return;
    static const std::vector<double> known = unitFactors();
    addSolvedNumber(list, "scaled", given, points, *solved, known, [&](double value) {
        Variant variant;
        variant.stage = Stage::Point;
        if (isAboutEye)
            variant.apply = [](Run &run, const Variant &v) {
                const glm::dvec3 eye = eyeIn(run.given, run.click);
                run.point = eye + v.parameter * (run.point - eye);
            };
        else
            variant.apply = [](Run &run, const Variant &v) { run.point *= v.parameter; };
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
    const std::vector<Lack> lacks = lackOf(given, points);
    const bool isOneDepth = points.size() == 1 || std::count(lacks.begin(), lacks.end(), Lack::OtherDepth) > 0;
    if (!isAboutEye || !given.isPerspective || !std::isfinite(given.nearDistance) || !(solved->value > 0.0))
        return;
    const bool hidesAll = hideAll(given, points, solved->value * given.nearDistance, solved->value * given.farDistance);
    if (isUnlikely(*solved, known, isOneDepth || hidesAll))
        return;
    addSolvedNumber(list, "near-far-differ", given, points, *solved, known, [&](double value) {
        Variant variant =
            withOtherPlanes(withoutNoise(value * given.nearDistance), withoutNoise(value * given.farDistance));
        variant.coincidence = 2.0; // it takes two planes
        return variant;
    });
}

/// A depth that is read in another scale.
void addDepthScale(VariantList &list, const Given &given, std::span<const Target> points)
{
    const auto solved =
        solvedFrom(given, points, [&](const Click &click, const glm::dvec3 &got) -> std::optional<double> {
            const auto there = projected(given, click, got);
            return there && click.depth != 0.0 ? std::optional(there->z / click.depth) : std::nullopt;
        });
    if (!solved || !(solved->value > 0.0))
        return;
    constexpr std::array kUsual{1.0 / 255.0, 1.0 / 65535.0, 65535.0 / 65536.0, 0.5, 2.0};
    addSolvedNumber(list, "depth-scaled", given, points, *solved, kUsual, [](double value) {
        return Variant{
            .stage = Stage::Depth,
            .apply = [](Run &run, const Variant &v) { run.depth = run.given.unitDepth(v.parameter * run.click.depth); },
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

std::optional<Solution> solvedFar(const Given &given, std::span<const Target> points, double nearDistance)
{
    const double n = nearDistance;
    const auto solved =
        solvedFrom(given, points, [&](const Click &click, const glm::dvec3 &got) -> std::optional<double> {
            const double share = shareFromNear(given, click), z = given.side * eyeFromGot(given, click, got).z;
            if (share == 0.0)
                return std::nullopt;
            return given.isPerspective ? share / (1.0 / z - (1.0 - share) / n) : n + (z - n) / share;
        });
    return solved && solved->value > n ? solved : std::nullopt;
}

std::optional<Solution> solvedNear(const Given &given, std::span<const Target> points, double farDistance)
{
    const double f = farDistance;
    const auto solved =
        solvedFrom(given, points, [&](const Click &click, const glm::dvec3 &got) -> std::optional<double> {
            const double share = shareFromNear(given, click), z = given.side * eyeFromGot(given, click, got).z;
            if (share == 1.0)
                return std::nullopt;
            return given.isPerspective ? (1.0 - share) / (1.0 / z - share / f) : (z - share * f) / (1.0 - share);
        });
    const bool isPossible = solved && solved->value < f && (!given.isPerspective || isAhead(solved->value));
    return isPossible ? solved : std::nullopt;
}

void addSolvedFromOne(VariantList &list, const Given &given, const Case &scene, std::span<const Target> points)
{
    if (areDepthsKnown(points)) {
        if (std::isfinite(given.nearDistance)) {
            addFar(list, given, points);
            addNear(list, given, points);
        }
        addDepthScale(list, given, points);
        if (points.front().clicks.front().space != PointSpace::Eye)
            addScale(list, given, points, false);
        addScale(list, given, points, true);
    }
    if (given.isPerspective)
        addFovy(list, given, points);
    else
        addBoxSize(list, given, points);
    addShift(list, given, points);
    addViewportSizes(list, given, scene, points);
    addRatio(list, given, scene, points, true);
    addRatio(list, given, scene, points, false);
    addLetterboxes(list, given, scene, points);
}

} // namespace unprojector::doctor
