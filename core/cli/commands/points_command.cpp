#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/cameras/lens.h"
#include "core/cli/commands/command.h"
#include "core/cli/commands/inputs.h"
#include "core/cli/rows/row_table.h"
#include "core/cli/rows/scene_input.h"
#include "core/cli/terminal/exit_code.h"
#include "core/cli/terminal/refusal.h"
#include "core/unproject/answers.h"
#include "core/unproject/batch/click_batch.h"
#include "core/unproject/object_from_world.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace unprojector::cli {
using namespace geometry;
using namespace scene_file;
using namespace unproject;
using namespace base;
namespace {

struct PointsOptions {
    RowOptions rows;
    std::vector<Method> methods{Method::Formula, Method::Matrix};
    bool isPixel = false;   ///< px and py are pixel indices and mean the pixels' centres
    std::string distortion; ///< coefficients or a file: px and py are of a distorted image; empty: of a pinhole's
};

/// The input columns of a click.
const ColumnNames kClickColumns{"px", "py", "depth"};

/// The reason why a method does not apply to the scene, and the remedy.
std::string noMethodText(Method method, const geometry::Error &error)
{
    const std::string text = std::string(keyOf(method)) + ": " + errorText(error);
    return tr(error.code == ErrorCode::ViewNotRigid ? "%1. Its cells stay empty; 'unproject scene --from-matrices ... "
                                                      "--orthonormal' uses the nearest view that only rotates and moves"
                                                    : "%1. Its cells stay empty",
              text);
}

/// The indices of the formulas and the matrix among the methods, if both are there: their
/// difference is written.
std::optional<std::pair<std::size_t, std::size_t>> comparedPlaces(const std::vector<Method> &methods)
{
    const auto formula = std::find(methods.begin(), methods.end(), Method::Formula);
    const auto matrix = std::find(methods.begin(), methods.end(), Method::Matrix);
    if (formula == methods.end() || matrix == methods.end())
        return std::nullopt;
    return std::pair(static_cast<std::size_t>(formula - methods.begin()),
                     static_cast<std::size_t>(matrix - methods.begin()));
}

/// The names of the computed columns: three for each method, and "difference" if both the formulas
/// and the matrix are chosen.
std::vector<std::string> pointColumns(const std::vector<Method> &methods)
{
    std::vector<std::string> names;
    for (const Method method : methods) {
        for (const std::string &coordinate : pointColumnsOf(keyOf(method)))
            names.push_back(coordinate);
    }
    if (comparedPlaces(methods))
        names.emplace_back("difference");
    return names;
}

/// Writes the cells of a point by each method, and of the difference; empty where there is no
/// number.
/// @param points  in the order of `methods`; empty where a method has none
/// @return whether all existing points and their difference are finite
bool writePoints(RowWriter &writer, const std::vector<Method> &methods,
                 const std::vector<std::optional<glm::dvec3>> &points)
{
    bool isAllFinite = true;
    const auto write = [&](double value) {
        isAllFinite = isAllFinite && std::isfinite(value);
        writer.numberOrNothing(value);
    };
    for (const std::optional<glm::dvec3> &point : points) {
        for (int k = 0; k < 3; ++k) {
            if (point)
                write((*point)[k]);
            else
                writer.nothing();
        }
    }
    if (const auto compared = comparedPlaces(methods)) {
        const std::optional<glm::dvec3> &a = points[compared->first], &b = points[compared->second];
        if (a && b)
            write(glm::length(*a - *b));
        else
            writer.nothing();
    }
    return isAllFinite;
}

/// The data shared by all rows.
struct Task {
    PointsOptions options;
    const RowTable &table;
    DepthRange depthRange;
    std::vector<std::optional<ClickBatch>>
        batches; ///< in the order of options.methods; empty where one does not apply to the scene
    std::optional<SceneLens> lens;
};

/// The scratch memory of a thread.
class Worker {
public:
    explicit Worker(const Task &task) : m_task(task) {}

    void operator()(const LineBlock &block, BlockResult &result)
    {
        m_task.table.read(block, m_rows, result.messages);
        movePixels();
        refuseUnusable(block, result.messages);
        compute();
        m_task.table.write(block, m_rows, result,
                           [this](std::size_t row, RowWriter &writer) { return writeResults(row, writer); });
    }

private:
    using Columns = std::array<std::vector<double>, 3>;

    /// Moves indices to their pixels' centres, and pixels of a distorted image to the pinhole's.
    /// A pixel without a position there becomes NaN.
    void movePixels()
    {
        const std::size_t count = m_rows.count();
        const double offset = m_task.options.isPixel ? kHalfPixel : 0.0;
        for (std::size_t k = 0; k < 2; ++k) {
            m_pixels[k].resize(count);
            std::transform(m_rows.values[k].begin(), m_rows.values[k].end(), m_pixels[k].begin(),
                           [offset](double position) { return position + offset; });
        }
        for (std::size_t i = 0; m_task.lens && i < count; ++i) {
            const auto &[distortion, pinhole] = *m_task.lens;
            const auto pixel = cameras::undistortedPixel(distortion, pinhole, {m_pixels[0][i], m_pixels[1][i]});
            constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
            m_pixels[0][i] = pixel ? pixel->x : kNone;
            m_pixels[1][i] = pixel ? pixel->y : kNone;
        }
    }

    /// The reason why a row of three numbers is invalid; empty if it is valid. `column` becomes the
    /// wrong one.
    std::string fault(std::size_t row, std::size_t &column) const
    {
        const double low = std::min(m_task.depthRange.atNear, m_task.depthRange.atFar);
        const double high = std::max(m_task.depthRange.atNear, m_task.depthRange.atFar);
        const double depth = m_rows.values[2][row];
        if (!(depth >= low && depth <= high)) {
            column = 2;
            return "depth: "
                   + tr("%1 lies outside the depth range %2 to %3", shortestText(depth), shortestText(low),
                        shortestText(high));
        }
        for (column = 0; m_task.options.isPixel && column < 2; ++column) {
            const double index = m_rows.values[column][row];
            if (index != std::floor(index))
                return (column == 0 ? "px: " : "py: ")
                       + tr("%1 is not the index of a pixel: it has a fraction", shortestText(index));
        }
        column = 0;
        if (std::isnan(m_pixels[0][row]))
            return "px: "
                   + tr("the distortion cannot be undone here: no position of the undistorted image has this pixel");
        return {};
    }

    void refuseUnusable(const LineBlock &block, std::vector<LineMessage> &messages)
    {
        for (std::size_t i = 0; i < m_rows.count(); ++i) {
            std::size_t column = 0;
            const std::string what = m_rows.isBad[i] ? std::string() : fault(i, column);
            if (what.empty())
                continue;
            m_task.table.complainOf(block, m_rows.places[i], column, what, messages);
            m_rows.isBad[i] = true;
        }
    }

    void compute()
    {
        const std::size_t count = m_rows.count();
        const BatchInput<double> input{m_pixels[0].data(), m_pixels[1].data(), m_rows.values[2].data()};
        m_results.resize(m_task.batches.size());
        for (std::size_t method = 0; method < m_results.size(); ++method) {
            if (!m_task.batches[method])
                continue;
            Columns &points = m_results[method];
            for (auto &column : points)
                column.resize(count);
            (*m_task.batches[method])(input, BatchOutput<double>{points[0].data(), points[1].data(), points[2].data()},
                                      count);
        }
    }

    std::string writeResults(std::size_t row, RowWriter &writer)
    {
        m_points.clear();
        for (std::size_t method = 0; method < m_results.size(); ++method) {
            const Columns &columns = m_results[method];
            if (m_task.batches[method])
                m_points.emplace_back(glm::dvec3(columns[0][row], columns[1][row], columns[2][row]));
            else
                m_points.emplace_back();
        }
        return writePoints(writer, m_task.options.methods, m_points)
                   ? std::string()
                   : errorText(geometry::Error{ErrorCode::PointAtInfinity});
    }

    const Task &m_task;
    NumberRows m_rows;
    std::array<std::vector<double>, 2> m_pixels;     ///< positions in the pinhole's image
    std::vector<Columns> m_results;                  ///< one per method
    std::vector<std::optional<glm::dvec3>> m_points; ///< of one row
};

/// A click's point by one method in the requested space.
Result<glm::dvec3> pointOf(const Unprojector &unprojector, const WindowPoint &click, Method method,
                           const BatchSpace &space)
{
    const auto coordinates = [](const auto &point) {
        return point ? Result<glm::dvec3>(point->coordinates()) : Result<glm::dvec3>(point.error());
    };
    switch (space.kind) {
    case BatchSpace::Kind::Eye: return coordinates(unprojector.eyeAt(method, click));
    case BatchSpace::Kind::World: return coordinates(unprojector.worldAt(method, click));
    case BatchSpace::Kind::Object: break;
    }
    const Result<ObjectFromWorld> object = ObjectFromWorld::of(space.worldFromObject);
    return object ? coordinates(unprojector.objectAt(method, click, *object)) : Result<glm::dvec3>(object.error());
}

/// Computes each click again with its own scene, one row per click. A click on the background has no
/// point and counts as a bad row.
ExitCode runClicks(const PointsOptions &options, const std::vector<Click> &clicks)
{
    if (!options.distortion.empty())
        refuse(tr("--distortion is for tables of pixels; the window's clicks have no distortion"));
    if (options.isPixel)
        refuse(tr("--pixel is for tables of pixels; clicks already have the centres of their pixels"));
    ByteSink sink("-", filesOf(clicks, options.rows.scene));
    std::vector<std::string> names(kClickColumns.begin(), kClickColumns.end());
    const std::vector<std::string> results = pointColumns(options.methods);
    names.insert(names.end(), results.begin(), results.end());
    std::string text = options.rows.header(names);
    RowWriter writer = options.rows.writer(text, names);
    ExitCode code = ExitCode::Done;
    for (std::size_t i = 0; i < clicks.size(); ++i) {
        const Click &click = clicks[i];
        const std::string name =
            inputName(options.rows.scene) + (clicks.size() == 1 ? "" : ": [" + std::to_string(i) + ']');
        const auto complainOfClick = [&](const std::string &what) {
            code = ExitCode::SomeRowsBad;
            complain(name + ": " + what);
        };
        const BatchSpace space = batchSpace(options.rows.space, click.scene);
        const Setup setup = setupOf(click.scene);
        const Unprojector unprojector = needed(Unprojector::of(setup), name);
        const DevicePoint device = deviceFromWindow(setup.surface, click.window);
        for (const double number : {device.x, device.y, click.window.z})
            writer.number(number);
        if (!click.hit)
            complainOfClick(tr("background: nothing was drawn there, so the click has no point, only a ray"));
        std::vector<std::optional<glm::dvec3>> points(options.methods.size());
        for (std::size_t k = 0; k < points.size() && click.hit; ++k) {
            const Result<glm::dvec3> point = pointOf(unprojector, click.window, options.methods[k], space);
            if (point)
                points[k] = *point;
            else
                complainOfClick(std::string(keyOf(options.methods[k])) + ": " + errorText(point.error()));
        }
        writePoints(writer, options.methods, points);
        writer.endRow();
    }
    sink.write(text);
    return std::max(sink.finish(), code);
}

ExitCode runPoints(const PointsOptions &options)
{
    const SceneOrClicks given = sceneOrClicks(options.rows.scene);
    if (const auto *clicks = std::get_if<std::vector<Click>>(&given); clicks && !options.rows.isInputGiven)
        return runClicks(options, *clicks);
    const RowScene scene = rowScene(given, options.rows);
    RowTable rows(options.rows, {kClickColumns}, pointColumns(options.methods));
    const Setup &setup = scene.setup;
    Task task{options, rows, setup.depthRange, {}, {}};
    if (!options.distortion.empty())
        task.lens = sceneLens(options.distortion, setup, options.rows.scene);
    bool isUsable = false;
    for (const Method method : options.methods) {
        const Result<ClickBatch> batch = ClickBatch::of(method, setup, scene.space);
        isUsable = isUsable || batch;
        // The cells of a method that does not apply to the scene stay empty.
        task.batches.push_back(batch ? std::optional(*batch) : std::nullopt);
        if (!batch)
            complain(options.rows.scene + ": " + noMethodText(method, batch.error()));
    }
    if (!isUsable)
        throw Refused();
    ByteSink sink("-", scene.inputs); // appended to the input, it would be read as input, endlessly
    return rows.run(sink, [&] { return BlockWorker(Worker(task)); });
}

} // namespace

void addPoints(const Command &command)
{
    const auto options = std::make_shared<PointsOptions>();
    command.rows(options->rows);
    command.choice("--method", options->methods,
                   {{"all", {kMethods.begin(), kMethods.end()}},
                    {"both", {Method::Formula, Method::Matrix}},
                    {"formula", {Method::Formula}},
                    {"matrix", {Method::Matrix}},
                    {"matrixInFloat", {Method::MatrixInFloat}}});
    command.flag("--pixel", options->isPixel);
    command.add("--distortion", options->distortion);
    command.runs(options, [command](PointsOptions &given) {
        given.rows.isInputGiven = command.has("POINTS");
        return runPoints(given);
    });
}

} // namespace unprojector::cli
