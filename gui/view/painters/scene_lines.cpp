#include "gui/view/painters/scene_lines.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace unprojector::gui {
using namespace geometry;

namespace {

constexpr std::array<glm::vec4, 3> kAxisColors{
    {{0.80f, 0.20f, 0.22f, 1.0f}, {0.20f, 0.58f, 0.24f, 1.0f}, {0.18f, 0.38f, 0.78f, 1.0f}}};

using Stroke = std::array<glm::dvec2, 2>;

/// Letters of height 2 about the origin.
std::vector<Stroke> letterStrokes(int axis)
{
    switch (axis) {
    case 0: return {{{{-0.7, -1.0}, {0.7, 1.0}}}, {{{-0.7, 1.0}, {0.7, -1.0}}}};
    case 1: return {{{{-0.7, 1.0}, {0.0, 0.1}}}, {{{0.7, 1.0}, {0.0, 0.1}}}, {{{0.0, 0.1}, {0.0, -1.0}}}};
    default: return {{{{-0.7, 1.0}, {0.7, 1.0}}}, {{{0.7, 1.0}, {-0.7, -1.0}}}, {{{-0.7, -1.0}, {0.7, -1.0}}}};
    }
}

} // namespace

std::vector<LineSegment> groundLines(const Box &ground, double spacing)
{
    std::vector<LineSegment> lines;
    if (ground.isEmpty())
        return lines;
    const auto color = [](long long index) {
        return index % 10 == 0 ? glm::vec4(0.35f, 0.38f, 0.42f, 0.55f) : glm::vec4(0.45f, 0.48f, 0.52f, 0.28f);
    };
    const double y = ground.lowest.y;
    // The positions are integer multiples of the spacing: adding it up would drift.
    for (long long i = std::llround(ground.lowest.x / spacing); i <= std::llround(ground.highest.x / spacing); ++i)
        lines.push_back({{i * spacing, y, ground.lowest.z}, {i * spacing, y, ground.highest.z}, color(i)});
    for (long long i = std::llround(ground.lowest.z / spacing); i <= std::llround(ground.highest.z / spacing); ++i)
        lines.push_back({{ground.lowest.x, y, i * spacing}, {ground.highest.x, y, i * spacing}, color(i)});
    return lines;
}

std::vector<LineSegment> axisLines(const Box &ground)
{
    if (ground.isEmpty())
        return {};
    const double length = std::max({std::abs(ground.highest.x), std::abs(ground.highest.z),
                                    ground.highest.x - ground.lowest.x, ground.highest.z - ground.lowest.z});
    std::vector<LineSegment> lines;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 tip(0.0);
        tip[axis] = axis == 1 ? length / 4.0 : length;
        lines.push_back({glm::dvec3(0.0), tip, kAxisColors[static_cast<std::size_t>(axis)]});
    }
    return lines;
}

std::vector<LineSegment> dropLines(const WorldPoint &point, const Box &ground)
{
    const auto contains = [](double lowest, double highest) { return lowest <= 0.0 && highest >= 0.0; };
    const bool hasOrigin = contains(ground.lowest.x, ground.highest.x) && contains(ground.lowest.z, ground.highest.z);
    const glm::dvec3 foot(hasOrigin ? 0.0 : ground.lowest.x, ground.lowest.y, hasOrigin ? 0.0 : ground.lowest.z);
    std::vector<LineSegment> lines;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 end = point.coordinates();
        end[axis] = foot[axis];
        lines.push_back({point.coordinates(), end, kAxisColors[static_cast<std::size_t>(axis)]});
    }
    return lines;
}

std::vector<LineSegment> faded(std::vector<LineSegment> lines)
{
    for (LineSegment &line : lines)
        line.color.a *= 0.25f;
    return lines;
}

std::vector<LineSegment> triadLines(const EyeFrame &frame)
{
    std::vector<LineSegment> lines;
    for (int axis = 0; axis < 3; ++axis) {
        const glm::vec4 color = kAxisColors[static_cast<std::size_t>(axis)];
        const glm::dvec3 tip(frame.side[axis], frame.upward[axis], -frame.forward[axis]);
        lines.push_back({glm::dvec3(0.0), tip * 0.9, color});
        const glm::dvec3 letter = tip * 1.2;
        for (const Stroke &stroke : letterStrokes(axis)) {
            constexpr double kHalfHeight = 0.13;
            lines.push_back({letter + glm::dvec3(stroke[0] * kHalfHeight, 0.0),
                             letter + glm::dvec3(stroke[1] * kHalfHeight, 0.0), color});
        }
    }
    // Far ones first: they are drawn without a depth test.
    std::stable_sort(lines.begin(), lines.end(),
                     [](const LineSegment &a, const LineSegment &b) { return a.to.z < b.to.z; });
    return lines;
}

} // namespace unprojector::gui
