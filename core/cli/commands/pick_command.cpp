#include "core/cli/commands/pick_command.h"

#include "core/base/parallel.h"
#include "core/base/translation.h"
#include "core/cli/commands/opened_scene.h"
#include "core/cli/commands/pick_texts.h"
#include "core/cli/rows/block_pipeline.h"
#include "core/cli/rows/number_table.h"
#include "core/cli/rows/row_layout.h"
#include "core/geometry/error_text.h"

#include <atomic>
#include <charconv>
#include <cmath>
#include <utility>

namespace unprojector::cli {
using namespace geometry;
using namespace unproject;
using namespace ray;
using namespace base;
namespace {

const ColumnNames kPositionColumns{"px", "py", ""};

/// Parses "X,Y"; prints errors on stderr.
std::optional<DevicePoint> positionGiven(const std::string &text)
{
    DevicePoint position;
    const char *end = text.data() + text.size();
    const auto x = std::from_chars(text.data(), end, position.x);
    const bool hasComma = x.ec == std::errc{} && x.ptr != end && *x.ptr == ',';
    const auto y = std::from_chars(hasComma ? x.ptr + 1 : end, end, position.y);
    if (hasComma && y.ec == std::errc{} && y.ptr == end && std::isfinite(position.x) && std::isfinite(position.y))
        return position;
    complain(tr("--at %1: give device pixels from the top left corner, as in 400.5,300.5", text));
    return std::nullopt;
}

/// The hit at a position, with its names and the edge in its pixel.
/// @param hasEdge  whether to search for the edge: it takes a hundred times as long as the ray
scene_file::RayOnMesh withEdge(const SceneRays &rays, const DevicePoint &position, const std::optional<SceneHit> &hit,
                               bool hasEdge, const OpenedScene &opened)
{
    const auto nameOf = [&](std::size_t object) { return opened.objects[object].name; };
    scene_file::RayOnMesh ray{hit, hit ? nameOf(hit->object) : std::string()};
    if (hasEdge && rays.rays().isInPicture(position) && (!hit || hit->triangle)) {
        const DevicePixel pixel{static_cast<int>(std::floor(position.x)), static_cast<int>(std::floor(position.y))};
        ray.edge = edgeInPixel(rays, pixelCenter(pixel), hit);
    }
    if (ray.edge && ray.edge->object)
        ray.edgeObject = nameOf(*ray.edge->object);
    return ray;
}

/// The data shared by all rows.
struct Task {
    const PickOptions &options;
    const OpenedScene &opened;
    const SceneRays &rays;
    NumberReader reader;
    RowLayout layout;
    std::atomic<std::size_t> &outside; ///< number of rows whose pixels have no ray
};

/// The viewport, for the message about a position outside it.
std::string viewportText(const Setup &setup)
{
    return tr("the viewport of the view of %1x%2", shortestText(setup.surface.widthPixels),
              shortestText(setup.surface.heightPixels));
}

/// The scratch memory of a thread.
class Worker {
public:
    explicit Worker(const Task &task) : m_task(task) {}

    void operator()(const LineBlock &block, BlockResult &result)
    {
        m_task.reader.read(block, m_rows, result.messages);
        RowWriter writer(m_task.options.format, m_task.layout.names(), result.output);
        result.badRows = m_rows.bad.size();
        auto bad = m_rows.bad.begin();
        for (std::size_t i = 0; i < m_rows.count(); ++i) {
            if (bad != m_rows.bad.end() && *bad == i) {
                m_task.layout.writeBad(writer, block, m_rows, *bad++);
                writePick(writer, {}, m_task.options.hasEdges);
            } else {
                m_task.layout.writeInput(writer, block, m_rows, i);
                pick(i, block, writer, result);
            }
            writer.endRow();
        }
    }

private:
    void pick(std::size_t row, const LineBlock &block, RowWriter &writer, BlockResult &result)
    {
        const DevicePoint position(m_rows.values[0][row], m_rows.values[1][row]);
        if (!m_task.rays.rays().isInPicture(position))
            ++m_task.outside;
        const Result<std::optional<SceneHit>> hit = m_task.rays.at(position, m_task.options.snap);
        if (!hit) {
            ++result.badRows;
            m_task.reader.complainOf(block, m_rows.places[row], NumberReader::kNoColumn, errorText(hit.error()),
                                     result.messages);
        }
        const bool hasEdges = m_task.options.hasEdges;
        writePick(writer,
                  hit ? withEdge(m_task.rays, position, *hit, hasEdges, m_task.opened) : scene_file::RayOnMesh{},
                  hasEdges);
    }

    const Task &m_task;
    NumberRows m_rows;
};

ExitCode pickRows(const PickOptions &options, const OpenedScene &opened, const SceneRays &rays, ByteSink &sink)
{
    ByteSource source(options.input);
    if (!source.isOpen())
        return ExitCode::UnusableInput;
    LineBlocks blocks(source);
    const std::optional<NumberColumns> columns = readHeader(blocks, source, {kPositionColumns});
    if (!columns)
        return ExitCode::UnusableInput;
    std::atomic<std::size_t> outside = 0;
    const Task task{options,
                    opened,
                    rays,
                    NumberReader(source.name(), *columns),
                    RowLayout(*columns, pickColumns(options.hasEdges), options.format),
                    outside};
    if (!options.isHeaderless) {
        std::string header;
        RowWriter(options.format, task.layout.names(), header).header();
        sink.write(header);
    }
    const unsigned threads = options.threads > 0 ? options.threads : base::coreCount();
    ExitCode code = runBlocks(blocks, source, sink, threads, [&] { return BlockWorker(Worker(task)); });
    if (outside > 0 && code == ExitCode::Done)
        code = ExitCode::SomeRowsBad;
    // Empty cells alone would look like background.
    if (outside > 0)
        complain(
            source.name() + ": "
            + tr(outside == 1 ? "%1 pixel lies outside %2 and has no hit" : "%1 pixels lie outside %2 and have no hit",
                 outside.load(), viewportText(rays.rays().setup())));
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
        const scene_file::RayOnMesh ray = withEdge(rays, position, *hit, !isVertex, opened);
        if (options.isJson)
            sink.write(pickJson(position, ray));
        else
            sink.print(pickText(position, options.snap, ray, opened.objects));
    }
    const ExitCode written = sink.finish();
    return written == ExitCode::Done ? code : written;
}

} // namespace

ExitCode runPick(const PickOptions &options)
{
    std::vector<DevicePoint> positions;
    for (const std::string &text : options.positions) {
        const std::optional<DevicePoint> position = positionGiven(text);
        if (!position)
            return ExitCode::UnusableInput;
        positions.push_back(*position);
    }
    if (positions.empty() && options.scene == "-" && options.input == "-") {
        complain(tr("the scene and the pixels cannot both come from standard input; give a file for one of them"));
        return ExitCode::UnusableInput;
    }
    const std::optional<OpenedScene> opened = openScene(options.scene);
    if (!opened)
        return ExitCode::UnusableInput;
    if (!areReachable(*opened))
        return ExitCode::UnusableInput;
    InputFiles inputs = opened->files;
    if (positions.empty())
        inputs.push_back(options.input);
    // Output appended to the input would be read as input, endlessly.
    ByteSink sink("-", inputs);
    if (!sink.isOpen())
        return ExitCode::UnusableInput;
    const std::optional<Setup> setup = setupOf(*opened, options.size);
    if (!setup)
        return ExitCode::UnusableInput;
    const Result<Unprojector> unprojector = Unprojector::of(*setup);
    if (!unprojector) {
        complain(opened->name + ": " + errorText(unprojector.error()));
        return ExitCode::UnusableInput;
    }
    if (opened->objects.empty())
        complain(tr("%1: the scene has no objects; rays will hit nothing", opened->name));
    const SceneRays rays = raysOf(*opened, *unprojector);
    return positions.empty() ? pickRows(options, *opened, rays, sink)
                             : pickPositions(options, positions, *opened, rays, sink);
}

} // namespace unprojector::cli
