#include "core/base/translation.h"
#include "core/cameras/lens.h"
#include "core/cli/commands/command.h"
#include "core/cli/commands/inputs.h"
#include "core/cli/commands/refusal.h"
#include "core/cli/rows/row_layout.h"
#include "core/unproject/pixel_projection.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace unprojector::cli {
using namespace geometry;
using namespace scene_file;
using namespace unproject;
using namespace base;
namespace {

const std::vector<std::string> kResults{"eye_x",    "eye_y",    "eye_z",    "clip_x", "clip_y",   "clip_z",
                                        "clip_w",   "ndc_x",    "ndc_y",    "ndc_z",  "window_x", "window_y",
                                        "window_z", "widget_x", "widget_y", "px",     "py",       "depth"};

constexpr std::size_t kPinholeCount = 15; // the columns before px, py and depth

/// The data shared by all rows.
struct Task {
    RowFormat format;
    NumberReader reader;
    RowLayout layout;
    Setup setup;
    PixelProjection projection;
    std::optional<SceneLens> lens;
};

/// The cells of a point. After a stage without an answer the rest is empty.
struct Stages {
    std::array<double, 18> numbers{};
    std::size_t count = 0;

    bool add(std::span<const DoubleDouble> values)
    {
        if (!std::all_of(values.begin(), values.end(), [](const DoubleDouble &v) { return std::isfinite(v.value); }))
            return false;
        for (const DoubleDouble &v : values)
            numbers[count++] = v.value;
        return true;
    }
};

/// Moves a pixel to the distorted image.
/// @return false where the distortion folds the image over: another point has that pixel
bool distort(const SceneLens &lens, DoubleDouble &x, DoubleDouble &y)
{
    const glm::dvec2 pixel(x.value, y.value), moved = cameras::distortedPixel(lens.distortion, lens.pinhole, pixel);
    const auto back = cameras::undistortedPixel(lens.distortion, lens.pinhole, moved);
    constexpr double kSame = 1e-6; // pixels; a fold moves by far more
    if (!back || glm::length(*back - pixel) > kSame * std::max(1.0, glm::length(pixel)))
        return false;
    x = moved.x;
    y = moved.y;
    return true;
}

/// @return whether every stage has an answer
bool project(const Task &task, const glm::dvec3 &point, Stages &stages)
{
    const auto &[way, px, py, depth] = task.projection.at(point);
    if (!stages.add(way.eye) || !stages.add(way.clip) || way.clip[3].value == 0.0)
        return false;
    const DoubleDouble ratio = task.setup.surface.devicePixelRatio;
    DoubleDouble pixelX = px, pixelY = py;
    return stages.add(way.ndc) && stages.add(way.window) && stages.add(std::array{px / ratio, py / ratio})
           && (!task.lens || distort(*task.lens, pixelX, pixelY))
           && stages.add(std::array{pixelX, pixelY, DoubleDouble(depth)});
}

class Worker {
public:
    explicit Worker(const Task &task) : m_task(task) {}

    void operator()(const LineBlock &block, BlockResult &result)
    {
        m_task.reader.read(block, m_rows, result.messages);
        RowWriter writer(m_task.format, m_task.layout.names(), result.output);
        result.badRows = m_rows.bad.size();
        auto bad = m_rows.bad.begin();
        for (std::size_t i = 0; i < m_rows.count(); ++i) {
            Stages stages;
            if (bad != m_rows.bad.end() && *bad == i) {
                m_task.layout.writeBad(writer, block, m_rows, *bad++);
            } else {
                m_task.layout.writeInput(writer, block, m_rows, i);
                if (!project(m_task, {m_rows.values[0][i], m_rows.values[1][i], m_rows.values[2][i]}, stages)) {
                    ++result.badRows;
                    m_task.reader.complainOf(
                        block, m_rows.places[i], NumberReader::kNoColumn,
                        m_task.lens && stages.count == kPinholeCount
                            ? tr("the point lies outside the lens's view: there the distortion folds the image over")
                            : tr("the point has no window position: it lies in the plane of the eye, or too far away"),
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

struct ProjectOptions {
    RowOptions rows;        ///< space: world or object:NAME
    std::string distortion; ///< coefficients or a file: px and py are of a distorted image; empty: of the pinhole's
};

/// Reads points, writes every stage on their way to the window and the input of `unproject points`: px,
/// py and the depth. That depth is window_z. For a point on the near or far plane within rounding it is
/// the plane's depth, because window_z may lie slightly outside the depth range.
ExitCode runProject(const ProjectOptions &options)
{
    const std::string &scene = options.rows.scene;
    const SceneOrClicks given = needed(sceneOrClicks(scene));
    // The preferred names first: users write x, y, z; `unproject points` writes the others.
    const std::unique_ptr<RowStream> rows = openRows(options.rows, given, {{"x", "y", "z"}, pointColumnsOf("formula")});
    if (!rows)
        throw Refused();
    Task task{options.rows.format,
              NumberReader(rows->source.name(), rows->columns),
              RowLayout(rows->columns, kResults, options.rows.format),
              rows->setup,
              needed(PixelProjection::of(rows->setup, rows->space), scene),
              {}};
    if (!options.distortion.empty())
        task.lens = sceneLens(options.distortion, rows->setup, scene);
    return runRows(*rows, options.rows, task.layout.names(), [&] { return BlockWorker(Worker(task)); });
}

} // namespace

void addProject(const Command &command)
{
    const auto options = std::make_shared<ProjectOptions>();
    command.rows(options->rows);
    command.add("--distortion", options->distortion);
    command.runs(options, runProject);
}

} // namespace unprojector::cli
