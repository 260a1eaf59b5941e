#include "core/cli/commands/map_command.h"

#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/cli/commands/opened_scene.h"
#include "core/cli/rows/byte_stream.h"
#include "core/cli/terminal/progress_bar.h"
#include "core/geometry/error_text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
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

/// 256 MB: the command keeps all numbers of a map until it is written, because it reports their
/// median.
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 26;

std::uint64_t pixelsOf(const Setup &setup)
{
    return static_cast<std::uint64_t>(setup.surface.widthPixels)
           * static_cast<std::uint64_t>(setup.surface.heightPixels);
}

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

bool hasSuffix(std::string_view name, std::string_view suffix)
{
    const auto isSame = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; };
    return name.size() >= suffix.size()
           && std::equal(suffix.begin(), suffix.end(), name.end() - static_cast<std::ptrdiff_t>(suffix.size()),
                         [&isSame](char wanted, char given) { return isSame(given, wanted); });
}

/// Returns whether a map can be written to the output; prints errors on stderr.
bool isOutputUsable(const MapOptions &options, const OpenedScene &opened)
{
    if (hasSuffix(options.output, ".png")) {
        complain(tr("%1: the command writes float maps only; give a name that ends in .pfm (the window exports PNG)",
                    options.output));
        return false;
    }
    if (options.isJson && options.output == "-") {
        complain(tr("the map and --json cannot both go to standard output; give a file for the map"));
        return false;
    }
    return !isOverInput(options.output, opened.files);
}

/// The surfaces visible at each pixel. It must outlive the result of source().
class Seen {
public:
    /// Builds it. Prints errors on stderr.
    static std::unique_ptr<const Seen> of(const MapOptions &options, const OpenedScene &opened,
                                          const Unprojector &unprojector);

    SurfaceSource source() const
    {
        if (!m_rays)
            return {false, [this](const Rows &rows, const ray::Progress &) {
                        return std::optional(surfacesAt(m_setup, m_depth, rows));
                    }};
        return {true, [this](const Rows &rows, const ray::Progress &progress) {
                    return surfacesMet(*m_rays, *m_pixels, m_format, rows, progress);
                }};
    }

private:
    Seen(const MapOptions &options, const Setup &setup)
        : m_setup(setup), m_depth(options.depth), m_format(options.format)
    {
    }

    Setup m_setup;
    double m_depth;
    DepthFormat m_format;
    std::optional<ray::SceneRays> m_rays; ///< empty: the depth is given
    std::optional<PixelRays> m_pixels;
};

std::unique_ptr<const Seen> Seen::of(const MapOptions &options, const OpenedScene &opened,
                                     const Unprojector &unprojector)
{
    const Setup &setup = unprojector.setup();
    std::unique_ptr<Seen> seen(new Seen(options, setup));
    if (options.isDepthGiven) {
        if (needsRays(options.quantity)) {
            complain(tr("--depth: %1 needs surfaces; leave the depth out and give a model or a scene with objects",
                        keyOf(options.quantity)));
            return nullptr;
        }
        if (const Result<double> valid = unitDepth(setup.depthRange, options.depth); !valid) {
            complain("--depth " + shortestText(options.depth) + ": " + errorText(valid.error()));
            return nullptr;
        }
        return seen;
    }
    const bool isAnySeen = std::any_of(opened.objects.begin(), opened.objects.end(),
                                       [](const SceneObject &object) { return !object.isHidden; });
    if (!isAnySeen) {
        complain(tr("%1: no object is visible; --depth gives a depth to every pixel, from %2 on the near plane to %3 "
                    "on the far plane",
                    opened.name, shortestText(setup.depthRange.atNear), shortestText(setup.depthRange.atFar)));
        return nullptr;
    }
    if (!areReachable(opened))
        return nullptr;
    seen->m_rays = raysOf(opened, unprojector);
    if (seen->m_rays->hasPoints())
        complain(opened.name + ": " + maps::noCloudsText());
    const Result<PixelRays> pixels = PixelRays::of(seen->m_rays->rays());
    if (!pixels) {
        complain(opened.name + ": " + errorText(pixels.error()));
        return nullptr;
    }
    seen->m_pixels = *pixels;
    return seen;
}

/// Three digits, enough to read a scale.
std::string threeDigits(double value)
{
    std::array<char, 32> digits;
    std::snprintf(digits.data(), digits.size(), "%.3g", value);
    return digits.data();
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
           + tr("; least %1, median %2, 99 % at most %3, greatest %4", threeDigits(statistics.least),
                threeDigits(statistics.median), threeDigits(statistics.percentile99), threeDigits(statistics.greatest));
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

} // namespace

ExitCode runMap(const MapOptions &options)
{
    const std::optional<OpenedScene> opened = openScene(options.scene);
    if (!opened || !isOutputUsable(options, *opened))
        return ExitCode::UnusableInput;
    const std::optional<Setup> setup = setupOf(*opened, options.size);
    if (!setup)
        return ExitCode::UnusableInput;
    if (pixelsOf(*setup) > kMostPixels) {
        complain(tr("a view of %1x%2 is too large for a map; give a smaller --size, of at most %3 pixels",
                    setup->surface.widthPixels, setup->surface.heightPixels, kMostPixels));
        return ExitCode::UnusableInput;
    }
    const Result<Unprojector> unprojector = Unprojector::of(*setup);
    if (!unprojector) {
        complain(opened->name + ": " + errorText(unprojector.error()));
        return ExitCode::UnusableInput;
    }
    ByteSink sink(options.output, opened->files); // an unwritable output is reported before the computation
    if (!sink.isOpen())
        return ExitCode::UnusableInput;
    ProgressBar bar(pixelsOf(*setup), ProgressBar::Unit::Points);
    const std::unique_ptr<const Seen> seen = Seen::of(options, *opened, *unprojector);
    if (!seen)
        return ExitCode::UnusableInput;
    Question question{options.quantity, options.unit, OtherProgram::Paper};
    if (const NamedConvention *convention = conventionNamed(options.convention))
        question.other = convention->other;
    auto map = pixelMap(question, *unprojector, seen->source(), opened->objects, partOf(bar, pixelsOf(*setup)));
    bar.finish();
    if (!map) {
        complain(opened->name + ": " + errorText(map.error()));
        return ExitCode::UnusableInput;
    }
    std::optional<PixelMap> made = std::move(map).value();
    writePfm(*made, [&sink](std::string_view part) { sink.write(part); });
    if (const ExitCode written = sink.finish(); written != ExitCode::Done)
        return written;
    const MapStatistics statistics = statisticsOf(std::move(*made));
    if (statistics.count == 0)
        complain(tr("%1: no pixel has a value; the map holds NaN only", opened->name));
    if (!options.isJson) {
        complain(statisticsText(options, statistics, pixelsOf(*setup)));
        return ExitCode::Done;
    }
    ByteSink json("-", opened->files);
    json.write(statisticsJson(options, statistics, setup->surface));
    return json.finish();
}

} // namespace unprojector::cli
