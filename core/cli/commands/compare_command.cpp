#include "core/base/columns.h"
#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/cli/commands/command.h"
#include "core/cli/rows/distribution.h"
#include "core/cli/rows/scene_input.h"
#include "core/cli/terminal/progress_bar.h"
#include "core/cli/terminal/refusal.h"
#include "core/geometry/error_text.h"
#include "core/geometry/unit_in_last_place.h"
#include "core/unproject/exact_unprojection.h"
#include "core/unproject/unprojector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace unprojector::cli {
using namespace geometry;
using namespace scene_file;
using namespace unproject;
using namespace base;
namespace {

struct CompareOptions {
    std::string scene;
    bool isJson = false;
    int pixels = 32; ///< across and down
    int depths = 17; ///< from one end of the depth range to the other
};

constexpr double kShare = 0.9999;

/// One method of computation, and its errors.
struct Way {
    using Function = std::function<Result<WorldPoint>(const WindowPoint &)>;

    const char *method, *precision;
    bool isFloat = false;
    Function by;
    std::vector<Distribution> of; ///< x, y, z in world units; units in the last place of the largest coordinate
    std::size_t withoutAnswer = 0;
    std::string reason; ///< error of the first point without an answer

    Way(const char *methodName, const char *precisionName, bool isInFloat, std::size_t points, Function function)
        : method(methodName), precision(precisionName), isFloat(isInFloat), by(std::move(function)),
          of(4, Distribution(kShare, points))
    {
    }

    void add(const std::array<Extended, 3> &exact, const Result<WorldPoint> &point)
    {
        if (!point)
            return addNoAnswer(errorText(point.error()));
        std::array<double, 3> differences{};
        double largest = 0.0, farthest = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            differences[k] = std::abs(static_cast<double>((*point)[static_cast<int>(k)] - exact[k]));
            if (!std::isfinite(differences[k]))
                return addNoAnswer(tr("the numbers leave the range of %1", precision));
            farthest = std::max(farthest, differences[k]);
            largest = std::max(largest, std::abs(static_cast<double>(exact[k])));
        }
        const double ulps = farthest / ulpOf(largest);
        if (!std::isfinite(ulps))
            return addNoAnswer(tr("the numbers leave the range of %1", precision));
        for (std::size_t k = 0; k < 3; ++k)
            of[k].add(differences[k]);
        of[3].add(ulps);
    }

    void addNoAnswer(const std::string &why)
    {
        if (withoutAnswer++ == 0)
            reason = why;
    }

    /// A unit in the last place, in the method's precision.
    double ulpOf(double value) const
    {
        return isFloat ? static_cast<double>(unitInLastPlace(static_cast<float>(value))) : unitInLastPlace(value);
    }
};

/// The closed form entirely in single precision, as in a program that stores its numbers so.
Way::Function formulaInFloat(const Setup &setup)
{
    const Result<Setup> view = byParameters(setup);
    const Result<EyeFrame> frame = view ? eyeFrame(view->camera()) : Result<EyeFrame>(view.error());
    if (!frame)
        return [error = frame.error()](const WindowPoint &) -> Result<WorldPoint> { return error; };
    return [g = *view, frame = *frame](const WindowPoint &window) -> Result<WorldPoint> {
        const ProjectionWindow w = projectionWindow(g.projection());
        const bool perspective = isPerspective(g.projection());
        const auto n = float(w.nearDistance), f = float(w.farDistance);
        const auto dn = float(g.depthRange.atNear), df = float(g.depthRange.atFar);
        const float d = (float(window.z) - dn) / (df - dn);
        const float z = perspective ? n * f / (f * (1.0f - d) + n * d) : n * (1.0f - d) + f * d;
        const auto between = [&](double low, double high, double position, double start, double size) {
            const float span = (float(position) - float(start)) * (float(high) - float(low));
            return perspective ? span * z / (float(size) * n) + float(low) * z / n : span / float(size) + float(low);
        };
        float x = between(w.left, w.right, window.x, g.viewport.x, g.viewport.width);
        float y = between(w.bottom, w.top, window.y, g.viewport.y, g.viewport.height);
        if (perspective)
            x -= float(w.skew) * y;
        if (const auto *oblique = std::get_if<Oblique>(&g.projection())) {
            x += float(cotangent(oblique->theta)) * z;
            y += float(cotangent(oblique->phi)) * z;
        }
        WorldPoint world;
        for (int k = 0; k < 3; ++k) {
            world[k] = double(float(frame.eye[k]) + x * float(frame.side[k]) + y * float(frame.upward[k])
                              + z * float(frame.forward[k]));
        }
        return world;
    };
}

/// The middle of the i-th of so many equal parts of [0, 1].
double middleOfPart(int i, int parts)
{
    return (i + 0.5) / parts;
}

/// Visits the centres of pixels spread over the viewport, times depths from one end to the other.
template <class Function>
void forEachPoint(const Setup &g, const CompareOptions &options, Function function)
{
    const auto spread = [&](double start, double size, int i) {
        return start + std::floor(middleOfPart(i, options.pixels) * size) + kHalfPixel;
    };
    for (int k = 0; k < options.depths; ++k) {
        const double share = options.depths == 1 ? middleOfPart(0, 1) : double(k) / (options.depths - 1);
        const double depth = share == 1.0 ? g.depthRange.atFar
                                          : g.depthRange.atNear + share * (g.depthRange.atFar - g.depthRange.atNear);
        for (int j = 0; j < options.pixels; ++j) {
            for (int i = 0; i < options.pixels; ++i) {
                function(WindowPoint(spread(g.viewport.x, g.viewport.width, i),
                                     spread(g.viewport.y, g.viewport.height, j), depth));
            }
        }
    }
}

constexpr const char *kQuantities[] = {"x", "y", "z", "ulps"};

std::string table(const std::vector<Way> &ways, std::size_t points)
{
    std::string text =
        tr("Differences from extended precision over %1 points, world units; ulps of the largest coordinate", points)
        + "\n\n";
    const auto line = [&](const std::string &method, const std::string &precision, const char *what,
                          const std::string &a, const std::string &b, const std::string &c) {
        text += padded(method, 8) + ' ' + padded(precision, 7) + ' ' + padded(what, 5);
        for (const std::string *number : {&a, &b, &c})
            text += ' ' + paddedLeft(*number, 10);
        text += '\n';
    };
    const auto number = [](double value) { return significantText(value, 3); };
    line(tr("method|column"), tr("in|column"), "", tr("largest|column"), tr("mean|column"), "99.99 %");
    for (const Way &way : ways) {
        for (std::size_t k = 0; k < 4; ++k) {
            const Distribution &d = way.of[k];
            const bool isThere = !d.isEmpty();
            line(k == 0 ? tr(way.method) : std::string(), k == 0 ? way.precision : "", kQuantities[k],
                 isThere ? number(d.largest()) : "-", isThere ? number(d.mean()) : "-",
                 isThere ? number(d.percentile()) : "-");
        }
        if (way.withoutAnswer > 0)
            text += "         " + tr("%1 points without an answer: %2", way.withoutAnswer, way.reason) + '\n';
    }
    return text;
}

std::string json(const std::vector<Way> &ways, std::size_t points)
{
    const InEnglish english;
    std::string text = "{\n  \"points\": " + std::to_string(points) + ",\n  \"methods\": [";
    for (std::size_t i = 0; i < ways.size(); ++i) {
        const Way &way = ways[i];
        text += std::string(i == 0 ? "" : ",") + "\n    {\"method\": \"" + tr(way.method) + "\", \"precision\": \""
                + way.precision + "\", \"withoutAnswer\": " + std::to_string(way.withoutAnswer);
        for (std::size_t k = 0; k < 4; ++k) {
            const Distribution &d = way.of[k];
            text += std::string(",\n     \"") + kQuantities[k] + "\": ";
            if (d.isEmpty()) {
                text += "null";
                continue;
            }
            text += "{\"largest\": ";
            appendNumber(text, d.largest());
            text += ", \"mean\": ";
            appendNumber(text, d.mean());
            text += ", \"percentile99.99\": ";
            appendNumber(text, d.percentile());
            text += '}';
        }
        text += '}';
    }
    return text + "\n  ]\n}\n";
}

ExitCode runCompare(const CompareOptions &options)
{
    const SceneFile scene = readScene(options.scene);
    const Setup setup = setupOf(scene);
    const std::optional<ExactUnprojection> exact = ExactUnprojection::of(setup);
    if (!exact)
        refuse(options.scene + ": " + errorText(geometry::Error{ErrorCode::SingularMatrix}));
    const Unprojector unprojector = needed(Unprojector::of(setup), options.scene);
    ByteSink sink("-", filesOf(scene, options.scene));
    const auto by = [&](Method method) {
        return [&, method](const WindowPoint &window) { return unprojector.worldAt(method, window); };
    };
    const std::size_t most = static_cast<std::size_t>(options.pixels) * static_cast<std::size_t>(options.pixels)
                             * static_cast<std::size_t>(options.depths);
    std::vector<Way> ways{{marked("formula|method"), "double", false, most, by(Method::Formula)},
                          {marked("matrix|method"), "double", false, most, by(Method::Matrix)},
                          {marked("formula|method"), "float", true, most, formulaInFloat(setup)},
                          {marked("matrix|method"), "float", true, most, by(Method::MatrixInFloat)}};
    ProgressBar progress(most, ProgressBar::Unit::Points);
    std::size_t points = 0;
    forEachPoint(setup, options, [&](const WindowPoint &window) {
        progress.advance(1);
        const std::optional<std::array<Extended, 3>> world = exact->at(window);
        if (!world)
            return; // a far plane at infinity
        ++points;
        for (Way &way : ways)
            way.add(*world, way.by(window));
    });
    progress.finish();
    if (options.isJson)
        sink.write(json(ways, points));
    else
        sink.print(table(ways, points));
    return sink.finish();
}

} // namespace

void addCompare(const Command &command)
{
    const auto options = std::make_shared<CompareOptions>();
    command.file("SCENE", options->scene)->required();
    command.flag("--json", options->isJson);
    command.count("--pixels", options->pixels, 1000);
    command.count("--depths", options->depths, 1000);
    command.runs(options, runCompare);
}

} // namespace unprojector::cli
