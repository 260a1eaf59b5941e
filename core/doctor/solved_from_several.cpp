#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/doctor/frame_fit.h"
#include "core/doctor/lens_changes.h"
#include "core/doctor/solved_mistakes.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

/// Values that take two or three points: near and far, a viewport's rectangle, K.
namespace unprojector::doctor {
using namespace geometry;
using base::marked;
namespace {

using Answers = std::vector<Answered>;
/// The values that fit all points best; empty if the points do not determine them.
using Fit = std::function<std::vector<double>(const Answers &)>;

/// The fitted values, each with the sum of its changes by the last digits of all points.
std::vector<Solution> solved(const Given &given, const Fit &fit)
{
    Answers answers;
    for (const Target &point : given.points) {
        answers.emplace_back(given, middleOf(given, point), point.got);
        if (!answers.back().there)
            return {};
    }
    std::vector<Solution> solutions;
    for (const double value : fit(answers)) {
        if (!std::isfinite(value))
            return {};
        solutions.push_back({value, 0.0});
    }
    // More points make the values no less certain.
    const std::size_t most = std::min<std::size_t>(given.points.size(), 4);
    for (std::size_t i = 0; !solutions.empty() && i < most; ++i) {
        const Answered kept = answers[i];
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 moved = kept.got;
            moved[axis] += kCutOff * given.points[i].lastDigit[axis];
            answers[i] = Answered(given, kept.click, moved);
            const std::vector<double> values = answers[i].there ? fit(answers) : std::vector<double>();
            if (values.empty())
                return {};
            for (std::size_t k = 0; k < solutions.size(); ++k)
                solutions[k].unsure += std::abs(values[k] - solutions[k].value);
        }
        answers[i] = kept;
    }
    return solutions;
}

/// The two numbers of least squares: y = a u + b v.
struct TwoNumbers {
    glm::dmat2 normal{0.0};
    glm::dvec2 right{0.0};

    void add(const glm::dvec2 &factors, double value)
    {
        normal += glm::outerProduct(factors, factors);
        right += factors * value;
    }
    bool areDetermined() const
    {
        constexpr double kSingular = 1e-12;
        return glm::determinant(normal) > kSingular * normal[0][0] * normal[1][1];
    }
    glm::dvec2 numbers() const { return glm::inverse(normal) * right; }
};

/// True if a solved value may be `value`. Then a mistake with fewer values explains the points.
bool mayBe(const Solution &solution, double value)
{
    return std::abs(solution.value - value) <= solution.unsure;
}

// Depth

/// Near and far: 1/z is linear in the depth in a perspective, z in a box.
std::vector<double> nearAndFar(const Given &given, const Answers &answers)
{
    TwoNumbers fit;
    for (const Answered &of : answers) {
        const double share = shareFromNear(given, of.click), z = given.side * eyeFromGot(given, of).z;
        // z² times an error of 1/z is the error of z.
        const double weight = given.isPerspective ? z * z : 1.0;
        fit.add(weight * glm::dvec2(1.0 - share, share), weight * (given.isPerspective ? 1.0 / z : z));
    }
    if (!fit.areDetermined())
        return {};
    const glm::dvec2 ends = fit.numbers();
    return given.isPerspective ? std::vector{1.0 / ends.x, 1.0 / ends.y} : std::vector{ends.x, ends.y};
}

/// Adds the pairs of round numbers that explain all points together. The errors of near and far
/// belong together: one plane is rounded, then the other is solved with it and rounded.
void addRoundPlanes(VariantList &list, const Given &given, std::span<const Solution> planes,
                    std::span<const double> known)
{
    constexpr double kOrders = 2.0;
    for (const bool isNearFirst : {true, false}) {
        for (const WrittenValue &first : roundValues(planes[isNearFirst ? 0 : 1], known)) {
            const std::optional<Solution> other =
                isNearFirst ? solvedFar(given, first.value) : solvedNear(given, first.value);
            if (!other)
                continue;
            for (const WrittenValue &second : roundValues(*other, known)) {
                Variant variant = isNearFirst ? withOtherPlanes(first.value, second.value)
                                              : withOtherPlanes(second.value, first.value);
                variant.unknowns = 2;
                variant.coincidence = kOrders * first.coincidence * second.coincidence;
                variant.isExpected = variant.coincidence <= kRoundByChance;
                list.add("near-far-differ", std::move(variant));
            }
        }
    }
}

void addNearAndFar(VariantList &list, const Given &given)
{
    const std::vector<Solution> planes =
        solved(given, [&](const Answers &answers) { return nearAndFar(given, answers); });
    if (planes.empty() || !(planes[0].value < planes[1].value) || (given.isPerspective && !(planes[0].value > 0.0)))
        return;
    // Then one plane alone explains the points.
    if ((mayBe(planes[0], given.nearDistance) && solvedFar(given, given.nearDistance))
        || (mayBe(planes[1], given.farDistance) && solvedNear(given, given.farDistance)))
        return;
    const std::array known{given.nearDistance, given.farDistance};
    addRoundPlanes(list, given, planes, known);
    if (hideAll(given, planes[0].value, planes[1].value))
        return;
    addSolved(list, "near-far-differ", planes, known,
              [](std::span<const double> values) { return withOtherPlanes(values[0], values[1]); });
}

// Pixels: the position (x, y) that the program uses is a linear function of the right one

/// The shift and the scale of all positions: dx, dy, scale.
std::vector<double> shiftAndScale(const Answers &answers)
{
    const double count = double(answers.size());
    glm::dvec2 from(0.0), to(0.0);
    for (const Answered &of : answers) {
        from += of.click.pixel.coordinates() / count;
        to += glm::dvec2(*of.there) / count;
    }
    double squares = 0.0, products = 0.0;
    for (const Answered &of : answers) {
        const glm::dvec2 off = of.click.pixel.coordinates() - from;
        squares += glm::dot(off, off);
        products += glm::dot(off, glm::dvec2(*of.there) - to);
    }
    if (!(squares > 0.0))
        return {};
    const double scale = products / squares;
    const glm::dvec2 shift = to - scale * from;
    return {shift.x, shift.y, scale};
}

void addShiftAndScale(VariantList &list, const Given &given)
{
    const std::vector<Solution> values = solved(given, shiftAndScale);
    if (values.empty() || !(values[2].value > values[2].unsure))
        return;
    if (mayBe(values[2], 1.0) || (mayBe(values[0], 0.0) && mayBe(values[1], 0.0)))
        return;
    constexpr std::array kUsual{0.0, 2.0, 0.5};
    addSolved(list, "pixel-scaled-and-moved", values, kUsual,
              [](std::span<const double> solved) { return scaledAndMoved(solved[2], solved[0], solved[1]); });
}

/// Another centre of K. It moves all pixels alike, so the values are those of a shift.
void addCentre(VariantList &list, const Given &given)
{
    const auto shift = solvedShift(given);
    if (!shift)
        return;
    const cameras::Intrinsics k = intrinsicsOf(given);
    const Viewport &own = given.viewport;
    const double middleX = own.x + own.width / 2.0, middleY = flippedY(given.surface, own.y + own.height / 2.0);
    const std::array known{0.0, k.cx - middleX, k.cy - middleY};
    addSolved(list, "principal-point-differs", *shift, known, [&k](std::span<const double> values) {
        const double cx = k.cx - values[0], cy = k.cy - values[1];
        return shifted(values[0], values[1],
                       {marked("the centre is %1"),
                        {valueText(cx) + ", " + valueText(cy)},
                        marked("Your program has the centre of K at %1.")},
                       {{"cx", {cx}}, {"cy", {cy}}});
    });
}

/// Another focal length for each axis, or another aspect of the lens.
void addFocalLengths(VariantList &list, const Given &given)
{
    const cameras::Intrinsics k = intrinsicsOf(given);
    const glm::dvec2 focalOfView(k.fx, k.fy), centreOfView(k.cx, k.cy);
    const std::vector<Solution> focal = solved(given, [&](const Answers &answers) {
        glm::dvec2 squares(0.0), products(0.0);
        for (const Answered &of : answers) {
            const glm::dvec2 from = of.click.pixel.coordinates() - centreOfView;
            squares += from * from;
            products += from * (glm::dvec2(*of.there) - centreOfView);
        }
        const glm::dvec2 lengths = focalOfView * squares / products;
        return std::vector{lengths.x, lengths.y};
    });
    if (focal.empty() || !(focal[0].value * focalOfView.x > 0.0) || !(focal[1].value * focalOfView.y > 0.0))
        return;
    const double x = focal[0].value / focalOfView.x, y = focal[1].value / focalOfView.y;
    if (std::abs(x - y) <= std::abs(focal[0].unsure / focalOfView.x) + std::abs(focal[1].unsure / focalOfView.y))
        return; // one angle
    const std::array known{focalOfView.x, focalOfView.y};
    addSolved(list, "focal-lengths-differ", focal, known, [&](std::span<const double> values) {
        return Variant{.stage = Stage::Lens,
                       .apply =
                           [](Run &run) {
                               run.clipFromEye[0][0] *= run.parameter;
                               run.clipFromEye[1][1] *= run.second;
                           },
                       .parameter = values[0] / focalOfView.x,
                       .second = values[1] / focalOfView.y,
                       .name = {marked("fx is %1, fy is %2"),
                                {valueText(values[0]), valueText(values[1])},
                                marked("Your program has fx %1 and fy %2.")},
                       .values = {{"fx", {values[0]}}, {"fy", {values[1]}}}};
    });
}

/// The viewport's rectangle: window = (ndc + 1) / 2 * size + origin, for each axis.
void addRectangle(VariantList &list, const Given &given)
{
    const Viewport &own = given.viewport;
    const std::vector<Solution> rectangle = solved(given, [&](const Answers &answers) -> std::vector<double> {
        TwoNumbers x, y;
        for (const Answered &of : answers) {
            const glm::dvec2 ndc = ndcXy(own, glm::dvec2(of.there->x, flippedY(given.surface, of.there->y)));
            x.add({1.0, (ndc.x + 1.0) / 2.0}, of.click.pixel.x);
            y.add({1.0, (ndc.y + 1.0) / 2.0}, flippedY(given.surface, of.click.pixel.y));
        }
        if (!x.areDetermined() || !y.areDetermined())
            return {};
        const glm::dvec2 across = x.numbers(), along = y.numbers();
        return {across.x, along.x, across.y, along.y};
    });
    if (rectangle.empty() || !(rectangle[2].value > 0.0) || !(rectangle[3].value > 0.0))
        return;
    const bool isPlaceOwn = mayBe(rectangle[0], own.x) && mayBe(rectangle[1], own.y);
    if (isPlaceOwn || (mayBe(rectangle[2], own.width) && mayBe(rectangle[3], own.height)))
        return;
    const std::array known{0.0,
                           own.x,
                           own.y,
                           own.width,
                           own.height,
                           double(given.surface.widthPixels),
                           double(given.surface.heightPixels)};
    addSolved(list, "viewport-size-differs", rectangle, known, [](std::span<const double> values) {
        Variant variant{
            .stage = Stage::Lens,
            .apply =
                [](Run &run) {
                    const glm::dvec4 &r = (*run.matrix)[0];
                    run.viewport = {r[0], r[1], r[2], r[3]};
                },
            .name = {marked("%1 pixels at %2"),
                     {valueText(values[2]) + " x " + valueText(values[3]),
                      valueText(values[0]) + ", " + valueText(values[1])},
                     marked("Your program's viewport has %1 pixels and is at %2.")},
            .values = {{"width", {values[2]}}, {"height", {values[3]}}, {"x", {values[0]}}, {"y", {values[1]}}}};
        variant.matrix[0] = {values[0], values[1], values[2], values[3]};
        return variant;
    });
}

} // namespace

std::vector<Lack> lackOf(const Given &given)
{
    std::vector<Lack> lacks;
    if (given.points.size() < 2 || !areDepthsKnown(given))
        return lacks;
    std::vector<glm::dvec3> right;
    double low = 1.0, high = 0.0;
    for (const Target &point : given.points) {
        const Click click = middleOf(given, point);
        if (const auto answered = answer(given, click, {}))
            right.push_back(*answered);
        low = std::min(low, shareFromNear(given, click));
        high = std::max(high, shareFromNear(given, click));
    }
    constexpr double kOneDepth = 1e-6;
    if (high - low < kOneDepth)
        lacks.push_back(Lack::OtherDepth);
    if (extentOf(right) < Extent::Plane)
        lacks.push_back(Lack::Plane);
    return lacks;
}

void addSolvedFromSeveral(VariantList &list, const Given &given)
{
    if (given.points.size() < 2)
        return;
    if (areDepthsKnown(given) && std::isfinite(given.nearDistance))
        addNearAndFar(list, given);
    addShiftAndScale(list, given);
    addRectangle(list, given);
    if (given.isPerspective) {
        addCentre(list, given);
        addFocalLengths(list, given);
    }
    if (areDepthsKnown(given))
        addSolvedFrames(list, given);
}

} // namespace unprojector::doctor
