#include "core/doctor/hypotheses.h"

#include "core/doctor/mistakes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::doctor {
namespace {

/// Answers whose coordinates differ by less than this, in units of the last digit, count as equal.
constexpr double kSameAnswer = 1e-3;

/// Tries a hypothesis on all points; returns empty if one of them has no answer.
std::optional<Hypothesis> tried(const Given &given, Hypothesis hypothesis)
{
    for (std::size_t i = 0; i < given.points.size(); ++i) {
        const auto found = hypothesis.nearest(given, given.points[i]);
        if (!found)
            return std::nullopt;
        if (i == 0)
            hypothesis.point = found->point;
        hypothesis.distance += found->distance / double(given.points.size());
        hypothesis.add(i, found->distance);
    }
    return hypothesis;
}

/// True if a mistake changes no answer distinguishably.
bool isWithoutEffect(const Given &given, const Variant &variant)
{
    const Variant *const parts[] = {&variant};
    for (const Target &target : given.points) {
        for (const Click &click : target.clicks) {
            const auto right = answer(given, click, {}), wrong = answer(given, click, parts);
            if (!right || !wrong || greatestOf((*wrong - *right) / target.lastDigit) > kSameAnswer)
                return false;
        }
    }
    return true;
}

bool isRatio(const Variant &variant)
{
    return mistakes()[variant.mistake].id.starts_with("ratio-");
}

/// True for a mistake of the view matrix, which closed formulas use too.
bool isOfView(const Variant &variant)
{
    return mistakes()[variant.mistake].id.starts_with("view-") && variant.stage == Stage::Factors;
}

bool hasOtherWay(const Variant &a, const Variant &b)
{
    return a.stage == b.stage || (a.stage == Stage::Eye && isOfView(b)) || (isOfView(a) && b.stage == Stage::Eye);
}

} // namespace

double unitsOff(const Target &target, int axis, const glm::dvec3 &answer)
{
    const double got = target.got[axis], off = (answer[axis] - got) / target.lastDigit[axis];
    // The number was not truncated at its last significant digit if fewer digits count than were
    // given.
    const bool isAllThatWasGiven = target.lastDigit[axis] == target.writtenDigit[axis];
    const bool isNearerToZero = (got > 0.0 && off < -kRounded) || (got < 0.0 && off > kRounded);
    return isAllThatWasGiven && isNearerToZero ? std::max(2.0, std::abs(off)) : std::abs(off);
}

void Hypothesis::add(std::size_t index, double ofPoint)
{
    worst = std::max(worst, ofPoint);
    if (ofPoint <= kCutOff)
        return;
    ++missed;
    lastMissed = index;
}

bool Hypothesis::isSolved() const
{
    return count == 1 && parts[0]->unknowns > 0;
}

bool Hypothesis::isExpected() const
{
    return isSolved() && parts[0]->isExpected;
}

std::optional<Run> Hypothesis::ranFor(const Given &given, const Click &click) const
{
    const bool isSameStage = count == 2 && parts[0]->stage == parts[1]->stage;
    std::array<const Variant *, 2> inOrder = parts;
    if (isOtherWay && isSameStage)
        std::swap(inOrder[0], inOrder[1]);
    return ran(given, click, {inOrder.data(), count}, isOtherWay && !isSameStage);
}

std::optional<glm::dvec3> Hypothesis::answerTo(const Given &given, const Click &click) const
{
    const auto run = ranFor(given, click);
    return run ? std::optional(run->point) : std::nullopt;
}

bool isSameAnswer(const glm::dvec3 &a, const glm::dvec3 &b)
{
    return glm::length(a - b) <= 1e-9 * (1.0 + glm::length(b));
}

std::optional<Nearest> Hypothesis::nearest(const Given &given, const Target &target) const
{
    const auto first = answerTo(given, target.clicks[0]);
    if (!first)
        return std::nullopt;
    glm::dvec3 closest = *first;
    if (target.clicks.size() > 1) {
        const auto second = answerTo(given, target.clicks[1]);
        if (!second)
            return std::nullopt;
        // The units are the last digits', so that each coordinate counts by its precision.
        const glm::dvec3 way = (*second - *first) / target.lastDigit;
        const glm::dvec3 toGot = (target.got - *first) / target.lastDigit;
        const double length = glm::dot(way, way);
        double share = length > 0.0 ? glm::dot(toGot, way) / length : 0.0;
        if (!target.isLine)
            share = std::clamp(share, 0.0, 1.0);
        closest = *first + share * (*second - *first);
    }
    return Nearest{
        closest, std::max({unitsOff(target, 0, closest), unitsOff(target, 1, closest), unitsOff(target, 2, closest)})};
}

std::vector<Hypothesis> hypotheses(const Given &given, std::span<const Variant> list)
{
    std::vector<Hypothesis> result;
    std::vector<const Variant *> effective;
    for (const Variant &variant : list) {
        if (isWithoutEffect(given, variant))
            continue;
        const auto one = tried(given, {{&variant, nullptr}, 1});
        // Solved values are right only if they explain all points without another mistake.
        const bool isSolved = variant.unknowns > 0;
        if (!isSolved && !variant.isAlone)
            effective.push_back(&variant);
        if (one && (!isSolved || one->worst <= kCutOff))
            result.push_back(*one);
    }
    result.reserve(result.size() + effective.size() * effective.size());
    for (std::size_t i = 0; i < effective.size(); ++i) {
        for (std::size_t j = i + 1; j < effective.size(); ++j) {
            const Variant &a = *effective[i], &b = *effective[j];
            // A program has one pixel ratio, and makes a mistake in one variant.
            if (a.mistake == b.mistake || (isRatio(a) && isRatio(b)))
                continue;
            if (const auto two = tried(given, {{&a, &b}, 2}))
                result.push_back(*two);
            if (hasOtherWay(a, b)) {
                if (const auto two = tried(given, {{&a, &b}, 2, true}))
                    result.push_back(*two);
            }
        }
    }
    return result;
}

} // namespace unprojector::doctor
