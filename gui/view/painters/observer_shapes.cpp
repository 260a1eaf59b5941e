#include "gui/view/painters/observer_shapes.h"

#include <glm/geometric.hpp>

namespace unprojector::gui {
using namespace geometry;

namespace {

constexpr std::array<glm::vec3, 3> kAxisColors{{{0.80f, 0.20f, 0.22f}, {0.20f, 0.58f, 0.24f}, {0.18f, 0.38f, 0.78f}}};

using Polyline = std::vector<glm::dvec2>;

/// Letters of height 2 about the origin, as the lower-case names of axes.
std::vector<Polyline> letterStrokes(char letter)
{
    switch (letter) {
    case 's':
        return {{{0.6, 0.75},
                 {0.2, 1.0},
                 {-0.3, 1.0},
                 {-0.6, 0.7},
                 {-0.5, 0.25},
                 {0.5, -0.25},
                 {0.6, -0.7},
                 {0.3, -1.0},
                 {-0.2, -1.0},
                 {-0.6, -0.75}}};
    case 'u': return {{{-0.6, 1.0}, {-0.6, -0.5}, {-0.3, -1.0}, {0.2, -1.0}, {0.6, -0.5}}, {{0.6, 1.0}, {0.6, -1.0}}};
    case 'f': return {{{0.6, 1.1}, {0.2, 1.3}, {-0.1, 1.0}, {-0.1, -1.1}}, {{-0.6, 0.4}, {0.5, 0.4}}};
    case 'x': return {{{-0.7, -1.0}, {0.7, 1.0}}, {{-0.7, 1.0}, {0.7, -1.0}}};
    case 'y': return {{{-0.7, 1.0}, {0.0, 0.0}}, {{0.7, 1.0}, {-0.4, -1.0}}};
    default: return {{{-0.7, 1.0}, {0.7, 1.0}, {-0.7, -1.0}, {0.7, -1.0}}};
    }
}

glm::vec4 withOpacity(glm::vec4 color, float opacity)
{
    color.a *= opacity;
    return color;
}

/// Corner i of a box; the bits of i select the sides.
glm::dvec3 boxCorner(std::size_t i, const glm::dvec3 &lowest, const glm::dvec3 &highest)
{
    return {i & 1 ? highest.x : lowest.x, i & 2 ? highest.y : lowest.y, i & 4 ? highest.z : lowest.z};
}

constexpr glm::dvec3 kBodyLowest{-0.42, -0.30, 0.22}, kBodyHighest{0.42, 0.30, 1.0};
constexpr double kLensBack = 0.16, kLensFront = 0.30;

} // namespace

std::vector<Face> cameraFaces(float opacity)
{
    struct Side {
        std::array<std::size_t, 4> corners;
        float shade;
    };
    constexpr std::array<Side, 6> kSides{{{{0, 1, 3, 2}, 0.42f},
                                          {{4, 5, 7, 6}, 0.50f},
                                          {{0, 2, 6, 4}, 0.56f},
                                          {{1, 3, 7, 5}, 0.56f},
                                          {{0, 1, 5, 4}, 0.38f},
                                          {{2, 3, 7, 6}, 0.70f}}};
    std::vector<Face> faces;
    for (const Side &side : kSides) {
        Face face;
        for (std::size_t i = 0; i < 4; ++i)
            face.corners[i] = boxCorner(side.corners[i], kBodyLowest, kBodyHighest);
        face.color = {side.shade * 0.94f, side.shade * 0.98f, side.shade * 1.06f, opacity};
        faces.push_back(face);
    }
    // The lens: a hood that opens towards the scene, with the eye in its opening.
    constexpr std::array<glm::dvec2, 4> kAround{{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}};
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec2 a = kAround[i], b = kAround[(i + 1) % 4];
        const float shade = i == 2 ? 0.46f : 0.34f;
        faces.push_back({{glm::dvec3(a * kLensBack, kBodyLowest.z), glm::dvec3(b * kLensBack, kBodyLowest.z),
                          glm::dvec3(b * kLensFront, 0.0), glm::dvec3(a * kLensFront, 0.0)},
                         {shade * 0.94f, shade * 0.98f, shade * 1.06f, opacity}});
    }
    return faces;
}

std::vector<LineSegment> cameraLines(float opacity)
{
    const glm::vec4 color(0.16f, 0.18f, 0.21f, opacity);
    std::vector<LineSegment> lines;
    for (std::size_t i = 0; i < 8; ++i) {
        for (std::size_t bit = 1; bit < 8; bit *= 2) {
            if (!(i & bit))
                lines.push_back(
                    {boxCorner(i, kBodyLowest, kBodyHighest), boxCorner(i | bit, kBodyLowest, kBodyHighest), color});
        }
    }
    // The mark on top that shows the up direction.
    const double y = kBodyHighest.y, z = (kBodyLowest.z + kBodyHighest.z) / 2.0;
    const glm::dvec3 left(-0.22, y, z), right(0.22, y, z), tip(0.0, y + 0.34, z);
    for (const auto &[from, to] : {std::pair(left, right), std::pair(right, tip), std::pair(tip, left)})
        lines.push_back({from, to, color});
    return lines;
}

std::vector<LineSegment> letteredAxes(const glm::dvec3 &origin, const std::array<glm::dvec3, 3> &tips,
                                      const char *letters, const glm::dvec3 &side, const glm::dvec3 &upward,
                                      float opacity)
{
    std::vector<LineSegment> lines;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const glm::vec4 color(kAxisColors[axis], opacity);
        lines.push_back({origin, tips[axis], color});
        constexpr double kGap = 2.2; // half letters beyond the tip
        const glm::dvec3 center = tips[axis] + glm::normalize(tips[axis] - origin) * glm::length(upward) * kGap;
        for (const Polyline &stroke : letterStrokes(letters[axis])) {
            for (std::size_t i = 1; i < stroke.size(); ++i)
                lines.push_back({center + side * stroke[i - 1].x + upward * stroke[i - 1].y,
                                 center + side * stroke[i].x + upward * stroke[i].y, color});
        }
    }
    return lines;
}

std::vector<LineSegment> sideEdges(const std::array<EyePoint, 8> &corners)
{
    std::vector<LineSegment> lines;
    for (std::size_t i = 0; i < 4; ++i)
        lines.push_back({corners[i].coordinates(), corners[i + 4].coordinates(), observer_color::kEdge});
    return lines;
}

std::vector<LineSegment> edgesFromEye(const std::array<EyePoint, 8> &corners, float opacity)
{
    std::vector<LineSegment> lines;
    for (std::size_t i = 0; i < 4; ++i)
        lines.push_back({glm::dvec3(0.0), corners[i].coordinates(), withOpacity(observer_color::kEdge, opacity)});
    return lines;
}

std::array<glm::dvec3, 4> planeCorners(const std::array<EyePoint, 8> &corners, std::size_t first)
{
    return {corners[first].coordinates(), corners[first + 1].coordinates(), corners[first + 3].coordinates(),
            corners[first + 2].coordinates()};
}

std::vector<LineSegment> outline(const std::array<glm::dvec3, 4> &corners, const glm::vec4 &color)
{
    std::vector<LineSegment> lines;
    for (std::size_t i = 0; i < 4; ++i)
        lines.push_back({corners[i], corners[(i + 1) % 4], color});
    return lines;
}

std::vector<LineSegment> clippedLines(const std::vector<LineSegment> &lines, const std::array<glm::dvec4, 6> &planes,
                                      float opacity)
{
    std::vector<LineSegment> result;
    result.reserve(lines.size());
    for (const LineSegment &line : lines) {
        if (const std::optional<Segment> part = clipped(Segment{line.from, line.to}, planes))
            result.push_back({part->from, part->to, withOpacity(line.color, opacity)});
    }
    return result;
}

} // namespace unprojector::gui
