#include "core/examples/solids.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace unprojector::examples {
using namespace mesh;

namespace {

constexpr int kRings = 144; ///< from the foremost point to the rearmost
constexpr int kAround = 160;

/// 1 in the middle, 0.6 at one width from it.
double bell(double off, double width)
{
    const double share = off / width;
    return std::exp(-0.5 * share * share);
}

double bell(double x, double y, double widthX, double widthY)
{
    return bell(x, widthX) * bell(y, widthY);
}

/// The nose's height: it grows from the root to the tip, where it ends at once.
/// @param x, y  as in faceHeight
double noseHeight(double x, double y)
{
    const double down = glm::clamp((0.27 - y) / 0.47, 0.0, 1.0); // 0 at the root, 1 at the tip
    const double ridge = (0.02 + 0.17 * std::pow(down, 1.1)) * bell(x, 0.06 + 0.055 * down * down)
                         * glm::smoothstep(-0.3, -0.2, y) * (1.0 - glm::smoothstep(0.2, 0.36, y));
    const double tip = 0.045 * bell(x, y + 0.17, 0.06, 0.05);
    const double wing = 0.085 * bell(x - 0.115, y + 0.205, 0.045, 0.045);
    return ridge + tip + wing;
}

double eyeHeight(double x, double y)
{
    const double socket = 0.17 * bell(x - 0.34, y - 0.17, 0.15, 0.085);
    const double besideTheNose = 0.05 * bell(x - 0.14, y - 0.18, 0.07, 0.1);
    const double across = (x - 0.335) / 0.135, up = (y - 0.165) / 0.062;
    const double closedLids = 0.085 * std::pow(std::max(0.0, 1.0 - across * across - up * up), 1.3);
    return closedLids - socket - besideTheNose;
}

double mouthHeight(double x, double y)
{
    constexpr double kHalfWidth = 0.24;
    const double inside = std::max(0.0, 1.0 - (x / kHalfWidth) * (x / kHalfWidth)); // 0 at the corners and beyond
    const double betweenLips = -0.47 - 0.02 * std::cos(x / kHalfWidth * std::numbers::pi / 2.0) + 0.018 * bell(x, 0.03);
    const double lips = std::pow(inside, 0.8)
                        * (0.06 * bell(y - betweenLips - 0.045, 0.032) + 0.07 * bell(y - betweenLips + 0.06, 0.038));
    const double groove = 0.035 * std::pow(inside, 0.6) * bell(y - betweenLips, 0.012);
    const double philtrum = 0.015 * bell(x, y + 0.36, 0.025, 0.05);
    return 0.06 * bell(x, y + 0.48, 0.24, 0.17) + lips - groove - philtrum;
}

/// The face's height above the egg, along z.
/// @param x  of the left or the right half; y upwards
double faceHeight(double x, double y)
{
    x = std::abs(x);
    const double brows = 0.05 * bell(x - 0.28, y - 0.32, 0.2, 0.07) + 0.03 * bell(x, y - 0.3, 0.12, 0.08);
    const double cheek = 0.05 * bell(x - 0.42, y + 0.08, 0.16, 0.12);
    const double chin = 0.15 * bell(x, y + 0.79, 0.17, 0.1) - 0.05 * bell(x, y + 0.635, 0.16, 0.04);
    return brows + cheek + chin + eyeHeight(x, y) + noseHeight(x, y) + mouthHeight(x, y);
}

/// The ear's height, along x: a rim and part of the inside.
double earHeight(double y, double z)
{
    const double fromMiddle = std::hypot((y - 0.08) / 0.22, (z + 0.02) / 0.13);
    const double rim = bell(fromMiddle - 0.85, 0.25);
    return 0.1 * (rim + 0.35 * bell(fromMiddle, 0.5));
}

/// @param direction  from the middle of the head, a unit vector
glm::dvec3 surfaceTowards(const glm::dvec3 &direction)
{
    const auto outwards = [&direction](double length) { return std::copysign(length, direction.x); };
    const double inFront = glm::smoothstep(0.0, 0.5, direction.z);
    const double atSide = glm::smoothstep(0.45, 0.7, std::abs(direction.x));
    glm::dvec3 p = direction * glm::dvec3(0.78, direction.y > 0.0 ? 1.0 : 1.05, 0.95);

    const double low = glm::smoothstep(-0.1, 1.0, -p.y);
    p.x *= 1.0 - 0.2 * low; // the jaw is narrower
    if (p.z < 0.0) {        // and the back of the head longer and higher
        p.z *= 1.08 - 0.3 * low;
        p.y += 0.08 * glm::smoothstep(0.0, 0.9, -p.z);
    }
    const double forehead = 0.1 * bell(p.y - 0.6, 0.22), jaw = 0.17 * glm::smoothstep(0.25, 0.9, -p.y);
    p.z += inFront * (forehead + jaw);
    const double temple = 0.05 * bell(p.y - 0.25, p.z - 0.45, 0.2, 0.2) * std::min(1.0, std::abs(p.x) / 0.3);
    p.x -= outwards(temple);
    if (inFront > 0.0) // computing the face takes most of the time
        p.z += inFront * faceHeight(p.x, p.y);
    if (atSide > 0.0)
        p.x += outwards(atSide * earHeight(p.y, p.z));
    return p;
}

/// @param ring  0 at the front … kRings at the back
glm::dvec3 direction(int ring, int around)
{
    const double share = double(ring) / kRings;
    const double fromAhead = std::numbers::pi * (0.7 * share + 0.3 * share * share * share); // rings crowd at the face
    const double turn = 2.0 * std::numbers::pi * around / kAround;
    return {std::sin(fromAhead) * std::cos(turn), std::sin(fromAhead) * std::sin(turn), std::cos(fromAhead)};
}

} // namespace

Mesh headMesh()
{
    std::vector<glm::dvec3> corners{surfaceTowards({0.0, 0.0, 1.0})};
    for (int ring = 1; ring < kRings; ++ring) {
        for (int around = 0; around < kAround; ++around)
            corners.push_back(surfaceTowards(direction(ring, around)));
    }
    corners.push_back(surfaceTowards({0.0, 0.0, -1.0}));

    // All of the first ring and all of the last one are one corner each.
    const auto corner = [last = static_cast<int>(corners.size()) - 1](int ring, int around) {
        return static_cast<std::uint32_t>(std::clamp(1 + (ring - 1) * kAround + around % kAround, 0, last));
    };
    Mesh mesh;
    std::vector<glm::dvec3> normals(corners.size(), glm::dvec3(0.0));
    const auto addTriangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.indices.insert(mesh.indices.end(), {a, b, c});
        const glm::dvec3 area = glm::cross(corners[b] - corners[a], corners[c] - corners[a]);
        for (const std::uint32_t i : {a, b, c})
            normals[i] += area;
    };
    for (int ring = 0; ring < kRings; ++ring) {
        for (int around = 0; around < kAround; ++around) {
            if (ring + 1 < kRings)
                addTriangle(corner(ring, around), corner(ring + 1, around), corner(ring + 1, around + 1));
            if (ring > 0)
                addTriangle(corner(ring, around), corner(ring + 1, around + 1), corner(ring, around + 1));
        }
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        mesh.positions.emplace_back(corners[i]);
        mesh.normals.emplace_back(glm::normalize(normals[i]));
    }
    return mesh;
}

} // namespace unprojector::examples
