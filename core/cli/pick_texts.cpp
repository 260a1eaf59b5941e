#include "core/cli/pick_texts.h"

#include "core/scene_file/json_text.h"
#include "core/scene_file/ray_on_mesh.h"
#include "core/text/number_text.h"

namespace unprojector::cli {
using namespace geometry;
using namespace ray;
using namespace scene_file;
using namespace text;
namespace {

std::string spaced(const glm::dvec3 &v)
{
    return shortestText(v.x) + ' ' + shortestText(v.y) + ' ' + shortestText(v.z);
}

} // namespace

std::string pickJson(const DevicePoint &position, const std::optional<SceneHit> &hit, const std::string &name)
{
    nlohmann::ordered_json json;
    json["pixel"] = nlohmann::ordered_json::array({jsonNumber(position.x), jsonNumber(position.y)});
    json.update(jsonOf(RayOnMesh{hit, name}));
    return jsonLine(json) + '\n';
}

std::string pickText(const DevicePoint &position, const std::optional<SceneHit> &hit, const std::string &name)
{
    std::string text = "pixel " + shortestText(position.x) + ' ' + shortestText(position.y) + '\n';
    if (!hit)
        return text + "  nothing is met\n";
    text += "  object       " + name + '\n';
    if (hit->triangle)
        text += "  triangle     " + std::to_string(hit->triangle->triangle) + ", at "
                + spaced(hit->triangle->barycentric) + '\n';
    text += "  world        " + spaced(hit->world.coordinates()) + '\n';
    text += "  +-           " + spaced(hit->uncertainty.coordinates()) + '\n';
    text += "  object point " + spaced(hit->objectPoint.coordinates()) + '\n';
    if (hit->triangle)
        text += "  normal       " + spaced(hit->triangle->normal.coordinates()) + '\n';
    text += "  distance     " + shortestText(hit->distance) + '\n';
    text += "  vertex       " + std::to_string(hit->vertex.id) + " at " + spaced(hit->vertex.world.coordinates()) + ", "
            + shortestText(hit->vertex.distance) + " away\n";
    if (hit->triangle) {
        const NearEdge &edge = hit->triangle->edge;
        text += "  edge         " + std::to_string(edge.ids[0]) + " to " + std::to_string(edge.ids[1]) + ", at "
                + spaced(edge.world.coordinates()) + ", " + shortestText(edge.distance) + " away\n";
    }
    return text;
}

std::vector<std::string> pickColumns()
{
    return {"x",        "y",        "z",         "object",   "triangle", "u",        "v",
            "w",        "object_x", "object_y",  "object_z", "normal_x", "normal_y", "normal_z",
            "distance", "vertex",   "edge_from", "edge_to",  "dx",       "dy",       "dz"};
}

void writePick(RowWriter &writer, const std::optional<SceneHit> &hit, const std::string &name)
{
    const auto three = [&writer](const glm::dvec3 &v) {
        for (int k = 0; k < 3; ++k)
            writer.numberOrNothing(v[k]);
    };
    const auto nothing = [&writer](std::size_t cells) {
        for (std::size_t k = 0; k < cells; ++k)
            writer.nothing();
    };
    if (!hit)
        return nothing(pickColumns().size());
    three(hit->world.coordinates());
    writer.text(name);
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
}

} // namespace unprojector::cli
