#include "core/doctor/solved_mistakes.h"

#include <glm/matrix.hpp>

#include <cmath>
#include <utility>

namespace unprojector::doctor {
using namespace geometry;
namespace {

/// The click of a target, in the middle of its possible depths.
Click middleOf(const Given &given, const Target &target)
{
    Click click = target.clicks.front();
    if (target.clicks.size() > 1 && !target.isLine) {
        click.depth = (click.depth + target.clicks[1].depth) / 2.0;
        setRightEye(given, click);
    }
    return click;
}

/// The value from one point. The bound is the sum of the changes by the last digits of the point and
/// of the depth.
std::optional<Solution> solvedFromOne(const Given &given, const Target &target, const Solve &solve)
{
    const Click click = middleOf(given, target);
    const std::optional<double> value = solve(click, target.got);
    if (!value || !std::isfinite(*value))
        return std::nullopt;
    double unsure = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 moved = target.got;
        moved[axis] += kCutOff * target.lastDigit[axis];
        const std::optional<double> there = solve(click, moved);
        if (!there)
            return std::nullopt;
        unsure += std::abs(*there - *value);
    }
    if (target.clicks.size() > 1 && !target.isLine) {
        const std::optional<double> there = solve(target.clicks.front(), target.got);
        if (!there)
            return std::nullopt;
        unsure += std::abs(*there - *value);
    }
    return std::isfinite(unsure) ? std::optional(Solution{*value, unsure}) : std::nullopt;
}

} // namespace

std::optional<Solution> solvedFrom(const Given &given, std::span<const Target> points, const Solve &solve)
{
    std::optional<Solution> all;
    for (const Target &target : points) {
        const std::optional<Solution> one = solvedFromOne(given, target, solve);
        if (!one)
            continue;
        all = all ? common(*all, *one) : one;
        if (!all)
            return std::nullopt;
    }
    return all;
}

void addSolved(VariantList &list, std::string_view id, std::span<const Solution> solutions,
               std::span<const double> known, const std::function<Variant(std::span<const double>)> &made)
{
    std::vector<double> exact, determined, round;
    double coincidence = 1.0;
    for (const Solution &solution : solutions) {
        exact.push_back(solution.value);
        determined.push_back(asDetermined(solution).value);
        const WrittenValue value = written(solution, known);
        round.push_back(value.value);
        coincidence *= value.coincidence;
    }
    const auto add = [&](std::span<const double> values, bool isExpected) {
        Variant variant = made(values);
        variant.unknowns = int(values.size());
        variant.isExpected = isExpected;
        variant.coincidence = isExpected ? coincidence : 1.0;
        list.add(id, std::move(variant));
    };
    if (coincidence <= kRoundByChance)
        add(round, true);
    add(determined, false);
    // Several points may leave less than a digit.
    add(exact, false);
}

glm::dvec3 eyeFromGot(const Given &given, const Click &click, const glm::dvec3 &got)
{
    const glm::dmat4 eyeFromSpace =
        click.space == PointSpace::Eye ? glm::dmat4(1.0) : given.eyeFromWorld * click.worldFromObject;
    const glm::dvec4 eye = eyeFromSpace * glm::dvec4(got, 1.0);
    return glm::dvec3(eye) / eye.w;
}

void addSolvedMistakes(VariantList &list, const Given &given, const Case &scene, std::span<const Target> points)
{
    addSolvedFromOne(list, given, scene, points);
}

} // namespace unprojector::doctor
