#include "core/examples/utah_teapot.h"

#include <glm/geometric.hpp>

#include <cassert>
#include <cstddef>

namespace unprojector::examples {
using namespace mesh;

namespace {

// The published list is redundant: six bands are rotated around the axis by quarters, and the spout
// and the handle are mirror images of their own halves. This is the rest.

/// One ring of control points. A quarter of it runs (radius, 0), (radius, bend), (bend, radius),
/// (0, radius).
struct Ring {
    double radius;
    double height;
    double bend;
};

/// One cross-section of half a tube: control points on two sides of the mirror plane's width.
struct Section {
    double innerX, innerHeight;
    double outerX, outerHeight;
    double halfWidth;
};

using Band = std::array<Ring, 4>;
using Half = std::array<Section, 4>;

constexpr Band kRim{{{1.4, 2.4, 0.784}, {1.3375, 2.53125, 0.749}, {1.4375, 2.53125, 0.805}, {1.5, 2.4, 0.84}}};
constexpr Band kUpperBody{{{1.5, 2.4, 0.84}, {1.75, 1.875, 0.98}, {2.0, 1.35, 1.12}, {2.0, 0.9, 1.12}}};
constexpr Band kLowerBody{{{2.0, 0.9, 1.12}, {2.0, 0.45, 1.12}, {1.5, 0.225, 0.84}, {1.5, 0.15, 0.84}}};
constexpr Band kKnob{{{0.0, 3.15, 0.0}, {0.8, 3.15, 0.45}, {0.0, 2.85, 0.0}, {0.2, 2.7, 0.112}}};
constexpr Band kLid{{{0.2, 2.7, 0.112}, {0.4, 2.55, 0.224}, {1.3, 2.55, 0.728}, {1.3, 2.4, 0.728}}};
constexpr Band kBottom{{{0.0, 0.0, 0.0}, {1.425, 0.0, 0.798}, {1.5, 0.075, 0.84}, {1.5, 0.15, 0.84}}};

constexpr Half kUpperHandle{{{-1.6, 2.025, -1.5, 2.25, 0.3},
                             {-2.3, 2.025, -2.5, 2.25, 0.3},
                             {-2.7, 2.025, -3.0, 2.25, 0.3},
                             {-2.7, 1.8, -3.0, 1.8, 0.3}}};
constexpr Half kLowerHandle{{{-2.7, 1.8, -3.0, 1.8, 0.3},
                             {-2.7, 1.575, -3.0, 1.35, 0.3},
                             {-2.5, 1.125, -2.65, 0.9375, 0.3},
                             {-2.0, 0.9, -1.9, 0.6, 0.3}}};
constexpr Half kSpout{{{1.7, 1.425, 1.7, 0.6, 0.66},
                       {2.6, 1.425, 3.1, 0.825, 0.66},
                       {2.3, 2.1, 2.4, 2.025, 0.25},
                       {2.7, 2.4, 3.3, 2.4, 0.25}}};
constexpr Half kSpoutMouth{{{2.7, 2.4, 3.3, 2.4, 0.25},
                            {2.8, 2.475, 3.525, 2.49375, 0.25},
                            {2.9, 2.475, 3.45, 2.5125, 0.15},
                            {2.8, 2.4, 3.2, 2.4, 0.15}}};

/// Rotates a quarter turn from +x to +z.
glm::dvec3 turned(const glm::dvec3 &point)
{
    return {-point.z, point.y, point.x};
}

glm::dvec3 mirrored(const glm::dvec3 &point)
{
    return {point.x, point.y, -point.z};
}

/// Adds four patches around the axis. The bands run downwards and outwards, so that turning from +x
/// to +z makes the normals point out. The bottom runs outwards and up and must turn the other way.
void addBand(std::vector<BezierPatch> &patches, const Band &band, bool backwards = false)
{
    BezierPatch patch;
    for (std::size_t v = 0; v < 4; ++v) {
        const auto [radius, height, bend] = band[v];
        patch[v] = {{{radius, height, 0.0}, {radius, height, bend}, {bend, height, radius}, {0.0, height, radius}}};
    }
    for (int quarter = 0; quarter < 4; ++quarter) {
        BezierPatch &added = patches.emplace_back(patch);
        for (auto &row : patch) {
            for (auto &point : row)
                point = turned(point);
        }
        if (!backwards)
            continue;
        for (auto &row : added) {
            for (auto &point : row)
                point = mirrored(point);
        }
    }
}

/// Adds half a tube with z > 0, and its mirror image.
void addTube(std::vector<BezierPatch> &patches, const Half &half)
{
    BezierPatch front;
    BezierPatch back;
    for (std::size_t v = 0; v < 4; ++v) {
        const Section &s = half[v];
        front[v] = {{{s.innerX, s.innerHeight, 0.0},
                     {s.innerX, s.innerHeight, s.halfWidth},
                     {s.outerX, s.outerHeight, s.halfWidth},
                     {s.outerX, s.outerHeight, 0.0}}};
        for (std::size_t u = 0; u < 4; ++u)
            back[v][u] = mirrored(front[v][3 - u]);
    }
    patches.push_back(front);
    patches.push_back(back);
}

/// The cubic Bernstein polynomials at t, exact at 0 and 1, where patches that share an edge must
/// agree.
std::array<double, 4> weights(double t)
{
    const double s = 1.0 - t;
    return {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
}

std::array<double, 4> weightDerivatives(double t)
{
    const double s = 1.0 - t;
    return {-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t};
}

glm::dvec3 combined(const BezierPatch &patch, const std::array<double, 4> &alongU, const std::array<double, 4> &alongV)
{
    glm::dvec3 sum{0.0};
    for (std::size_t v = 0; v < 4; ++v) {
        for (std::size_t u = 0; u < 4; ++u)
            sum += alongV[v] * alongU[u] * patch[v][u];
    }
    return sum;
}

glm::dvec3 normalAt(const BezierPatch &patch, double u, double v)
{
    const glm::dvec3 alongU = combined(patch, weightDerivatives(u), weights(v));
    const glm::dvec3 alongV = combined(patch, weights(u), weightDerivatives(v));
    const glm::dvec3 normal = glm::cross(alongU, alongV);
    // Sixteen rounded terms need not cancel to zero on an edge that is one point.
    constexpr double kNoLength = 1e-12;
    if (v > 0.0 || glm::length(alongU) > kNoLength)
        return glm::normalize(normal);
    // Near v = 0 dP/du is v d2P/dudv there, and the positive v does not change the direction.
    return glm::normalize(glm::cross(combined(patch, weightDerivatives(u), weightDerivatives(v)), alongV));
}

void addPatch(Mesh &mesh, const BezierPatch &patch, int divisions)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int row = 0; row <= divisions; ++row) {
        for (int column = 0; column <= divisions; ++column) {
            const double u = static_cast<double>(column) / divisions;
            const double v = static_cast<double>(row) / divisions;
            mesh.positions.emplace_back(combined(patch, weights(u), weights(v)));
            mesh.normals.emplace_back(normalAt(patch, u, v));
        }
    }

    const auto addTriangle = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const auto &p = mesh.positions;
        if (p[a] != p[b] && p[b] != p[c] && p[c] != p[a])
            mesh.indices.insert(mesh.indices.end(), {a, b, c});
    };
    const auto stride = static_cast<std::uint32_t>(divisions) + 1;
    for (std::uint32_t row = 0; row + 1 < stride; ++row) {
        for (std::uint32_t column = 0; column + 1 < stride; ++column) {
            const std::uint32_t corner = first + row * stride + column;
            addTriangle(corner, corner + 1, corner + stride);
            addTriangle(corner + 1, corner + stride + 1, corner + stride);
        }
    }
}

} // namespace

std::vector<BezierPatch> utahTeapotPatches()
{
    std::vector<BezierPatch> patches;
    patches.reserve(32);
    addBand(patches, kRim);
    addBand(patches, kUpperBody);
    addBand(patches, kLowerBody);
    addTube(patches, kUpperHandle);
    addTube(patches, kLowerHandle);
    addTube(patches, kSpout);
    addTube(patches, kSpoutMouth);
    addBand(patches, kKnob);
    addBand(patches, kLid);
    addBand(patches, kBottom, true);
    return patches;
}

Mesh utahTeapotMesh(int divisionsPerSide)
{
    assert(divisionsPerSide >= 2);
    Mesh mesh;
    for (const BezierPatch &patch : utahTeapotPatches())
        addPatch(mesh, patch, divisionsPerSide);
    return mesh;
}

} // namespace unprojector::examples
