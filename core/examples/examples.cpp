#include "core/examples/examples.h"

#include "core/base/resource.h"
#include "core/examples/solids.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <utility>

namespace unprojector::examples {
using namespace geometry;
using namespace mesh;
using namespace scene;

namespace {

using Color = glm::u8vec4;
using Json = nlohmann::json;

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

Color mixed(const Color &from, const Color &to, double share)
{
    return Color(glm::round(glm::mix(glm::vec4(from), glm::vec4(to), static_cast<float>(share))));
}

Mesh colored(Mesh mesh, const Color &color)
{
    mesh.baseColor = glm::vec4(color) / 255.0f;
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

Mesh coloredCube(double edgeLength)
{
    constexpr std::array kFaces{kRed, kTeal, kYellow, kPurple, kBlue, kGreen};
    return coloredByVertex(cubeMesh(edgeLength), [&](std::size_t v) { return kFaces[v / kVerticesPerCubeFace]; });
}

Mesh coloredTorus(double ringRadius, double tubeRadius)
{
    constexpr std::array kAround{kTeal, kBlue, kPurple, kSand};
    const Mesh torus = torusMesh(ringRadius, tubeRadius, 96, 48);
    return coloredByVertex(torus, [&](std::size_t v) {
        const glm::dvec3 p = torus.positions[v];
        const double place = (std::atan2(p.y, p.x) / (2.0 * std::numbers::pi) + 0.5) * kAround.size();
        const std::size_t before = static_cast<std::size_t>(place) % kAround.size();
        return mixed(kAround[before], kAround[(before + 1) % kAround.size()], place - std::floor(place));
    });
}

Mesh coloredBall(double radius)
{
    const Mesh ball = sphereMesh(radius, 4);
    return coloredByVertex(ball, [&](std::size_t v) { return mixed(kPurple, kPink, ball.normals[v].y / 2.0 + 0.5); });
}

/// A mesh of models.json: triangles with a normal each; every corner keeps the colour of its
/// position.
Mesh flatMesh(const Json &json)
{
    const auto bytes = [](const Json &color) {
        return glm::make_vec4(color.get<std::array<std::uint8_t, 4>>().data());
    };
    const auto places = json.at("positions").get<std::vector<std::array<float, 3>>>();
    Mesh mesh = colored({}, bytes(json.at("color")));
    for (const auto &triangle : json.at("triangles").get<std::vector<std::array<std::size_t, 3>>>()) {
        const auto corner = [&](std::size_t i) { return glm::make_vec3(places.at(triangle[i]).data()); };
        const glm::vec3 normal = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
        for (std::size_t i = 0; i < 3; ++i) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.positions.push_back(corner(i));
            mesh.normals.push_back(normal);
            if (json.contains("colors"))
                mesh.colors.push_back(bytes(json["colors"].at(triangle[i])));
        }
    }
    return mesh;
}

std::shared_ptr<const Model> modelOf(std::string name, std::vector<Mesh> meshes)
{
    auto model = std::make_shared<Model>();
    model->name = std::move(name);
    model->meshes = std::move(meshes);
    model->bounds = boundsOf(model->meshes);
    return model;
}

} // namespace

const std::map<std::string, std::shared_ptr<const Model>> &bundledModels()
{
    static const auto models = [] {
        std::map<std::string, std::shared_ptr<const Model>> built;
        const auto add = [&built](const std::string &name, std::vector<Mesh> meshes) {
            built[name] = modelOf(name, std::move(meshes));
        };
        for (SceneObject &object : bundledScene())
            built[object.name] = std::move(object.model);
        Mesh head = headMesh();
        head.baseColor = {0.85f, 0.75f, 0.67f, 1.0f};
        add("Head", {std::move(head)});
        add("Cube of side 10", {coloredCube(10.0)});
        for (const char *name : {"Cube at 5", "Cube at 11", "Cube at 19"})
            add(name, {coloredCube(1.4)});
        const Json flat = Json::parse(base::resource("examples/models.json"));
        for (const auto &[name, meshes] : flat.items()) {
            std::vector<Mesh> all;
            std::transform(meshes.begin(), meshes.end(), std::back_inserter(all), flatMesh);
            add(name, std::move(all));
        }
        return built;
    }();
    return models;
}

std::vector<SceneObject> bundledScene()
{
    constexpr double kEdge = 1.8, kRing = 1.0, kTube = 0.36, kBall = 0.7, kConeHeight = 3.6;
    constexpr glm::dvec3 kUp{0.0, 1.0, 0.0};
    std::vector<SceneObject> objects;
    const auto add = [&objects](const char *name, Mesh mesh, std::vector<TransformStep> transform) {
        objects.push_back({name, {}, modelOf(name, {std::move(mesh)}), std::move(transform)});
    };
    add("Teapot", colored(utahTeapotMesh(), kClay), {Translate{{-0.3, 0.0, 0.7}}, Scale{glm::dvec3(0.8)}});
    add("Cube", coloredCube(kEdge), {Translate{{3.2, kEdge / 2.0, -2.4}}, Rotate{-20.0, kUp}});
    add("Torus", coloredTorus(kRing, kTube), {Translate{{-4.2, kRing + kTube, -0.7}}, Rotate{30.0, kUp}});
    add("Ball", coloredBall(kBall), {Translate{{2.8, kBall, 2.7}}});
    add("Cone", colored(coneMesh(1.2, kConeHeight, 96), kGreen), {Translate{{-1.9, kConeHeight / 2.0, -5.6}}});
    return objects;
}

std::string_view exampleScene(std::string_view id)
{
    const bool isKnown = std::find(kExamples.begin(), kExamples.end(), id) != kExamples.end();
    return isKnown ? base::resource("examples/" + std::string(id) + ".json") : std::string_view();
}

} // namespace unprojector::examples
