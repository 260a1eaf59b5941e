#include "core/examples/bundled_scene.h"

#include "core/examples/solids.h"
#include "core/examples/utah_teapot.h"

#include <glm/common.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace unprojector::examples {
using namespace geometry;
using namespace mesh;
using namespace scene;

namespace {

using Color = glm::u8vec4;

// Muted colours, based on the palette of Tableau 10.
constexpr Color kBlue{78, 121, 167, 255};
constexpr Color kClay{222, 150, 84, 255};
constexpr Color kRed{225, 87, 89, 255};
constexpr Color kTeal{118, 183, 178, 255};
constexpr Color kGreen{89, 161, 79, 255};
constexpr Color kYellow{237, 201, 72, 255};
constexpr Color kPurple{176, 122, 161, 255};
constexpr Color kPink{255, 157, 167, 255};
constexpr Color kSand{222, 206, 180, 255};

constexpr double kCubeEdge = 1.8;
constexpr double kTorusRingRadius = 1.0;
constexpr double kTorusTubeRadius = 0.36;
constexpr double kBallRadius = 0.7;
constexpr double kConeHeight = 3.6;
constexpr double kTeapotScale = 0.8;

glm::vec4 fraction(const Color &color)
{
    return glm::vec4(color) / 255.0f;
}

Color mixed(const Color &from, const Color &to, double share)
{
    return Color(glm::round(glm::mix(glm::vec4(from), glm::vec4(to), static_cast<float>(share))));
}

/// A colour on a closed loop through all the given ones; turn in [0, 1].
template <std::size_t count>
Color onLoop(const std::array<Color, count> &colors, double turn)
{
    const double place = turn * count;
    const auto before = static_cast<std::size_t>(place) % count;
    return mixed(colors[before], colors[(before + 1) % count], place - std::floor(place));
}

Mesh colored(Mesh mesh, const Color &color)
{
    mesh.baseColor = fraction(color);
    return mesh;
}

/// @param colorOf  the colour of the vertex with this index
template <class ColorOf>
Mesh coloredByVertex(Mesh mesh, ColorOf colorOf)
{
    mesh.baseColor = glm::vec4(1.0f);
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex)
        mesh.colors.push_back(colorOf(vertex));
    return mesh;
}

Mesh coloredCube()
{
    constexpr std::array<Color, 6> kFaces{kRed, kTeal, kYellow, kPurple, kBlue, kGreen};
    return coloredByVertex(cubeMesh(kCubeEdge), [&](std::size_t v) { return kFaces[v / kVerticesPerCubeFace]; });
}

Mesh coloredTorus()
{
    constexpr std::array<Color, 4> kAround{kTeal, kBlue, kPurple, kSand};
    const Mesh torus = torusMesh(kTorusRingRadius, kTorusTubeRadius, 96, 48);
    return coloredByVertex(torus, [&](std::size_t v) {
        const glm::dvec3 p = torus.positions[v];
        return onLoop(kAround, std::atan2(p.y, p.x) / (2.0 * std::numbers::pi) + 0.5);
    });
}

Mesh coloredBall()
{
    const Mesh ball = sphereMesh(kBallRadius, 4);
    return coloredByVertex(ball, [&](std::size_t v) { return mixed(kPurple, kPink, ball.normals[v].y / 2.0 + 0.5); });
}

SceneObject object(std::string name, Mesh mesh, std::vector<TransformStep> transform)
{
    auto model = std::make_shared<Model>();
    model->name = name;
    model->meshes.push_back(std::move(mesh));
    model->bounds = boundsOf(model->meshes);
    return {std::move(name), {}, std::move(model), std::move(transform)};
}

Translate movedBy(double x, double y, double z)
{
    return {glm::dvec3(x, y, z)};
}

Rotate turnedBy(double degrees)
{
    return {degrees, glm::dvec3(0.0, 1.0, 0.0)};
}

} // namespace

std::vector<SceneObject> bundledScene()
{
    constexpr double kTorusHeight = kTorusRingRadius + kTorusTubeRadius;
    return {
        object("Teapot", colored(utahTeapotMesh(), kClay), {movedBy(-0.3, 0.0, 0.7), Scale{glm::dvec3(kTeapotScale)}}),
        object("Cube", coloredCube(), {movedBy(3.2, kCubeEdge / 2.0, -2.4), turnedBy(-20.0)}),
        object("Torus", coloredTorus(), {movedBy(-4.2, kTorusHeight, -0.7), turnedBy(30.0)}),
        object("Ball", coloredBall(), {movedBy(2.8, kBallRadius, 2.7)}),
        object("Cone", colored(coneMesh(1.2, kConeHeight, 96), kGreen), {movedBy(-1.9, kConeHeight / 2.0, -5.6)}),
    };
}

} // namespace unprojector::examples
