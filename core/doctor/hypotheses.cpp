#include "core/doctor/hypotheses.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::doctor {
namespace {

/// Answers whose coordinates differ by less than this, in units of the last digit, are one answer.
constexpr double kSameAnswer = 1e-3;

double largest(const glm::dvec3 &v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Tries a hypothesis on all points; nothing where one of them has no answer.
std::optional<Hypothesis> tried(const Given &given, std::span<const Sought> points, Hypothesis hypothesis)
{
    const auto parts = hypothesis.inOrder();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::optional<Nearest> found = nearest(given, points[i], {parts.data(), hypothesis.count});
        if (!found)
            return std::nullopt;
        if (i == 0)
            hypothesis.point = found->point;
        hypothesis.distance += found->distance / double(points.size());
        hypothesis.worst = std::max(hypothesis.worst, found->distance);
    }
    return hypothesis;
}

/// Whether a mistake changes no answer that could be told from the right one.
bool isWithoutEffect(const Given &given, std::span<const Sought> points, const Variant &variant)
{
    const Variant *const parts[] = {&variant};
    for (const Sought &sought : points) {
        for (const Click &click : sought.clicks) {
            const std::optional<glm::dvec3> right = answer(given, click, {}), wrong = answer(given, click, parts);
            if (!right || !wrong || largest((*wrong - *right) / sought.lastDigit) > kSameAnswer)
                return false;
        }
    }
    return true;
}

bool isRatio(const Variant &variant)
{
    return mistakes()[variant.mistake].id.starts_with("ratio-");
}

} // namespace

std::array<const Variant *, 2> Hypothesis::inOrder() const
{
    return isSecondFirst ? std::array{parts[1], parts[0]} : parts;
}

std::optional<Nearest> nearest(const Given &given, const Sought &sought, std::span<const Variant *const> list)
{
    const std::optional<glm::dvec3> first = answer(given, sought.clicks[0], list);
    if (!first)
        return std::nullopt;
    glm::dvec3 point = *first;
    if (sought.clicks.size() > 1) {
        const std::optional<glm::dvec3> second = answer(given, sought.clicks[1], list);
        if (!second)
            return std::nullopt;
        // In units of the last digits, so that a coordinate counts by how well it is known.
        const glm::dvec3 way = (*second - *first) / sought.lastDigit;
        const glm::dvec3 toGot = (sought.got - *first) / sought.lastDigit;
        const double length = glm::dot(way, way);
        double share = length > 0.0 ? glm::dot(toGot, way) / length : 0.0;
        if (!sought.isLine)
            share = std::clamp(share, 0.0, 1.0);
        point = *first + share * (*second - *first);
    }
    return Nearest{point, largest((point - sought.got) / sought.lastDigit)};
}

std::vector<Hypothesis> hypotheses(const Given &given, std::span<const Sought> points, std::span<const Variant> list)
{
    std::vector<Hypothesis> result;
    std::vector<const Variant *> effective;
    for (const Variant &variant : list) {
        if (isWithoutEffect(given, points, variant))
            continue;
        effective.push_back(&variant);
        if (const auto one = tried(given, points, {{&variant, nullptr}, 1}))
            result.push_back(*one);
    }
    for (std::size_t i = 0; i < effective.size(); ++i) {
        for (std::size_t j = i + 1; j < effective.size(); ++j) {
            const Variant &a = *effective[i], &b = *effective[j];
            // A program has one pixel ratio, and makes a mistake in one way.
            if (a.mistake == b.mistake || (isRatio(a) && isRatio(b)))
                continue;
            if (const auto two = tried(given, points, {{&a, &b}, 2}))
                result.push_back(*two);
            if (a.stage == b.stage) {
                if (const auto two = tried(given, points, {{&a, &b}, 2, true}))
                    result.push_back(*two);
            }
        }
    }
    return result;
}

} // namespace unprojector::doctor
