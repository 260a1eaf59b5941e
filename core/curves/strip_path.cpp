// The shortest path in a strip of triangles unfolded into the plane, by the funnel algorithm (Lee
// and Preparata, 1984).

#include "core/curves/triangle_strip.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::curves {
namespace {

double cross2(const glm::dvec2 &a, const glm::dvec2 &b)
{
    return a.x * b.y - a.y * b.x;
}

double angleBetween(const glm::dvec2 &a, const glm::dvec2 &b)
{
    return std::atan2(std::abs(cross2(a, b)), glm::dot(a, b));
}

/// An edge in the plane, with left and right in walking direction.
struct Gate {
    std::uint32_t left = 0, right = 0; ///< corners
    glm::dvec2 atLeft{0.0}, atRight{0.0};
};

/// The position of a corner in the plane, beside an edge.
/// @param side  1: ahead in walking direction, -1: behind
glm::dvec2 unfolded(const PlacedMesh &mesh, const Gate &gate, std::uint32_t corner, double side)
{
    const glm::dvec3 base = mesh[gate.right];
    const glm::dvec3 edge = mesh[gate.left] - base, to = mesh[corner] - base;
    const double length = glm::length(edge);
    const glm::dvec2 along = (gate.atLeft - gate.atRight) / length;
    return gate.atRight + glm::dot(edge, to) / length * along
           + side * glm::length(glm::cross(edge, to)) / length * glm::dvec2(along.y, -along.x);
}

/// The strip in the plane.
struct Unfolding {
    std::vector<Gate> gates;
    glm::dvec2 from{0.0}, to{0.0};
};

Unfolding unfolding(const TriangleStrip &strip, const PlacedMesh &mesh, const PathEnd &from, const PathEnd &to)
{
    Unfolding plane;
    Gate gate{strip.edges[0][0], strip.edges[0][1]};
    gate.atLeft = glm::dvec2(0.0, glm::distance(mesh[gate.left], mesh[gate.right]));
    const auto placed = [&](std::uint32_t triangle, double side) {
        return [&, triangle, side](std::uint32_t corner) {
            if (corner == gate.left)
                return gate.atLeft;
            return corner == gate.right
                       ? gate.atRight
                       : unfolded(mesh, gate, mesh->thirdCorner(triangle, gate.left, gate.right), side);
        };
    };
    plane.from = from.mixed(placed(strip.triangles.front(), -1.0));
    plane.gates.push_back(gate);
    for (std::size_t i = 1; i < strip.edges.size(); ++i) {
        const std::uint32_t third = mesh->thirdCorner(strip.triangles[i], gate.left, gate.right);
        const glm::dvec2 at = unfolded(mesh, gate, third, 1.0);
        const bool keepsLeft = strip.edges[i][0] == gate.left || strip.edges[i][1] == gate.left;
        (keepsLeft ? gate.right : gate.left) = third;
        (keepsLeft ? gate.atRight : gate.atLeft) = at;
        plane.gates.push_back(gate);
    }
    plane.to = to.mixed(placed(strip.triangles.back(), 1.0));
    return plane;
}

/// A bend of the path, or one of its ends.
struct Knot {
    glm::dvec2 at{0.0};
    std::size_t gate = 0; ///< index of the gate at the knot; for the end one past the last
    bool isLeft = false;
};

std::vector<Knot> funnel(const Unfolding &plane)
{
    const std::size_t count = plane.gates.size();
    std::vector<Knot> knots;
    glm::dvec2 apex = plane.from, left = apex, right = apex;
    std::size_t ofLeft = 0, ofRight = 0;
    for (std::size_t i = 0; i <= count; ++i) {
        const glm::dvec2 l = i < count ? plane.gates[i].atLeft : plane.to,
                         r = i < count ? plane.gates[i].atRight : plane.to;
        const auto restart = [&](const glm::dvec2 &at, std::size_t gate, bool isLeft) {
            knots.push_back({at, gate, isLeft});
            apex = left = right = at;
            ofLeft = ofRight = gate;
            i = gate;
        };
        if (i == count) { // the end has no sides to narrow
            if (left != apex && cross2(left - apex, l - apex) > 0.0)
                restart(left, ofLeft, true);
            else if (right != apex && cross2(right - apex, l - apex) < 0.0)
                restart(right, ofRight, false);
            continue;
        }
        if (cross2(right - apex, r - apex) >= 0.0) {
            if (right == apex || cross2(left - apex, r - apex) < 0.0) {
                right = r;
                ofRight = i;
            } else {
                restart(left, ofLeft, true);
                continue;
            }
        }
        if (cross2(left - apex, l - apex) <= 0.0) {
            if (left == apex || cross2(right - apex, l - apex) > 0.0) {
                left = l;
                ofLeft = i;
            } else {
                restart(right, ofRight, false);
                continue;
            }
        }
    }
    knots.push_back({plane.to, count, false});
    return knots;
}

} // namespace

StripPath shortestIn(const TriangleStrip &strip, const PlacedMesh &mesh, const PathEnd &from, const PathEnd &to)
{
    StripPath path;
    path.places.push_back(from.place());
    if (strip.edges.empty()) {
        path.places.push_back(to.place());
        path.length = glm::distance(from.place(), to.place());
        return path;
    }
    const Unfolding plane = unfolding(strip, mesh, from, to);
    const std::vector<Gate> &gates = plane.gates;
    const std::vector<Knot> knots = funnel(plane);
    glm::dvec2 before = plane.from;
    std::size_t gate = 0;
    for (std::size_t k = 0; k < knots.size(); ++k) {
        const Knot &knot = knots[k];
        path.length += glm::distance(before, knot.at);
        for (; gate < std::min(knot.gate, gates.size()); ++gate) { // the crossings of the edges in between
            const Gate &g = gates[gate];
            const glm::dvec2 along = knot.at - before, side = g.atLeft - g.atRight;
            const double across = cross2(along, side);
            const double share = across != 0.0 ? std::clamp(cross2(along, before - g.atRight) / across, 0.0, 1.0) : 0.5;
            path.places.push_back((1.0 - share) * mesh[g.right] + share * mesh[g.left]);
        }
        if (k + 1 == knots.size())
            break;
        StripPath::Bend bend;
        const auto cornerOf = [&](std::size_t i) { return knot.isLeft ? gates[i].left : gates[i].right; };
        const auto otherAt = [&](std::size_t i) { return knot.isLeft ? gates[i].atRight : gates[i].atLeft; };
        bend.corner = cornerOf(knot.gate);
        bend.first = bend.last = knot.gate;
        while (bend.first > 0 && cornerOf(bend.first - 1) == bend.corner)
            --bend.first;
        while (bend.last + 1 < gates.size() && cornerOf(bend.last + 1) == bend.corner)
            ++bend.last;
        path.places.push_back(mesh[bend.corner]);
        gate = bend.last + 1;
        const glm::dvec2 in = before - knot.at, out = knots[k + 1].at - knot.at;
        if (glm::length(in) > 0.0 && glm::length(out) > 0.0) {
            bend.angle = angleBetween(in, otherAt(bend.first) - knot.at);
            for (std::size_t i = bend.first; i < bend.last; ++i)
                bend.angle += angleBetween(otherAt(i) - knot.at, otherAt(i + 1) - knot.at);
            bend.angle += angleBetween(otherAt(bend.last) - knot.at, out);
            path.bends.push_back(bend);
        }
        before = knot.at;
    }
    path.places.push_back(to.place());
    return path;
}

} // namespace unprojector::curves
