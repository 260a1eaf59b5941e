#include "core/landmarks/symmetry.h"

#include "core/base/text_scanner.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

namespace unprojector::landmarks {
using namespace geometry;

namespace {

enum class Side { None, Left, Right };

/// The rest of a name without its side.
struct SidedName {
    Side side = Side::None;
    std::string rest;
    friend auto operator<=>(const SidedName &, const SidedName &) = default;
};

bool isSeparator(char c)
{
    return c == ' ' || c == '_' || c == '-' || c == '.' || c == '(' || c == ')';
}

SidedName sidedNameOf(const std::string &name)
{
    struct Word {
        std::string_view text, inBrackets;
        Side side;
        bool isChinese = false; ///< without blanks between words: 左外眼角, 外眼角（左）
    };
    constexpr std::array<Word, 6> kWords{{{"left", "left)", Side::Left},
                                          {"right", "right)", Side::Right},
                                          {"l", "l)", Side::Left},
                                          {"r", "r)", Side::Right},
                                          {"左", "（左）", Side::Left, true},
                                          {"右", "（右）", Side::Right, true}}};
    const std::string lower = base::lowerCase(name);
    for (const Word &word : kWords) {
        if (word.isChinese && lower.starts_with("左右")) // neither side
            break;
        const auto isApart = [&](std::size_t i) { return word.isChinese || isSeparator(lower[i]); };
        // The position of the word stays marked: "L eye" is no partner of "eye R".
        if (lower.size() > word.text.size() && lower.starts_with(word.text) && isApart(word.text.size()))
            return {word.side, '<' + lower.substr(word.text.size())};
        for (const std::string_view ending : {word.text, word.inBrackets}) {
            if (lower.size() > ending.size() && lower.ends_with(ending) && isApart(lower.size() - ending.size() - 1))
                return {word.side, lower.substr(0, lower.size() - ending.size()) + '>'};
        }
    }
    return {Side::None, lower};
}

/// The axes of a symmetric matrix, the least eigenvalue's first.
struct Axes3 {
    std::array<glm::dvec3, 3> axes;
    std::array<double, 3> values;
};

/// Computes the axes by Jacobi rotations; returns empty if the least eigenvalue is not unique.
std::optional<Axes3> axesOf(glm::dmat3 m)
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
    const glm::dvec3 values(m[0][0], m[1][1], m[2][2]);
    const int least = values.x <= values.y && values.x <= values.z ? 0 : values.y <= values.z ? 1 : 2;
    const int second = (least + 1) % 3, third = (least + 2) % 3;
    const double size = std::max({std::abs(values.x), std::abs(values.y), std::abs(values.z)});
    if (!std::isfinite(size) || !(std::min(values[second], values[third]) - values[least] > 1e-12 * size))
        return std::nullopt;
    return Axes3{{glm::normalize(axes[least]), glm::normalize(axes[second]), glm::normalize(axes[third])},
                 {values[least], values[second], values[third]}};
}

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// The partner of each landmark: itself in the middle; kNone for a sided one without a partner.
std::vector<std::size_t> partnersOf(std::span<const Landmark> landmarks, std::span<const Pair> pairs)
{
    std::vector<std::size_t> partners(landmarks.size());
    for (std::size_t i = 0; i < partners.size(); ++i)
        partners[i] = isSided(landmarks[i].name) ? kNone : i;
    for (const Pair &pair : pairs) {
        partners[pair.left] = pair.right;
        partners[pair.right] = pair.left;
    }
    return partners;
}

/// The plane, and the data that define it.
struct Fit {
    MirrorPlane plane;
    Axes3 axes;
    glm::dvec3 center{0.0};
    std::vector<std::size_t> partners;
    std::vector<std::size_t> counted; ///< the landmarks that define it
};

std::optional<Fit> fitOf(std::span<const Landmark> landmarks, std::span<const Pair> pairs)
{
    Fit fit;
    fit.partners = partnersOf(landmarks, pairs);
    const auto counts = [&](std::size_t i) {
        return fit.partners[i] != kNone && landmarks[i].isPlaced() && landmarks[fit.partners[i]].isPlaced();
    };
    const auto place = [&](std::size_t i) { return landmarks[i].world->coordinates(); };
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        if (counts(i))
            fit.counted.push_back(i);
    }
    if (fit.counted.empty())
        return std::nullopt;
    // Coordinates are relative to the first landmark, so that map coordinates keep their digits.
    const glm::dvec3 about = place(fit.counted.front());
    glm::dvec3 sum(0.0);
    for (const std::size_t i : fit.counted)
        sum += place(i) - about;
    fit.center = about + sum / double(fit.counted.size());
    // |mirror(l) - r|^2 = |l - r|^2 + 4 (n.l)(n.r) about the centre: the best n is an eigenvector.
    glm::dmat3 m(0.0);
    for (const std::size_t i : fit.counted) {
        const glm::dvec3 a = place(i) - fit.center, b = place(fit.partners[i]) - fit.center;
        m += 0.5 * (glm::outerProduct(a, b) + glm::outerProduct(b, a));
    }
    bool hasPair = false;
    glm::dvec3 toRight(0.0);
    for (const Pair &pair : pairs) {
        if (!counts(pair.left))
            continue;
        hasPair = true;
        toRight += place(pair.right) - place(pair.left);
    }
    const std::optional<Axes3> axes = hasPair ? axesOf(m) : std::nullopt;
    if (!axes)
        return std::nullopt;
    fit.axes = *axes;
    const glm::dvec3 normal = glm::dot(axes->axes[0], toRight) < 0.0 ? -axes->axes[0] : axes->axes[0];
    fit.plane = MirrorPlane{WorldVector(normal), glm::dot(normal, fit.center)};
    return fit;
}

} // namespace

bool isSided(const std::string &name)
{
    return sidedNameOf(name).side != Side::None;
}

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

double MirrorPlane::distanceTo(const WorldPoint &point) const
{
    return std::abs(glm::dot(normal.coordinates(), point.coordinates()) - offset);
}

std::vector<std::optional<double>> asymmetriesOf(std::span<const Landmark> landmarks, std::span<const Pair> pairs,
                                                 const MirrorPlane &plane)
{
    const std::vector<std::size_t> partners = partnersOf(landmarks, pairs);
    std::vector<std::optional<double>> distances(landmarks.size());
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        if (partners[i] == kNone)
            continue;
        const Landmark &partner = landmarks[partners[i]];
        if (landmarks[i].world && partner.world)
            distances[i] = distance(plane.mirrored(*landmarks[i].world), *partner.world);
    }
    return distances;
}

std::array<WorldPoint, 4> rectangleOf(const MirrorPlane &plane, std::span<const Landmark> landmarks,
                                      std::span<const std::size_t> counted)
{
    constexpr double kMargin = 0.1; // of the longer side, so that no landmark lies on the edge
    const glm::dvec3 n = plane.normal.coordinates(), size = glm::abs(n);
    const glm::dvec3 axis = size.z <= size.x && size.z <= size.y ? glm::dvec3(0, 0, 1)
                            : size.y <= size.x                   ? glm::dvec3(0, 1, 0)
                                                                 : glm::dvec3(1, 0, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(axis, n)), v = glm::cross(n, u);
    const glm::dvec3 start = landmarks[counted.front()].world->coordinates();
    const glm::dvec3 about = start - (glm::dot(n, start) - plane.offset) * n;
    double left = 0.0, right = 0.0, bottom = 0.0, top = 0.0;
    for (const std::size_t index : counted) {
        const glm::dvec3 way = landmarks[index].world->coordinates() - about;
        left = std::min(left, glm::dot(way, u));
        right = std::max(right, glm::dot(way, u));
        bottom = std::min(bottom, glm::dot(way, v));
        top = std::max(top, glm::dot(way, v));
    }
    const double margin = kMargin * std::max(right - left, top - bottom);
    const auto corner = [&](double x, double y) { return WorldPoint(about + x * u + y * v); };
    return {corner(left - margin, bottom - margin), corner(right + margin, bottom - margin),
            corner(right + margin, top + margin), corner(left - margin, top + margin)};
}

std::optional<Symmetry> symmetryOf(std::span<const Landmark> landmarks, std::span<const Pair> pairs)
{
    const std::optional<Fit> fit = fitOf(landmarks, pairs);
    if (!fit)
        return std::nullopt;
    const bool isKnown = std::all_of(fit->counted.begin(), fit->counted.end(),
                                     [&](std::size_t i) { return landmarks[i].uncertainty.has_value(); });
    const std::optional<double> error = isKnown ? std::optional(0.0) : std::nullopt;
    Symmetry symmetry{fit->plane, fit->counted, error, {}, {}};
    const std::vector<std::optional<double>> values = asymmetriesOf(landmarks, pairs, fit->plane);
    for (const std::optional<double> &value : values)
        symmetry.asymmetries.push_back(value ? std::optional(Measure{*value, error}) : std::nullopt);
    symmetry.distances.resize(landmarks.size());
    for (const std::size_t i : fit->counted)
        symmetry.distances[i] = Measure{fit->plane.distanceTo(*landmarks[i].world), error};
    if (!isKnown)
        return symmetry;
    const glm::dvec3 n = fit->plane.normal.coordinates();
    const double count = static_cast<double>(fit->counted.size());
    const auto fromCenter = [&](std::size_t i) { return landmarks[i].world->coordinates() - fit->center; };
    std::vector<glm::dvec3> widths(landmarks.size(), glm::dvec3(0.0)); // each coordinate in its worse direction
    std::vector<double> lengths(landmarks.size(), 0.0);                // along the direction from the partner
    for (const std::size_t j : fit->counted) {
        const glm::dvec3 b = fromCenter(fit->partners[j]);
        for (int axis = 0; axis < 3; ++axis) {
            const double off = std::abs((*landmarks[j].uncertainty)[axis]);
            glm::dvec3 moved(0.0);
            moved[axis] = 1.0;
            // The centre moves as well, but that does not change the matrix.
            const glm::dvec3 change = moved * glm::dot(b, n) + b * n[axis];
            glm::dvec3 dn(0.0);
            for (std::size_t e = 1; e < 3; ++e)
                dn += fit->axes.axes[e]
                      * (glm::dot(fit->axes.axes[e], change) / (fit->axes.values[0] - fit->axes.values[e]));
            *symmetry.offsetError += std::abs(glm::dot(dn, fit->center) + n[axis] / count) * off;
            for (const std::size_t i : fit->counted) {
                const glm::dvec3 a = fromCenter(i);
                const glm::dvec3 own = i == j ? moved : glm::dvec3(0.0);
                const double dHeight = glm::dot(dn, a) + glm::dot(n, own) - n[axis] / count;
                *symmetry.distances[i]->error += std::abs(dHeight) * off;
                glm::dvec3 dWay = own - 2.0 * dHeight * n - 2.0 * glm::dot(n, a) * dn;
                if (fit->partners[i] == j)
                    dWay -= moved;
                const glm::dvec3 way = fit->plane.mirrored(*landmarks[i].world).coordinates()
                                       - landmarks[fit->partners[i]].world->coordinates();
                widths[i] += glm::abs(dWay) * off;
                lengths[i] += std::abs(glm::dot(way, dWay)) * off;
            }
        }
    }
    for (const std::size_t i : fit->counted) {
        // An asymmetry that may be 0 has no direction, so any direction counts.
        const double any = glm::length(widths[i]), value = *values[i];
        symmetry.asymmetries[i]->error = value > any ? lengths[i] / value : any;
    }
    return symmetry;
}

} // namespace unprojector::landmarks
