#include "core/base/json.h"
#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/cli/commands/command.h"
#include "core/cli/commands/inputs.h"
#include "core/cli/rows/row_table.h"
#include "core/cli/terminal/exit_code.h"
#include "core/cli/terminal/refusal.h"
#include "core/ray/scene_rays.h"
#include "core/ray/snap.h"
#include "core/report/report.h"
#include "core/scene/measures.h"
#include "core/scene_file/ray_on_mesh.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace unprojector::cli {
using namespace geometry;
using namespace unproject;
using namespace ray;
using namespace base;
using namespace mesh;
using namespace scene;
using scene_file::RayOnMesh;
namespace {

struct PickOptions {
    RowOptions rows; ///< scene: a model, a scene or clicks; input: positions, read if `positions` is empty
    std::vector<std::string> positions; ///< "X,Y", device pixels
    std::string size;                   ///< size of the view, "WxH"; empty: its own
    Snap snap = Snap::Surface;
    bool hasEdges = false; ///< adds columns with the edge inside each pixel, for rows
    bool isJson = false;   ///< for `positions`
};

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

/// A pick as one JSON object on one line.
std::string pickJson(const DevicePoint &position, const RayOnMesh &ray)
{
    nlohmann::ordered_json json;
    json["pixel"] = nlohmann::ordered_json::array({jsonNumber(position.x), jsonNumber(position.y)});
    json.update(jsonOf(ray));
    return jsonLine(json) + '\n';
}

/// A pick with significant digits only. A vertex has as many digits as
/// identify its floats; a computed coordinate has digits to a tenth of its ±.
report::Section pickSection(const DevicePoint &position, Snap snap, const RayOnMesh &ray,
                            const std::vector<SceneObject> &objects)
{
    const std::optional<SceneHit> &hit = ray.hit;
    report::Rows rows{13};
    const auto addEdge = [&] {
        if (!ray.edge)
            return;
        const std::string away = shortestText(std::abs(ray.edge->behind), 0.01 * std::abs(ray.edge->behind));
        rows.add(tr("pixel edge"), !hit                     ? tr("beside it lies %1", ray.edgeObject)
                                   : !ray.edge->object      ? tr("beside it is the background")
                                   : ray.edge->behind < 0.0 ? tr("%1 before it lies %2", away, ray.edgeObject)
                                                            : tr("%1 behind it lies %2", away, ray.edgeObject));
    };
    report::Section section{tr("pixel %1 %2", shortestText(position.x), shortestText(position.y))};
    if (!hit) {
        addEdge();
        section.blocks = {report::Paragraph{nothingText(snap)}, rows};
        return section;
    }
    const SceneObject &object = objects[hit->object];
    const auto rounded = [](const WorldPoint &point, const WorldVector &uncertainty) {
        return spaced(point.coordinates(), kLeftOut * uncertainty.coordinates());
    };
    const auto distanceText = [&hit](double distance) {
        return shortestText(distance, kLeftOut * length(hit->uncertainty));
    };
    rows.add(tr("object|row"), object.name);
    if (hit->triangle)
        rows.add(tr("triangle|row"), tr("%1, at %2", hit->triangle->triangle, spaced(hit->triangle->barycentric)));
    rows.add(tr("world|row"), rounded(hit->world, hit->uncertainty));
    rows.add("+-", boundsText(hit->uncertainty));
    rows.add(tr("object point"),
             spaced(hit->objectPoint.coordinates(), kLeftOut * objectBounds(object, hit->uncertainty)));
    if (hit->triangle)
        rows.add(tr("normal|row"), spaced(hit->triangle->normal.coordinates()));
    rows.add(tr("distance|row"), distanceText(hit->distance));
    rows.add(tr("vertex|row"), tr("%1 at %2, %3 away", hit->vertex.id,
                                  spaced(hit->vertex.world.coordinates(), halfGapOf(object, hit->vertex.id)),
                                  distanceText(hit->vertex.distance)));
    if (hit->triangle) {
        const NearEdge &edge = hit->triangle->edge;
        rows.add(tr("edge|row"), tr("%1 to %2, at %3, %4 away", edge.ids[0], edge.ids[1],
                                    rounded(edge.world, edge.uncertainty), distanceText(edge.distance)));
    }
    addEdge();
    section.blocks = {rows};
    return section;
}

/// The columns of a pick in a table.
/// @param hasEdges  with the edge inside the pixel
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

/// Writes the cells of a pick. The cells of the hit are empty where nothing was hit, those of the
/// edge where there is none.
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
    const auto name = [&writer](std::string object) {
        if (!writer.isJson()) // a row is a line, which other programs count and cut
            std::replace_if(
                object.begin(), object.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
        writer.text(object);
    };
    const auto writeEdge = [&] {
        if (!hasEdges)
            return;
        if (!ray.edge)
            return nothing(3);
        writer.number(1);
        if (!ray.edge->object)
            return nothing(2);
        name(ray.edgeObject);
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
    name(ray.object);
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

/// Parses "X,Y".
DevicePoint positionGiven(const std::string &text)
{
    const std::size_t comma = std::min(text.find(','), text.size());
    const auto x = finiteNumberIn(text.substr(0, comma)),
               y = finiteNumberIn(text.substr(std::min(comma + 1, text.size())));
    if (!x || !y)
        refuse(tr("--at %1: give device pixels from the top left corner, as in 400.5,300.5", text));
    return {*x, *y};
}

/// The hit at a position, with its names and the edge in its pixel.
/// @param hasEdge  whether to search for the edge: it takes a hundred times as long as the ray
RayOnMesh withEdge(const SceneRays &rays, const DevicePoint &position, const std::optional<SceneHit> &hit, bool hasEdge,
                   const OpenedScene &opened)
{
    const auto nameOf = [&](std::size_t object) { return opened.objects[object].name; };
    RayOnMesh ray{hit, hit ? nameOf(hit->object) : std::string()};
    if (hasEdge && rays.rays().isInPicture(position) && (!hit || hit->triangle)) {
        const DevicePixel pixel{static_cast<int>(std::floor(position.x)), static_cast<int>(std::floor(position.y))};
        ray.edge = edgeInPixel(rays, pixelCenter(pixel), hit);
    }
    if (ray.edge && ray.edge->object)
        ray.edgeObject = nameOf(*ray.edge->object);
    return ray;
}

/// The viewport, for the message about a position outside it.
std::string viewportText(const Setup &setup)
{
    return tr("the viewport of the view of %1x%2", shortestText(setup.surface.widthPixels),
              shortestText(setup.surface.heightPixels));
}

ExitCode pickRows(const PickOptions &options, const OpenedScene &opened, const SceneRays &rays, ByteSink &sink)
{
    RowTable rows(options.rows, {{"px", "py", ""}}, pickColumns(options.hasEdges));
    std::atomic<std::size_t> outside = 0; // rows whose pixels have no ray
    const auto write = [&](const glm::dvec3 &row, RowWriter &writer) {
        const DevicePoint position(row.x, row.y);
        if (!rays.rays().isInPicture(position))
            ++outside;
        const Result<std::optional<SceneHit>> hit = rays.at(position, options.snap);
        writePick(writer, hit ? withEdge(rays, position, *hit, options.hasEdges, opened) : RayOnMesh{},
                  options.hasEdges);
        return hit ? std::string() : errorText(hit.error());
    };
    ExitCode code = rows.runEach(sink, write);
    if (outside > 0) { // empty cells alone would look like background
        code = std::max(code, ExitCode::SomeRowsBad);
        complain(
            rows.name() + ": "
            + tr(outside == 1 ? "%1 pixel lies outside %2 and has no hit" : "%1 pixels lie outside %2 and have no hit",
                 outside.load(), viewportText(rays.rays().setup())));
    }
    return code;
}

ExitCode pickPositions(const PickOptions &options, const std::vector<DevicePoint> &positions, const OpenedScene &opened,
                       const SceneRays &rays, ByteSink &sink)
{
    ExitCode code = ExitCode::Done;
    const Setup &setup = rays.rays().setup();
    for (const DevicePoint &position : positions) {
        // No ray exists there; the message shows a wrong size.
        if (!rays.rays().isInPicture(position)) {
            complain(tr("--at %1,%2: lies outside %3", shortestText(position.x), shortestText(position.y),
                        viewportText(setup)));
            code = ExitCode::SomeRowsBad;
        }
        const Result<std::optional<SceneHit>> hit = rays.at(position, options.snap);
        if (!hit) {
            complain("--at " + shortestText(position.x) + ',' + shortestText(position.y) + ": "
                     + errorText(hit.error()));
            code = ExitCode::SomeRowsBad;
            continue;
        }
        const bool isVertex = options.snap == Snap::Vertex; // the file defines its coordinate
        const RayOnMesh ray = withEdge(rays, position, *hit, !isVertex, opened);
        if (options.isJson)
            sink.write(pickJson(position, ray));
        else
            sink.print(report::asText({pickSection(position, options.snap, ray, opened.objects)}));
    }
    return std::max(sink.finish(), code);
}

ExitCode runPick(const PickOptions &options)
{
    std::vector<DevicePoint> positions;
    for (const std::string &text : options.positions)
        positions.push_back(positionGiven(text));
    if (positions.empty() && options.rows.scene == "-" && options.rows.input == "-")
        refuse(tr("the scene and the pixels cannot both come from standard input; give a file for one of them"));
    const OpenedScene opened = openScene(options.rows.scene);
    checkReach(opened);
    InputFiles inputs = opened.files;
    if (positions.empty())
        inputs.push_back(options.rows.input);
    // Output appended to the input would be read as input, endlessly.
    ByteSink sink("-", inputs);
    const Unprojector unprojector = needed(Unprojector::of(setupOf(opened, options.size)), opened.name);
    if (opened.objects.empty())
        complain(tr("%1: the scene has no objects; rays will hit nothing", opened.name));
    const SceneRays rays = raysOf(opened, unprojector);
    return positions.empty() ? pickRows(options, opened, rays, sink)
                             : pickPositions(options, positions, opened, rays, sink);
}

} // namespace

void addPick(const Command &command)
{
    const auto options = std::make_shared<PickOptions>();
    options->rows.threads = 0;
    command.modelOrScene(options->rows.scene);
    CLI::Option *input = command.file("PIXELS", options->rows.input);
    CLI::Option *at = command.add("--at", options->positions)->allow_extra_args(false)->excludes(input);
    command.add("--size", options->size);
    command.choice("--snap", options->snap,
                   {{"surface", Snap::Surface}, {"vertex", Snap::Vertex}, {"edge", Snap::Edge}, {"face", Snap::Face}});
    command.flag("--edges", options->hasEdges)->excludes(at);
    command.flag("--json", options->isJson)->needs(at);
    for (CLI::Option *option : command.table(options->rows))
        option->excludes(at);
    command.count("--threads", options->rows.threads, 64);
    command.runs(options, runPick);
}

} // namespace unprojector::cli
