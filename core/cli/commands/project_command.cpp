#include "core/cli/commands/project_command.h"

#include "core/cameras/lens.h"
#include "core/cli/commands/lens_option.h"
#include "core/cli/rows/row_layout.h"
#include "core/geometry/way_forward.h"
#include "core/text/error_text.h"
#include "core/text/translation.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace unprojector::cli {
using namespace geometry;
using namespace scene_file;
using namespace unproject;
using namespace text;
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
    WayForward way;
    BatchSpace space;
    glm::dmat4 clipFromEye;
    glm::dmat4 eyeMagnitudes; ///< magnitudes of the terms that sum up to eye coordinates
    std::optional<SceneLens> lens;
};

glm::dmat4 magnitudes(glm::dmat4 m)
{
    for (int column = 0; column < 4; ++column)
        m[column] = glm::abs(m[column]);
    return m;
}

/// The magnitudes of a view matrix. The entries of its translation are sums of products as large as
/// the translation is long.
glm::dmat4 viewMagnitudes(const glm::dmat4 &eyeFromWorld)
{
    glm::dmat4 m = magnitudes(eyeFromWorld);
    m[3] = glm::dvec4(glm::dvec3(glm::length(glm::dvec3(m[3]))), m[3].w);
    return m;
}

/// The possible rounding error of a point's depth. The point was computed in double before, so it
/// has an error of a few units in the last place of each term. That error is propagated to the
/// depth. 0 in the plane of the eye, where rounding dominates; the near and far planes are
/// elsewhere.
double depthUncertainty(const Task &task, const glm::dvec4 &point, const glm::dvec4 &eye, const glm::dvec4 &clip)
{
    constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();
    const glm::dvec4 ofEye = kRounding * (task.eyeMagnitudes * glm::abs(point));
    const glm::dvec4 ofClip = magnitudes(task.clipFromEye) * (kRounding * glm::abs(eye) + ofEye);
    if (!(1000.0 * ofClip.w <= std::abs(clip.w)))
        return 0.0;
    const double ofNdc = (ofClip.z + std::abs(clip.z / clip.w) * ofClip.w) / std::abs(clip.w);
    const auto &[atNear, atFar] = task.setup.depthRange;
    return ofNdc * std::abs(atFar - atNear) + kRounding * std::max(std::abs(atNear), std::abs(atFar));
}

/// The depth, or the nearer end of the depth range where the depth is outside by no more than the
/// uncertainty.
double depthWithin(const DepthRange &range, double depth, double uncertainty)
{
    const double nearest = std::clamp(depth, std::min(range.atNear, range.atFar), std::max(range.atNear, range.atFar));
    return std::abs(depth - nearest) <= uncertainty ? nearest : depth;
}

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

glm::dvec4 rounded(const DoubleDouble4 &v)
{
    return {v[0].value, v[1].value, v[2].value, v[3].value};
}

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
    const Setup &g = task.setup;
    const PreciseStages way = task.space.kind == BatchSpace::Kind::Eye
                                  ? task.way.fromEye(precise(point))
                                  : task.way.fromWorld(product(task.space.worldFromObject, precise(point)));
    if (!stages.add(way.eye) || !stages.add(way.clip) || way.clip[3].value == 0.0)
        return false;
    const auto &[x, y, windowDepth] = way.window;
    const DoubleDouble py = flippedY(g.surface, y), ratio = g.surface.devicePixelRatio;
    const glm::dvec4 eye = rounded({way.eye[0], way.eye[1], way.eye[2], 1.0});
    const double depth = depthWithin(g.depthRange, windowDepth.value,
                                     depthUncertainty(task, glm::dvec4(point, 1.0), eye, rounded(way.clip)));
    DoubleDouble pixelX = x, pixelY = py;
    return stages.add(way.ndc) && stages.add(way.window) && stages.add(std::array{x / ratio, py / ratio})
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

} // namespace

ExitCode runProject(const RowOptions &options, const std::string &distortion)
{
    const std::optional<SceneOrClicks> given = sceneOrClicks(options.scene);
    if (!given)
        return ExitCode::UnusableInput;
    // The preferred names first: users write x, y, z; `unproject points` writes the others.
    const std::unique_ptr<RowStream> rows = openRows(options, *given, {{"x", "y", "z"}, pointColumnsOf("formula")});
    if (!rows)
        return ExitCode::UnusableInput;
    const Setup &setup = rows->setup;
    const Result<WayForward> way = WayForward::of(setup);
    if (!way) {
        complain(options.scene + ": " + errorText(way.error()));
        return ExitCode::UnusableInput;
    }
    const bool isInEye = rows->space.kind == BatchSpace::Kind::Eye;
    std::optional<SceneLens> lens;
    if (!distortion.empty()) {
        lens = sceneLens(distortion, setup, options.scene);
        if (!lens)
            return ExitCode::UnusableInput;
    }
    const Task task{options.format,
                    NumberReader(rows->source.name(), rows->columns),
                    RowLayout(rows->columns, kResults, options.format),
                    setup,
                    *way,
                    rows->space,
                    clipFromEye(setup).value(),
                    isInEye ? glm::dmat4(1.0)
                            : viewMagnitudes(eyeFromWorld(setup).value()) * magnitudes(rows->space.worldFromObject),
                    lens};
    return runRows(*rows, options, task.layout.names(), [&] { return BlockWorker(Worker(task)); });
}

} // namespace unprojector::cli
