#include "gui/document/landmark_views.h"

#include "core/ray/element_numbers.h"
#include "gui/document/camera_looks.h"
#include "gui/document/scene_document.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace unprojector::gui {
using namespace geometry;
using namespace mesh;
using namespace scene;

namespace {

using landmarks::Landmark;

/// The normal of a triangle, twice its area long; object space.
glm::dvec3 areaOf(const Mesh &mesh, std::size_t triangle)
{
    const auto corner = [&](std::size_t k) { return mesh.fromOrigin(mesh.vertexAt(3 * triangle + k)); };
    return glm::cross(corner(1) - corner(0), corner(2) - corner(0));
}

/// The sum over the triangles that have all of these vertices, compared by position: a mesh may
/// repeat a position.
glm::dvec3 areasAbout(const Model &model, const std::vector<glm::dvec3> &places)
{
    glm::dvec3 sum(0.0);
    for (const Mesh &mesh : model.meshes) {
        for (std::size_t i = 0; i < mesh.triangleCount(); ++i) {
            const auto isCorner = [&](const glm::dvec3 &place) {
                for (std::size_t k = 0; k < 3; ++k) {
                    if (mesh.position(mesh.vertexAt(3 * i + k)) == place)
                        return true;
                }
                return false;
            };
            if (std::all_of(places.begin(), places.end(), isCorner))
                sum += areaOf(mesh, i);
        }
    }
    return sum;
}

std::optional<glm::dvec3> vertexAt(const Model &model, std::uint32_t number)
{
    const std::optional<Model::VertexPlace> place = model.vertexOf(number);
    return place ? std::optional(model.meshes[place->mesh].position(place->vertex)) : std::nullopt;
}

glm::dvec3 objectNormal(const landmarks::Anchor &anchor, const Model &model)
{
    if (const auto *held = std::get_if<landmarks::OnTriangle>(&anchor)) {
        const ray::ElementNumbers triangles(model.meshes, [](const Mesh &mesh) { return mesh.triangleCount(); });
        if (held->triangle >= triangles.count())
            return glm::dvec3(0.0);
        const auto place = triangles.place(held->triangle);
        return areaOf(model.meshes[place.mesh], place.element);
    }
    std::vector<glm::dvec3> places;
    if (const auto *held = std::get_if<landmarks::AtVertex>(&anchor)) {
        if (const auto place = vertexAt(model, held->vertex))
            places.push_back(*place);
    } else if (const auto *edge = std::get_if<landmarks::OnEdge>(&anchor)) {
        for (const std::uint32_t vertex : edge->vertices) {
            if (const auto place = vertexAt(model, vertex))
                places.push_back(*place);
        }
    }
    return places.empty() ? glm::dvec3(0.0) : areasAbout(model, places);
}

const Landmark *placedLandmark(const SceneDocument &document, std::size_t index)
{
    const std::vector<Landmark> &landmarks = document.landmarks();
    return index < landmarks.size() && landmarks[index].isPlaced() ? &landmarks[index] : nullptr;
}

} // namespace

std::optional<WorldVector> normalAt(const landmarks::Anchor &anchor, const SceneObject &object)
{
    const glm::dvec3 normal = objectNormal(anchor, *object.model);
    const double size = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    if (!(size > 0.0))
        return std::nullopt;
    const glm::dmat3 worldFromNormal = glm::inverse(glm::transpose(glm::dmat3(worldFromObject(object.transform))));
    return WorldVector(glm::normalize(worldFromNormal * (normal / size)));
}

std::optional<WorldVector> normalAround(const ObjectPoint &point, const landmarks::Anchor &there,
                                        const SceneObject &object)
{
    constexpr double kShareOfSize = 0.1;
    const Model &model = *object.model;
    const double size = model.bounds.diagonal();
    const glm::dvec3 facing = objectNormal(there, model);
    if (!(size > 0.0) || facing == glm::dvec3(0.0))
        return normalAt(there, object);
    glm::dvec3 sum(0.0); // of shares of the size, so that products stay in range
    for (const Mesh &mesh : model.meshes) {
        for (std::size_t triangle = 0; triangle < mesh.triangleCount(); ++triangle) {
            std::array<glm::dvec3, 3> corners;
            for (std::size_t i = 0; i < corners.size(); ++i)
                corners[i] = (mesh.position(mesh.vertexAt(3 * triangle + i)) - point.coordinates()) / size;
            if (glm::length(corners[0] + corners[1] + corners[2]) > 3.0 * kShareOfSize)
                continue;
            const glm::dvec3 area = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
            if (glm::dot(area, facing) > 0.0)
                sum += area;
        }
    }
    const double length = glm::length(sum);
    if (!(length > 0.0))
        return normalAt(there, object);
    const glm::dmat3 worldFromNormal = glm::inverse(glm::transpose(glm::dmat3(worldFromObject(object.transform))));
    return WorldVector(glm::normalize(worldFromNormal * (sum / length)));
}

void faceSurface(SceneDocument &document, const WorldPoint &point, const std::optional<WorldVector> &normal)
{
    const LookAt now = document.scene().camera;
    const double away = distance(now.center, now.eye);
    const WorldVector back = normal.value_or(normalized(now.eye - now.center));
    LookAt there{point + back * away, point, now.up};
    // Looking along "up" there is no side: the view's present up direction is kept.
    constexpr double kParallel = 0.999;
    if (std::abs(dot(normalized(there.up), back)) > kParallel) {
        const Result<EyeFrame> frame = eyeFrame(now);
        if (frame && std::abs(dot(frame->upward, back)) < kParallel)
            there.up = frame->upward;
        else if (frame)
            there.up = frame->side;
    }
    setCamera(document, there);
}

void goToLandmark(SceneDocument &document, std::size_t index)
{
    const Landmark *landmark = placedLandmark(document, index);
    if (!landmark)
        return;
    const auto object = std::find_if(document.objects().begin(), document.objects().end(),
                                     [&](const SceneObject &o) { return o.name == landmark->object; });
    faceSurface(document, *landmark->world,
                object != document.objects().end() ? normalAt(landmark->anchor, *object) : std::nullopt);
}

void zoomToLandmark(SceneDocument &document, std::size_t index, double half)
{
    const Landmark *landmark = placedLandmark(document, index);
    if (!landmark || !(half > 0.0))
        return;
    const WorldPoint world = *landmark->world;
    Setup setup = document.setup();
    setup.camera() = recentered(setup, world);
    const double pixel = worldPerLogicalPixel(setup, world) / setup.surface.devicePixelRatio;
    setup = zoomed(setup, world, pixel / 2.0 / half);
    setView(document, setup.camera(), setup.projection());
}

} // namespace unprojector::gui
