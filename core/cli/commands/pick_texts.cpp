#include "core/cli/commands/pick_texts.h"

#include "core/base/columns.h"
#include "core/base/number_text.h"
#include "core/base/printable.h"
#include "core/base/translation.h"
#include "core/ray/snap.h"
#include "core/scene/measures.h"
#include "core/scene_file/json_text.h"
#include "core/scene_file/ray_on_mesh.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

namespace unprojector::cli {
using namespace mesh;
using namespace geometry;
using namespace ray;
using namespace scene;
using namespace scene_file;
using namespace base;
namespace {

std::string spaced(const glm::dvec3 &v, const glm::dvec3 &off = glm::dvec3(0.0))
{
    return shortestText(v.x, off.x) + ' ' + shortestText(v.y, off.y) + ' ' + shortestText(v.z, off.z);
}

/// The share of the uncertainty that may be lost by dropping digits.
constexpr double kLeftOut = 0.1;

std::string boundsText(const WorldVector &uncertainty)
{
    const auto withWhatIsLeftOut = [](double bound) { return boundText((1.0 + kLeftOut) * bound); };
    return withWhatIsLeftOut(uncertainty.x) + ' ' + withWhatIsLeftOut(uncertainty.y) + ' '
           + withWhatIsLeftOut(uncertainty.z);
}

/// @param vertex  vertex number in the file
glm::dvec3 halfGapOf(const SceneObject &object, std::uint32_t vertex)
{
    const Model::VertexPlace place = object.model->vertexOf(vertex).value();
    return halfGapAt(object.model->meshes[place.mesh], place.vertex, glm::dmat3(worldFromObject(object.transform)));
}

/// The uncertainty of an object's own coordinates.
glm::dvec3 objectBounds(const SceneObject &object, const WorldVector &uncertainty)
{
    const glm::dmat3 objectFromWorld = glm::inverse(glm::dmat3(worldFromObject(object.transform)));
    glm::dvec3 bounds(0.0);
    for (int axis = 0; axis < 3; ++axis)
        bounds += glm::abs(objectFromWorld[axis]) * uncertainty[axis];
    return bounds;
}

} // namespace

std::string pickJson(const DevicePoint &position, const RayOnMesh &ray)
{
    nlohmann::ordered_json json;
    json["pixel"] = nlohmann::ordered_json::array({jsonNumber(position.x), jsonNumber(position.y)});
    json.update(jsonOf(ray));
    return jsonLine(json) + '\n';
}

std::string pickText(const DevicePoint &position, Snap snap, const RayOnMesh &ray,
                     const std::vector<SceneObject> &objects)
{
    const std::optional<SceneHit> &hit = ray.hit;
    std::string text = tr("pixel %1 %2", shortestText(position.x), shortestText(position.y)) + '\n';
    const auto add = [&text](const std::string &name, const std::string &value) {
        text += "  " + padded(name, 13) + value + '\n';
    };
    const auto addEdge = [&] {
        if (!ray.edge)
            return;
        const std::string object = printableLine(ray.edgeObject);
        const std::string away = shortestText(std::abs(ray.edge->behind), 0.01 * std::abs(ray.edge->behind));
        add(tr("pixel edge"), !hit                     ? tr("beside it lies %1", object)
                              : !ray.edge->object      ? tr("beside it is the background")
                              : ray.edge->behind < 0.0 ? tr("%1 before it lies %2", away, object)
                                                       : tr("%1 behind it lies %2", away, object));
    };
    if (!hit) {
        text += "  " + nothingText(snap) + '\n';
        addEdge();
        return text;
    }
    const SceneObject &object = objects[hit->object];
    const auto rounded = [](const WorldPoint &point, const WorldVector &uncertainty) {
        return spaced(point.coordinates(), kLeftOut * uncertainty.coordinates());
    };
    const auto distanceText = [&hit](double distance) {
        return shortestText(distance, kLeftOut * length(hit->uncertainty));
    };
    add(tr("object|row"), printableLine(object.name));
    if (hit->triangle)
        add(tr("triangle|row"), tr("%1, at %2", hit->triangle->triangle, spaced(hit->triangle->barycentric)));
    add(tr("world|row"), rounded(hit->world, hit->uncertainty));
    add("+-", boundsText(hit->uncertainty));
    add(tr("object point"), spaced(hit->objectPoint.coordinates(), kLeftOut * objectBounds(object, hit->uncertainty)));
    if (hit->triangle)
        add(tr("normal|row"), spaced(hit->triangle->normal.coordinates()));
    add(tr("distance|row"), distanceText(hit->distance));
    add(tr("vertex|row"), tr("%1 at %2, %3 away", hit->vertex.id,
                             spaced(hit->vertex.world.coordinates(), halfGapOf(object, hit->vertex.id)),
                             distanceText(hit->vertex.distance)));
    if (hit->triangle) {
        const NearEdge &edge = hit->triangle->edge;
        add(tr("edge|row"), tr("%1 to %2, at %3, %4 away", edge.ids[0], edge.ids[1],
                               rounded(edge.world, edge.uncertainty), distanceText(edge.distance)));
    }
    addEdge();
    return text;
}

std::vector<std::string> pickColumns(bool hasEdges)
{
    std::vector<std::string> columns{"x",        "y",        "z",        "object",   "triangle",  "u",
                                     "v",        "w",        "object_x", "object_y", "object_z",  "normal_x",
                                     "normal_y", "normal_z", "distance", "vertex",   "edge_from", "edge_to",
                                     "dx",       "dy",       "dz"};
    if (hasEdges)
        columns.insert(columns.end(), {"pixel_edge", "beyond_edge", "behind"});
    return columns;
}

void writePick(RowWriter &writer, const RayOnMesh &ray, bool hasEdges)
{
    const std::optional<SceneHit> &hit = ray.hit;
    const auto three = [&writer](const glm::dvec3 &v) {
        for (int k = 0; k < 3; ++k)
            writer.numberOrNothing(v[k]);
    };
    const auto nothing = [&writer](std::size_t cells) {
        for (std::size_t k = 0; k < cells; ++k)
            writer.nothing();
    };
    const auto writeEdge = [&] {
        if (!hasEdges)
            return;
        if (!ray.edge)
            return nothing(3);
        writer.number(1);
        if (!ray.edge->object)
            return nothing(2);
        writer.text(ray.edgeObject);
        if (hit)
            writer.numberOrNothing(ray.edge->behind);
        else
            nothing(1);
    };
    if (!hit) {
        nothing(pickColumns(false).size());
        return writeEdge();
    }
    three(hit->world.coordinates());
    writer.text(ray.object);
    if (hit->triangle) {
        writer.number(hit->triangle->triangle);
        three(hit->triangle->barycentric);
    } else {
        nothing(4);
    }
    three(hit->objectPoint.coordinates());
    if (hit->triangle)
        three(hit->triangle->normal.coordinates());
    else
        nothing(3);
    writer.numberOrNothing(hit->distance);
    writer.number(hit->vertex.id);
    if (hit->triangle) {
        for (const std::uint32_t id : hit->triangle->edge.ids)
            writer.number(id);
    } else {
        nothing(2);
    }
    three(hit->uncertainty.coordinates());
    writeEdge();
}

} // namespace unprojector::cli
