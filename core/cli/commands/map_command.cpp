#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cli/commands/command.h"
#include "core/cli/commands/inputs.h"
#include "core/cli/terminal/progress_bar.h"
#include "core/cli/terminal/refusal.h"
#include "core/maps/pixel_map.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

namespace unprojector::cli {
using namespace geometry;
using namespace scene;
using namespace unproject;
using namespace maps;
using namespace base;
namespace {

struct MapOptions {
    std::string scene; ///< a model, a scene or clicks; "-" is a scene from stdin
    Quantity quantity = Quantity::FormulaMatrix;
    std::string convention; ///< convention of a displacement; empty for the other quantities
    Unit unit = Unit::World;
    std::string size; ///< size of the view, "WxH"; empty: its own
    std::optional<double> depth;
    DepthFormat format; ///< format of the surfaces' depths
    bool isJson = false;
    std::string output; ///< a PFM file, "-" for stdout
};

/// 256 MB: the command keeps all numbers of a map until it is written, because it reports their
/// median.
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 26;

/// A part of the work on a progress bar; only the system can stop it.
ray::Progress partOf(ProgressBar &bar, std::uint64_t amount)
{
    return [&bar, amount, told = std::uint64_t{0}](double share) mutable {
        const auto done = static_cast<std::uint64_t>(share * static_cast<double>(amount));
        if (done > told)
            bar.advance(done - std::exchange(told, done));
        return true;
    };
}

/// Checks that a map can be written to the output.
void checkOutput(const MapOptions &options)
{
    if (lowerCase(options.output).ends_with(".png"))
        refuse(tr("%1: the command writes float maps only; give a name that ends in .pfm (the window exports PNG)",
                  options.output));
    if (options.isJson && options.output == "-")
        refuse(tr("the map and --json cannot both go to standard output; give a file for the map"));
}

/// The surfaces visible at each pixel: at the given depth, or met by rays.
/// @param unprojector  must outlive the result
SurfaceSource surfacesOf(const MapOptions &options, const OpenedScene &opened, const Unprojector &unprojector)
{
    const Setup &setup = unprojector.setup();
    if (options.depth) {
        if (needsRays(options.quantity))
            refuse(tr("--depth: %1 needs surfaces; leave the depth out and give a model or a scene with objects",
                      keyOf(options.quantity)));
        needed(unitDepth(setup.depthRange, *options.depth), "--depth " + shortestText(*options.depth));
        return {false, [&setup, depth = *options.depth](const Rows &rows, const ray::Progress &) {
                    return std::optional(surfacesAt(setup, depth, rows));
                }};
    }
    if (std::all_of(opened.objects.begin(), opened.objects.end(),
                    [](const SceneObject &object) { return object.isHidden; }))
        refuse(tr("%1: no object is visible; --depth gives a depth to every pixel, from %2 on the near plane to %3 "
                  "on the far plane",
                  opened.name, shortestText(setup.depthRange.atNear), shortestText(setup.depthRange.atFar)));
    checkReach(opened);
    const auto rays = std::make_shared<const ray::SceneRays>(raysOf(opened, unprojector));
    if (rays->hasPoints())
        complain(opened.name + ": " + noCloudsText());
    return {true, [rays, pixels = needed(PixelRays::of(rays->rays()), opened.name),
                   format = options.format](const Rows &rows, const ray::Progress &progress) {
                return surfacesMet(*rays, pixels, format, rows, progress);
            }};
}

std::string statisticsText(const MapOptions &options, const MapStatistics &statistics, std::uint64_t pixels)
{
    const std::string what = options.convention.empty() ? std::string(keyOf(options.quantity))
                                                        : tr("%1 of %2", keyOf(options.quantity), options.convention);
    std::string text = tr(options.unit == Unit::Ulps ? "%1, ulps: %2 of %3 pixels" : "%1, world units: %2 of %3 pixels",
                          what, statistics.count, pixels);
    if (statistics.count == 0)
        return text;
    return text
           + tr("; least %1, median %2, 99 % at most %3, greatest %4", significantText(statistics.least, 3),
                significantText(statistics.median, 3), significantText(statistics.percentile99, 3),
                significantText(statistics.greatest, 3));
}

std::string statisticsJson(const MapOptions &options, const MapStatistics &statistics, const Surface &surface)
{
    std::string text = "{\"what\": \"" + std::string(keyOf(options.quantity)) + '"';
    if (!options.convention.empty())
        text += ", \"convention\": \"" + options.convention + '"';
    text += std::string(", \"unit\": \"") + (options.unit == Unit::Ulps ? "ulp" : "world") + "\", \"size\": ["
            + std::to_string(surface.widthPixels) + ", " + std::to_string(surface.heightPixels)
            + "], \"count\": " + std::to_string(statistics.count);
    for (const auto &[name, value] :
         {std::pair("min", statistics.least), std::pair("median", statistics.median),
          std::pair("p99", statistics.percentile99), std::pair("max", statistics.greatest)}) {
        text += std::string(", \"") + name + "\": ";
        if (statistics.count > 0)
            appendNumber(text, value);
        else
            text += "null";
    }
    return text + "}\n";
}

ExitCode runMap(const MapOptions &options)
{
    const OpenedScene opened = openScene(options.scene);
    checkOutput(options);
    const Setup setup = setupOf(opened, options.size);
    const std::uint64_t pixels = pixelsOf(setup);
    if (pixels > kMostPixels)
        refuse(tr("a view of %1x%2 is too large for a map; give a smaller --size, of at most %3 pixels",
                  setup.surface.widthPixels, setup.surface.heightPixels, kMostPixels));
    const Unprojector unprojector = needed(Unprojector::of(setup), opened.name);
    ByteSink sink(options.output, opened.files); // an unwritable output is reported before the computation
    ProgressBar bar(pixels, ProgressBar::Unit::Points);
    const SurfaceSource surfaces = surfacesOf(options, opened, unprojector);
    Question question{options.quantity, options.unit, OtherProgram::Paper};
    if (const NamedConvention *convention = conventionNamed(options.convention))
        question.other = convention->other;
    auto result = pixelMap(question, unprojector, surfaces, opened.objects, partOf(bar, pixels));
    bar.finish();
    std::optional<PixelMap> map = needed(std::move(result), opened.name);
    writePfm(*map, [&sink](std::string_view part) { sink.write(part); });
    if (const ExitCode written = sink.finish(); written != ExitCode::Done)
        return written;
    const MapStatistics statistics = statisticsOf(std::move(*map));
    if (statistics.count == 0)
        complain(tr("%1: no pixel has a value; the map holds NaN only", opened.name));
    if (!options.isJson) {
        complain(statisticsText(options, statistics, pixels));
        return ExitCode::Done;
    }
    ByteSink json("-", opened.files);
    json.write(statisticsJson(options, statistics, setup.surface));
    return json.finish();
}

std::string conventionNames()
{
    constexpr std::size_t kMostInLine = 80;
    std::string names, line;
    for (const NamedConvention &convention : namedConventions()) {
        if (line.size() + convention.key.size() > kMostInLine) {
            names += line + '\n';
            line.clear();
        }
        line += std::string(convention.key) + ", ";
    }
    return names + line.substr(0, line.size() - 2);
}

} // namespace

void addMap(const Command &command)
{
    const auto options = std::make_shared<MapOptions>();
    command.modelOrScene(options->scene);
    std::map<std::string, Quantity> quantities;
    for (const Quantity quantity : kQuantities)
        quantities.emplace(keyOf(quantity), quantity);
    command.choice("--what", options->quantity, quantities)->default_str("")->required();
    command.word(
        "--convention", conventionNames(), [options](const std::string &given) { options->convention = given; },
        [](const std::string &given) { return conventionNamed(given) != nullptr; });
    command.choice("--unit", options->unit, {{"world", Unit::World}, {"ulp", Unit::Ulps}});
    command.add("--size", options->size);
    command.add("--depth", options->depth);
    command.choice("--depth-buffer", options->format,
                   {{"16", DepthFormat(16)},
                    {"24", DepthFormat(24)},
                    {"32", DepthFormat(32)},
                    {"float", DepthFormat::floatingPoint()}});
    command.flag("--json", options->isJson);
    command.file("-o,--output", options->output)->required();
    command.runs(options, [](const MapOptions &given) {
        const bool isOfOther = given.quantity == Quantity::Displacement;
        if (isOfOther && given.convention.empty())
            throw CLI::RequiredError(tr("--convention (with --what displacement)"));
        if (!isOfOther && !given.convention.empty())
            throw CLI::ValidationError(
                "--convention " + given.convention,
                tr("is for --what displacement, not for --what %1; leave one of them out", keyOf(given.quantity)));
        return runMap(given);
    });
}

} // namespace unprojector::cli
