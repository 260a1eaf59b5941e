#include "core/examples/solids.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace unprojector::examples {
using namespace mesh;

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The i-th of n directions around a circle. Quarter turns are exact, so that extremes are exact
/// too.
glm::dvec2 directionOnCircle(int i, int n)
{
    constexpr std::array<glm::dvec2, 4> kQuarters{{{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}}};
    i %= n;
    if (4 * i % n == 0)
        return kQuarters[static_cast<std::size_t>(4 * i / n)];
    const double angle = 2.0 * std::numbers::pi * i / n;
    return {std::cos(angle), std::sin(angle)};
}

void addVertex(Mesh &mesh, const glm::dvec3 &position, const glm::dvec3 &normal)
{
    mesh.positions.emplace_back(position);
    mesh.normals.emplace_back(normal);
}

void addTriangle(Mesh &mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

/// Two triangles, both from the first corner.
void addQuad(Mesh &mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
{
    mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
}

} // namespace

Mesh cubeMesh(double edgeLength)
{
    assert(edgeLength > 0.0);
    constexpr std::array<glm::dvec3, 3> kAxes{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    const double half = edgeLength / 2.0;
    Mesh mesh;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            const glm::dvec3 normal = sign * kAxes[axis];
            const glm::dvec3 across = kAxes[(axis + 1) % 3];
            const glm::dvec3 along = sign * kAxes[(axis + 2) % 3]; // across x along = normal
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            addVertex(mesh, half * (normal - across - along), normal);
            addVertex(mesh, half * (normal + across - along), normal);
            addVertex(mesh, half * (normal + across + along), normal);
            addVertex(mesh, half * (normal - across + along), normal);
            addQuad(mesh, first, first + 1, first + 2, first + 3);
        }
    }
    return mesh;
}

Mesh torusMesh(double ringRadius, double tubeRadius, int ringSegments, int tubeSegments)
{
    assert(tubeRadius > 0.0 && ringRadius > tubeRadius);
    assert(ringSegments >= 3 && tubeSegments >= 3);
    Mesh mesh;
    for (int ring = 0; ring < ringSegments; ++ring) {
        const glm::dvec2 around = directionOnCircle(ring, ringSegments);
        for (int tube = 0; tube < tubeSegments; ++tube) {
            const glm::dvec2 across = directionOnCircle(tube, tubeSegments);
            const glm::dvec3 normal{across.x * around, across.y};
            addVertex(mesh, glm::dvec3{ringRadius * around, 0.0} + tubeRadius * normal, normal);
        }
    }
    const auto vertexAt = [=](int ring, int tube) {
        return static_cast<std::uint32_t>(ring % ringSegments * tubeSegments + tube % tubeSegments);
    };
    for (int ring = 0; ring < ringSegments; ++ring) {
        for (int tube = 0; tube < tubeSegments; ++tube)
            addQuad(mesh, vertexAt(ring, tube), vertexAt(ring + 1, tube), vertexAt(ring + 1, tube + 1),
                    vertexAt(ring, tube + 1));
    }
    return mesh;
}

Mesh sphereMesh(double radius, int subdivisions)
{
    assert(radius > 0.0 && subdivisions >= 0);
    // The icosahedron's vertices are the corners of three golden rectangles, one in each coordinate
    // plane.
    const double g = std::numbers::phi;
    std::vector<glm::dvec3> directions{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                       {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (glm::dvec3 &direction : directions)
        direction = glm::normalize(direction);
    std::vector<Triangle> triangles{{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int step = 0; step < subdivisions; ++step) {
        std::unordered_map<std::uint64_t, std::uint32_t> middles; // by both ends
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [low, high] = std::minmax(a, b);
            const auto [found, isNew] =
                middles.try_emplace(std::uint64_t{low} << 32 | high, static_cast<std::uint32_t>(directions.size()));
            if (isNew)
                directions.push_back(glm::normalize(directions[a] + directions[b]));
            return found->second;
        };
        std::vector<Triangle> finer;
        finer.reserve(triangles.size() * 4);
        for (const auto [a, b, c] : triangles) {
            const std::uint32_t ab = middle(a, b);
            const std::uint32_t bc = middle(b, c);
            const std::uint32_t ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        triangles = std::move(finer);
    }

    Mesh mesh;
    for (const glm::dvec3 &direction : directions)
        addVertex(mesh, radius * direction, direction);
    for (const auto [a, b, c] : triangles)
        addTriangle(mesh, a, b, c);
    return mesh;
}

Mesh coneMesh(double baseRadius, double height, int segments)
{
    assert(baseRadius > 0.0 && height > 0.0 && segments >= 3);
    const double half = height / 2.0;
    const auto onBase = [=](int i) {
        const glm::dvec2 around = directionOnCircle(i, segments);
        return glm::dvec3{baseRadius * around.x, -half, baseRadius * around.y};
    };
    const auto sideNormal = [=](const glm::dvec2 &around) {
        return glm::normalize(glm::dvec3{height * around.x, baseRadius, height * around.y});
    };
    const auto count = static_cast<std::uint32_t>(segments);
    Mesh mesh;
    // The apex has no normal of its own: each side triangle has its own apex vertex with the normal
    // of its middle.
    for (int i = 0; i < segments; ++i)
        addVertex(mesh, onBase(i), sideNormal(directionOnCircle(i, segments)));
    for (int i = 0; i < segments; ++i)
        addVertex(mesh, {0.0, half, 0.0}, sideNormal(directionOnCircle(2 * i + 1, 2 * segments)));
    for (int i = 0; i < segments; ++i)
        addVertex(mesh, onBase(i), {0.0, -1.0, 0.0});
    addVertex(mesh, {0.0, -half, 0.0}, {0.0, -1.0, 0.0});
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t next = (i + 1) % count;
        addTriangle(mesh, next, i, count + i);
        addTriangle(mesh, 3 * count, 2 * count + i, 2 * count + next);
    }
    return mesh;
}

} // namespace unprojector::examples
