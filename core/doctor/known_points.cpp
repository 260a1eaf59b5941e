#include "core/doctor/known_points.h"

#include "core/doctor/ranking.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <optional>
#include <utility>

namespace unprojector::doctor {
using namespace geometry;

namespace {

using Kind = KnownPoint::Kind;

/// The largest unit of a last digit, as a share of the distance from the eye.
constexpr double kCoarsestDigit = 0.25;
/// The tolerance of a coordinate of one digit, in units of it. Its own rounding is what counts there.
constexpr double kRoundedDigit = 0.5 + 1e-6;
/// The least distance of the next vertex, in units of the last digit.
constexpr double kAlone = 5.0;

bool isPoint(const Target &target, const glm::dvec3 &known)
{
    for (int axis = 0; axis < 3; ++axis) {
        // With one digit, truncation would allow numbers a whole unit away: 1 for 1.9.
        const bool mayBeCutOff = digitsOf(target.got[axis], target.writtenDigit[axis]) > 1;
        if (!(unitsOff(target, axis, known) <= (mayBeCutOff ? kCutOff : kRoundedDigit)))
            return false;
    }
    return true;
}

/// The chance that an arbitrary point, as far from a known one as the clicked one is from the eye,
/// equals it in its digits.
double chanceOf(const Target &target)
{
    const double distance = glm::length(target.clicks.front().eye);
    double chance = 1.0;
    for (int axis = 0; axis < 3; ++axis)
        chance *= std::min(1.0, 2.0 * kRounded * target.lastDigit[axis] / distance);
    return chance;
}

bool isFineEnough(const Target &target)
{
    const double distance = glm::length(target.clicks.front().eye);
    return greatestOf(target.lastDigit) <= kCoarsestDigit * distance;
}

/// The fixed points of the scene in the space of a click's point.
std::vector<KnownPoint> fixedPoints(const Given &given, const Case &scene, const Click &click)
{
    const glm::dmat4 spaceFromWorld = glm::inverse(worldFromSpace(given, click));
    std::vector<KnownPoint> all{{Kind::Eye, transformed(spaceFromWorld, given.eyePosition), {}}};
    // This is the world's origin in eye space.
    if (click.space != PointSpace::Eye)
        all.push_back({Kind::ViewTranslation, glm::dvec3(given.eyeFromWorld[3]) / given.eyeFromWorld[3].w, {}});
    if (const auto *camera = std::get_if<LookAt>(&scene.setup.pose))
        all.push_back({Kind::CameraCentre, transformed(spaceFromWorld, camera->center.coordinates()), {}});
    all.push_back({Kind::WorldOrigin, transformed(spaceFromWorld, glm::dvec3(0.0)), {}});
    for (const PlacedModel &model : scene.models) {
        const glm::dvec3 origin = transformed(model.worldFromObject.rounded(), glm::dvec3(0.0));
        all.push_back({Kind::ObjectOrigin, transformed(spaceFromWorld, origin), model.name});
    }
    return all;
}

/// The only vertex that equals a point, in the point's space.
std::optional<KnownPoint> vertexOf(const Given &given, const Case &scene, const Target &target)
{
    const glm::dmat4 worldFromPoint = worldFromSpace(given, target.clicks.front());
    Box box;
    box.add(target.got - kAlone * target.lastDigit);
    box.add(target.got + kAlone * target.lastDigit);
    const glm::dmat4 spaceFromWorld = glm::inverse(worldFromPoint);
    std::optional<KnownPoint> found;
    for (KnownPoint vertex : scene.verticesIn(box.transformed(worldFromPoint))) {
        vertex.point = transformed(spaceFromWorld, vertex.point);
        if (!(greatestOf((vertex.point - target.got) / target.lastDigit) <= kAlone))
            continue;
        if (found && !isSameAnswer(found->point, vertex.point))
            return std::nullopt;
        if (!found)
            found = std::move(vertex);
    }
    return found && isPoint(target, found->point) ? found : std::nullopt;
}

} // namespace

KnownPoints knownPoints(const Given &given, const Case &scene)
{
    KnownPoints known{fixedPoints(given, scene, given.points.front().clicks.front())};
    known.chance = double(known.points.size());
    for (const Target &point : given.points)
        known.chance *= chanceOf(point);
    std::erase_if(known.points, [&](const KnownPoint &one) {
        return !std::all_of(given.points.begin(), given.points.end(),
                            [&](const Target &p) { return isPoint(p, one.point); });
    });
    if (std::any_of(known.points.begin(), known.points.end(),
                    [&](const KnownPoint &one) { return isSameAnswer(given.points.front().got, one.point); }))
        known.chance = 0.0;
    return known;
}

std::vector<KnownPoint> knownVertices(const Given &given, const Case &scene)
{
    if (!scene.verticesIn || !std::all_of(given.points.begin(), given.points.end(), isFineEnough))
        return {};
    std::vector<KnownPoint> vertices;
    for (const Target &target : given.points) {
        std::optional<KnownPoint> vertex = vertexOf(given, scene, target);
        if (!vertex)
            return {};
        vertices.push_back(std::move(*vertex));
    }
    vertices.resize(1);
    return vertices;
}

std::vector<KnownPoint> verticesIn(std::span<const scene::SceneObject> objects, const Box &world)
{
    constexpr std::size_t kMost = 1000;
    std::vector<KnownPoint> found;
    for (const scene::SceneObject &object : objects) {
        if (object.isHidden || !object.model)
            continue;
        const glm::dmat4 worldFromModel = worldFromObject(object.transform);
        for (std::size_t mesh = 0; mesh < object.model->meshes.size(); ++mesh) {
            const mesh::Mesh &own = object.model->meshes[mesh];
            for (std::size_t vertex = 0; vertex < own.positions.size(); ++vertex) {
                const glm::dvec3 at(worldFromModel * glm::dvec4(own.position(vertex), 1.0));
                if (glm::clamp(at, world.lowest, world.highest) != at)
                    continue;
                // Many vertices coincide in a triangle soup.
                if (std::any_of(found.begin(), found.end(), [&at](const KnownPoint &one) { return one.point == at; }))
                    continue;
                if (found.size() == kMost)
                    return found;
                found.push_back({KnownPoint::Kind::Vertex, at, object.name, object.model->vertexNumber(mesh, vertex)});
            }
        }
    }
    return found;
}

} // namespace unprojector::doctor
