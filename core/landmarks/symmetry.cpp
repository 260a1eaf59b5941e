#include "core/landmarks/symmetry.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

namespace unprojector::landmarks {
namespace {

enum class Side { None, Left, Right };

/// What is left of a name without its side.
struct SidedName {
    Side side = Side::None;
    std::string rest;
    friend bool operator<(const SidedName &a, const SidedName &b)
    {
        return std::tie(a.side, a.rest) < std::tie(b.side, b.rest);
    }
};

bool isSeparator(char c)
{
    return c == ' ' || c == '_' || c == '-' || c == '.' || c == '(' || c == ')';
}

SidedName sidedNameOf(const std::string &name)
{
    std::string lower = name;
    for (char &c : lower)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    constexpr std::array<std::pair<std::string_view, Side>, 4> kWords{
        {{"left", Side::Left}, {"right", Side::Right}, {"l", Side::Left}, {"r", Side::Right}}};
    for (const auto &[word, side] : kWords) {
        if (lower.size() <= word.size())
            continue;
        const std::size_t rest = lower.size() - word.size();
        // Where the word stood stays marked: "L eye" is no partner of "eye R".
        if (lower.starts_with(word) && isSeparator(lower[word.size()]))
            return {side, '<' + lower.substr(word.size())};
        if (lower.ends_with(word) && isSeparator(lower[rest - 1]))
            return {side, lower.substr(0, rest) + '>'};
        if (lower.size() > word.size() + 1 && lower.ends_with(std::string(word) + ')') && isSeparator(lower[rest - 2]))
            return {side, lower.substr(0, rest - 1) + '>'};
    }
    return {Side::None, lower};
}

/// Of a symmetric matrix: the eigenvector of the least eigenvalue, by Jacobi's rotations; nothing where it is not alone.
std::optional<glm::dvec3> leastAxis(glm::dmat3 m)
{
    glm::dmat3 axes(1.0);
    for (int sweep = 0; sweep < 50; ++sweep) {
        for (const auto &[p, q] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
            if (m[p][q] == 0.0)
                continue;
            const double theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
            const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(1.0, theta));
            const double c = 1.0 / std::hypot(1.0, t), s = t * c;
            glm::dmat3 rotation(1.0);
            rotation[p][p] = rotation[q][q] = c;
            rotation[q][p] = s;
            rotation[p][q] = -s;
            m = glm::transpose(rotation) * m * rotation;
            m[p][q] = m[q][p] = 0.0;
            axes = axes * rotation;
        }
    }
    const std::array values{m[0][0], m[1][1], m[2][2]};
    const auto least = static_cast<int>(std::min_element(values.begin(), values.end()) - values.begin());
    double size = 0.0, gap = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        size = std::max(size, std::abs(values[std::size_t(i)]));
        if (i != least)
            gap = std::min(gap, values[std::size_t(i)] - values[std::size_t(least)]);
    }
    if (!std::isfinite(size) || !(gap > 1e-12 * size))
        return std::nullopt;
    return glm::normalize(axes[least]);
}

std::vector<std::size_t> partnersOf(std::size_t count, std::span<const Pair> pairs)
{
    std::vector<std::size_t> partners(count);
    for (std::size_t i = 0; i < count; ++i)
        partners[i] = i;
    for (const Pair &pair : pairs) {
        partners[pair.left] = pair.right;
        partners[pair.right] = pair.left;
    }
    return partners;
}

} // namespace

std::vector<Pair> pairsByName(std::span<const Landmark> landmarks)
{
    std::map<SidedName, std::vector<std::size_t>> places;
    for (std::size_t i = 0; i < landmarks.size(); ++i)
        places[sidedNameOf(landmarks[i].name)].push_back(i);
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        SidedName name = sidedNameOf(landmarks[i].name);
        if (name.side != Side::Left || places[name].size() != 1)
            continue;
        name.side = Side::Right;
        if (const auto partner = places.find(name); partner != places.end() && partner->second.size() == 1)
            pairs.push_back({i, partner->second.front()});
    }
    return pairs;
}

WorldPoint MirrorPlane::mirrored(const WorldPoint &point) const
{
    const double height = glm::dot(normal.coordinates(), point.coordinates()) - offset;
    return point - 2.0 * height * normal;
}

std::optional<MirrorPlane> mirrorPlaneOf(std::span<const Landmark> landmarks, std::span<const Pair> pairs)
{
    const std::vector<std::size_t> partners = partnersOf(landmarks.size(), pairs);
    const auto counts = [&](std::size_t i) { return !landmarks[i].isMissing() && !landmarks[partners[i]].isMissing(); };
    const auto place = [&](std::size_t i) { return landmarks[i].world->coordinates(); };
    // About the first, so that the coordinates of a map keep their digits.
    glm::dvec3 about(0.0), sum(0.0);
    std::size_t count = 0;
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        if (!counts(i))
            continue;
        about = count == 0 ? place(i) : about;
        sum += place(i) - about;
        ++count;
    }
    if (count == 0)
        return std::nullopt;
    const glm::dvec3 center = about + sum / double(count);
    // |mirror(l) - r|^2 = |l - r|^2 + 4 (n.l)(n.r) about the centre: the least n is an eigenvector.
    glm::dmat3 m(0.0);
    glm::dvec3 toRight(0.0);
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        if (!counts(i))
            continue;
        const glm::dvec3 a = place(i) - center, b = place(partners[i]) - center;
        m += 0.5 * (glm::outerProduct(a, b) + glm::outerProduct(b, a));
    }
    bool hasPair = false;
    for (const Pair &pair : pairs) {
        if (!counts(pair.left))
            continue;
        hasPair = true;
        toRight += place(pair.right) - place(pair.left);
    }
    const std::optional<glm::dvec3> axis = hasPair ? leastAxis(m) : std::nullopt;
    if (!axis)
        return std::nullopt;
    const glm::dvec3 normal = glm::dot(*axis, toRight) < 0.0 ? -*axis : *axis;
    return MirrorPlane{WorldVector(normal), glm::dot(normal, center)};
}

std::vector<std::optional<double>> asymmetriesOf(std::span<const Landmark> landmarks, std::span<const Pair> pairs,
                                                 const MirrorPlane &plane)
{
    const std::vector<std::size_t> partners = partnersOf(landmarks.size(), pairs);
    std::vector<std::optional<double>> distances(landmarks.size());
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        const Landmark &partner = landmarks[partners[i]];
        if (landmarks[i].world && partner.world)
            distances[i] = distance(plane.mirrored(*landmarks[i].world), *partner.world);
    }
    return distances;
}

} // namespace unprojector::landmarks
