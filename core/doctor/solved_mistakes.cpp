#include "core/doctor/solved_mistakes.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace unprojector::doctor {
using namespace geometry;
namespace {

/// The value from one point. The bound is the sum of the changes by the last digits of the point
/// and of the depth.
std::optional<Solution> solvedFromOne(const Given &given, const Target &target, const Solve &solve)
{
    const Click click = middleOf(given, target);
    const Value value = solve({given, click, target.got});
    if (!value || !std::isfinite(*value))
        return std::nullopt;
    double unsure = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 moved = target.got;
        moved[axis] += kCutOff * target.lastDigit[axis];
        const Value there = solve({given, click, moved});
        if (!there)
            return std::nullopt;
        unsure += std::abs(*there - *value);
    }
    if (target.clicks.size() > 1 && !target.isLine) {
        const Value there = solve({given, target.clicks.front(), target.got});
        if (!there)
            return std::nullopt;
        unsure += std::abs(*there - *value);
    }
    return std::isfinite(unsure) ? std::optional(Solution{*value, unsure}) : std::nullopt;
}

/// The greatest distance of a variant's answers from the points, in units of the last digit. It is
/// without the jump of unitsOff(), so that it can be minimised.
double distanceOf(const Given &given, const Variant &variant)
{
    Hypothesis hypothesis;
    hypothesis.parts[0] = &variant;
    hypothesis.count = 1;
    double worst = 0.0;
    for (const Target &target : given.points) {
        const auto found = hypothesis.nearest(given, target);
        if (!found)
            return std::numeric_limits<double>::infinity();
        const glm::dvec3 off = glm::abs(found->point - target.got) / target.lastDigit;
        worst = std::max({worst, off.x, off.y, off.z});
    }
    return worst;
}

/// The least of a function with one minimum, by golden sections.
double leastOf(double low, double high, const std::function<double(double)> &f)
{
    constexpr double kShare = 0.6180339887498949;
    constexpr int kSteps = 30; // to a millionth of the range
    double a = high - kShare * (high - low), b = low + kShare * (high - low);
    double atA = f(a), atB = f(b);
    for (int i = 0; i < kSteps; ++i) {
        if (atA < atB) {
            high = b;
            b = a;
            atB = atA;
            a = high - kShare * (high - low);
            atA = f(a);
        } else {
            low = a;
            a = b;
            atA = atB;
            b = low + kShare * (high - low);
            atB = f(b);
        }
    }
    return (low + high) / 2.0;
}

} // namespace

std::optional<Solution> solvedFrom(const Given &given, const Solve &solve)
{
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    double sum = 0.0, weights = 0.0;
    for (const Target &target : given.points) {
        const auto one = solvedFromOne(given, target, solve);
        if (!one)
            continue;
        low = std::max(low, one->value - one->unsure);
        high = std::min(high, one->value + one->unsure);
        const double weight = 1.0 / std::max(one->unsure * one->unsure, std::numeric_limits<double>::min());
        sum += weight * one->value;
        weights += weight;
    }
    if (!(weights > 0.0) || !(low <= high))
        return std::nullopt;
    const double mean = std::clamp(sum / weights, low, high);
    return Solution{mean, std::max(mean - low, high - mean)};
}

std::optional<std::array<Solution, 2>> solvedShift(const Given &given)
{
    std::array<Solution, 2> shift;
    for (int axis = 0; axis < 2; ++axis) {
        const auto solved = solvedFrom(given, [&](const Answered &of) -> Value {
            return of.there ? std::optional((*of.there)[axis] - of.click.pixel.coordinates()[axis]) : std::nullopt;
        });
        if (!solved)
            return std::nullopt;
        shift[std::size_t(axis)] = *solved;
    }
    return shift;
}

Variant shifted(double dx, double dy, VariantName name, std::vector<SolvedValue> values)
{
    return {.stage = Stage::Pixel,
            .apply = [](Run &run) { run.position += glm::dvec2(run.parameter, run.second); },
            .parameter = dx,
            .second = dy,
            .name = std::move(name),
            .values = std::move(values)};
}

/// True if values are round enough that chance hardly made them so. The scene's own values among
/// several are no evidence against it.
bool areRound(std::span<const Solution> solutions, std::span<const WrittenValue> values, double coincidence)
{
    constexpr double kMostOfOne = 0.1;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i].coincidence > kMostOfOne && values[i].value != solutions[i].ofScene)
            return false;
    }
    return coincidence <= kRoundByChance;
}

void addSolved(VariantList &list, std::string_view id, std::span<const Solution> solutions,
               std::span<const double> known, const std::function<Variant(std::span<const double>)> &made, int ways)
{
    std::vector<double> exact, determined, round;
    std::vector<WrittenValue> writtenValues;
    double coincidence = ways;
    for (const Solution &solution : solutions) {
        exact.push_back(solution.value);
        determined.push_back(asDetermined(solution).value);
        writtenValues.push_back(written(solution, known));
        round.push_back(writtenValues.back().value);
        coincidence *= writtenValues.back().coincidence;
    }
    const auto add = [&](Variant variant, bool isExpected, double chance) {
        variant.unknowns = int(solutions.size());
        variant.isExpected = isExpected;
        variant.coincidence *= chance;
        list.add(id, std::move(variant));
    };
    const bool isExpected = areRound(solutions, writtenValues, coincidence);
    add(made(round), isExpected, isExpected || solutions.size() == 1 ? coincidence : 1.0);
    const Variant asDigits = made(determined);
    add(asDigits, false, 1.0);
    // Several points may leave less than a digit. Digits that they do not determine are not written.
    Variant asSolved = made(exact);
    asSolved.name = asDigits.name;
    asSolved.values = asDigits.values;
    add(std::move(asSolved), false, 1.0);
}

void addSolvedNumber(VariantList &list, std::string_view id, const Given &given, const Solution &solution,
                     std::span<const double> known, const std::function<Variant(double)> &made)
{
    const auto distance = [&](double value) { return distanceOf(given, made(value)); };
    Solution best = solution;
    best.value = leastOf(solution.value - solution.unsure, solution.value + solution.unsure, distance);
    if (distance(solution.value) <= distance(best.value))
        best.value = solution.value;
    best.unsure += std::abs(best.value - solution.value); // a round value stays within the bound
    addSolved(list, id, {&best, 1}, known, [&](std::span<const double> values) { return made(values[0]); });
}

Click middleOf(const Given &given, const Target &target)
{
    Click click = target.clicks.front();
    if (target.clicks.size() > 1 && !target.isLine) {
        click.depth = (click.depth + target.clicks[1].depth) / 2.0;
        setRightEye(given, click);
    }
    return click;
}

bool hideAll(const Given &given, double nearDistance, double farDistance)
{
    return std::all_of(given.points.begin(), given.points.end(), [&](const Target &target) {
        const double distance = given.side * middleOf(given, target).eye.z;
        return distance < nearDistance || distance > farDistance;
    });
}

bool areDepthsKnown(const Given &given)
{
    return std::none_of(given.points.begin(), given.points.end(), [](const Target &target) { return target.isLine; });
}

double shareFromNear(const Given &given, const Click &click)
{
    return given.shareFromNear(given.unitDepth(click.depth));
}

glm::dvec3 eyeFromGot(const Given &given, const Answered &of)
{
    const bool isEye = of.click.space == PointSpace::Eye;
    return transformed(isEye ? glm::dmat4(1.0) : given.eyeFromWorld * of.click.worldFromObject, of.got);
}

} // namespace unprojector::doctor
