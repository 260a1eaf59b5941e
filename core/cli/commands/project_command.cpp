#include "core/base/translation.h"
#include "core/cameras/lens.h"
#include "core/cli/commands/command.h"
#include "core/cli/commands/inputs.h"
#include "core/cli/rows/row_table.h"
#include "core/cli/rows/scene_input.h"
#include "core/cli/terminal/refusal.h"
#include "core/unproject/pixel_projection.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
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
bool project(const PixelProjection &projection, const std::optional<SceneLens> &lens, double pixelRatio,
             const glm::dvec3 &point, Stages &stages)
{
    const auto &[way, px, py, depth] = projection.at(point);
    if (!stages.add(way.eye) || !stages.add(way.clip) || way.clip[3].value == 0.0)
        return false;
    const DoubleDouble ratio = pixelRatio;
    DoubleDouble pixelX = px, pixelY = py;
    return stages.add(way.ndc) && stages.add(way.window) && stages.add(std::array{px / ratio, py / ratio})
           && (!lens || distort(*lens, pixelX, pixelY)) && stages.add(std::array{pixelX, pixelY, DoubleDouble(depth)});
}

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
    const RowScene rowsScene = rowScene(sceneOrClicks(scene), options.rows);
    // The preferred names first: users write x, y, z; `unproject points` writes the others.
    RowTable rows(options.rows, {{"x", "y", "z"}, pointColumnsOf("formula")}, kResults);
    const Setup &setup = rowsScene.setup;
    const PixelProjection projection = needed(PixelProjection::of(setup, rowsScene.space), scene);
    std::optional<SceneLens> lens;
    if (!options.distortion.empty())
        lens = sceneLens(options.distortion, setup, scene);
    const auto write = [&](const glm::dvec3 &point, RowWriter &writer) -> std::string {
        Stages stages;
        const bool isComplete = project(projection, lens, setup.surface.devicePixelRatio, point, stages);
        for (std::size_t k = 0; k < stages.numbers.size(); ++k) {
            if (k < stages.count)
                writer.number(stages.numbers[k]);
            else
                writer.nothing();
        }
        if (isComplete)
            return {};
        return lens && stages.count == kPinholeCount
                   ? tr("the point lies outside the lens's view: there the distortion folds the image over")
                   : tr("the point has no window position: it lies in the plane of the eye, or too far away");
    };
    ByteSink sink("-", rowsScene.inputs); // appended to the input, it would be read as input, endlessly
    return rows.runEach(sink, write);
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
