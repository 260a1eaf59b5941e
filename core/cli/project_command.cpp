#include "core/cli/project_command.h"

#include "core/cli/block_pipeline.h"
#include "core/cli/core_error_text.h"
#include "core/cli/number_table.h"
#include "core/cli/scene_input.h"

#include <cmath>

namespace unprojector {
namespace {

const std::vector<std::string> kNames{"x",     "y",     "z",        "eye_x",    "eye_y",    "eye_z",    "clip_x",
                                      "clip_y", "clip_z", "clip_w",   "ndc_x",    "ndc_y",    "ndc_z",    "window_x",
                                      "window_y", "window_z", "widget_x", "widget_y", "px", "py", "depth"};

/// Everything that is the same for all rows.
struct Task {
    RowFormat format;
    NumberReader reader;
    PictureGeometry geometry;
    NdcDepth ndcDepth;
    glm::dmat4 eyeFromSource, clipFromEye;
};

/// The cells of a point, as many as there are: behind a stage without an answer there is nothing.
struct Stages {
    std::array<double, 18> numbers{};
    std::size_t count = 0;

    template <class Vector>
    bool add(const Vector &values)
    {
        for (int k = 0; k < values.length(); ++k) {
            if (!std::isfinite(values[k]))
                return false;
        }
        for (int k = 0; k < values.length(); ++k)
            numbers[count++] = values[k];
        return true;
    }
};

/// @return whether every stage has an answer
bool project(const Task &task, const glm::dvec3 &point, Stages &stages)
{
    const PictureGeometry &g = task.geometry;
    const glm::dvec4 eye = task.eyeFromSource * glm::dvec4(point, 1.0);
    const glm::dvec4 clip = task.clipFromEye * eye;
    if (!stages.add(glm::dvec3(eye)) || !stages.add(clip) || clip.w == 0.0)
        return false;
    const NdcPoint ndc(glm::dvec3(clip) / clip.w);
    const WindowPoint window = windowFromNdc(g.viewport, g.depthRange, ndc, task.ndcDepth);
    const DevicePoint device = deviceFromWindow(g.surface, window);
    const WidgetPoint widget = widgetFromDevice(g.surface, device);
    return stages.add(ndc.coordinates()) && stages.add(window.coordinates()) && stages.add(widget.coordinates())
           && stages.add(glm::dvec3(device.coordinates(), window.z));
}

class Worker {
public:
    explicit Worker(const Task &task) : m_task(task) {}

    void operator()(const LineBlock &block, BlockResult &result)
    {
        m_task.reader.read(block, m_rows, result.messages);
        RowWriter writer(m_task.format, kNames, result.output);
        result.badRows = m_rows.bad.size();
        auto bad = m_rows.bad.begin();
        for (std::size_t i = 0; i < m_rows.count(); ++i) {
            Stages stages;
            if (bad != m_rows.bad.end() && bad->row == i) {
                for (const std::string &cell : bad->cells)
                    writer.asWritten(cell);
                ++bad;
            } else {
                for (const auto &column : m_rows.values)
                    writer.number(column[i]);
                if (!project(m_task, {m_rows.values[0][i], m_rows.values[1][i], m_rows.values[2][i]}, stages)) {
                    ++result.badRows;
                    m_task.reader.complainOf(block, m_rows.lines[i], NumberReader::kNoColumn,
                                             "the point has no place in the window: it lies in the plane of the eye, or "
                                             "too far away",
                                             result.messages);
                }
            }
            for (std::size_t k = 0; k < stages.numbers.size(); ++k) {
                if (k < stages.count)
                    writer.number(stages.numbers[k]);
                else
                    writer.nothing();
            }
            writer.endRow();
        }
    }

private:
    const Task &m_task;
    NumberRows m_rows;
};

} // namespace

ExitCode runProject(const ProjectOptions &options)
{
    const std::optional<SceneInput> scene = sceneInput(options.scene);
    if (!scene)
        return ExitCode::UnusableInput;
    const std::optional<BatchSpace> space = batchSpace(options.space, *scene);
    if (!space)
        return ExitCode::UnusableInput;
    if (space->kind == BatchSpace::Kind::Eye) {
        complain("--space eye: give world or object:NAME");
        return ExitCode::UnusableInput;
    }
    const Result<glm::dmat4> view = eyeFromWorld(scene->geometry), projection = clipFromEye(scene->geometry);
    for (const auto *matrix : {&view, &projection}) {
        if (!*matrix) {
            complain(options.scene + ": " + errorText(matrix->error()));
            return ExitCode::UnusableInput;
        }
    }
    ByteSource source(options.input);
    if (!source.isOpen())
        return ExitCode::UnusableInput;
    LineBlocks blocks(source);
    const std::optional<NumberColumns> columns = readHeader(blocks, source, {"x", "y", "z"});
    if (!columns)
        return ExitCode::UnusableInput;

    const Task task{options.format,
                    NumberReader(source.name(), *columns),
                    scene->geometry,
                    ndcDepthOf(scene->geometry),
                    space->kind == BatchSpace::Kind::Object ? *view * space->worldFromObject : *view,
                    *projection};
    ByteSink sink;
    std::string header;
    RowWriter(options.format, kNames, header).header();
    sink.write(header);
    return runBlocks(blocks, source, sink, options.threads, [&] { return BlockWorker(Worker(task)); });
}

} // namespace unprojector
