#include "core/base/byte_order.h"
#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/cli/commands/command.h"
#include "core/cli/commands/inputs.h"
#include "core/cli/rows/depth_image.h"
#include "core/cli/rows/scene_input.h"
#include "core/cli/terminal/exit_code.h"
#include "core/cli/terminal/progress_bar.h"
#include "core/cli/terminal/refusal.h"
#include "core/clouds/depth_cloud.h"
#include "core/clouds/depth_numbers.h"
#include "core/clouds/organized_cloud.h"
#include "core/geometry/error_text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace unprojector::cli {
using namespace clouds;
using namespace geometry;
using namespace scene_file;
using namespace unproject;
using namespace base;
namespace {

/// The precision of the numbers in the file. Computations are in double either way.
enum class PointPrecision { Float, Double };

struct CloudOptions {
    std::string scene;
    std::string depth; ///< a depth image, see images::readNumberImage
    std::string color; ///< PNG or JPEG of the same pixels; empty: points without colors
    std::string size;  ///< "WxH", for raw floats
    DepthImageChoices choices;
    std::string output; ///< a PLY file, "-" for stdout
    DepthNumbers numbers;
    Method method = Method::Formula;
    PointPrecision precision = PointPrecision::Float;
};

/// Converts numbers to PLY's binary_little_endian.
template <class Scalar>
void makeLittleEndian([[maybe_unused]] std::span<Scalar> values)
{
    if constexpr (std::endian::native == std::endian::big) {
        std::ranges::transform(values, values.begin(), withSwappedBytes<Scalar>);
    }
}

template <class Scalar>
std::string plyHeader(std::size_t count, bool hasColors)
{
    const std::string property = std::is_same_v<Scalar, double> ? "property double " : "property float ";
    return "ply\nformat binary_little_endian 1.0\ncomment world coordinates\nelement vertex " + std::to_string(count)
           + '\n' + property + "x\n" + property + "y\n" + property + "z\n"
           + (hasColors ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : "") + "end_header\n";
}

/// The extent of the written points.
class Extent {
public:
    void add(const std::array<double, 3> &point)
    {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            m_lowest[axis] = std::min(m_lowest[axis], point[axis]);
            m_highest[axis] = std::max(m_highest[axis], point[axis]);
        }
    }
    /// The largest change of a coordinate by rounding to single precision, where it is more than a
    /// millionth of the extent; else 0.
    double floatRounding() const
    {
        constexpr double kMillionth = 1e-6;
        double size = 0.0, largest = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            size = std::max(size, m_highest[axis] - m_lowest[axis]);
            largest = std::max({largest, std::abs(m_lowest[axis]), std::abs(m_highest[axis])});
        }
        const double rounding =
            std::isfinite(largest) && largest > 0.0 ? std::exp2(std::floor(std::log2(largest)) - 24.0) : 0.0;
        return rounding > kMillionth * size ? rounding : 0.0;
    }

private:
    static constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::array<double, 3> m_lowest{kInfinity, kInfinity, kInfinity}, m_highest{-kInfinity, -kInfinity, -kInfinity};
};

/// What a cloud is computed from.
struct Cloud {
    const CloudOptions &options;
    const Setup &setup;
    const BatchUnprojection &unprojection;
    const images::NumberImage &image;
    const DepthRows &rows;
    const PixelLines &lines;
    std::optional<ClipDistances> clip; ///< empty for window depths
    std::optional<images::ColorImage> colors;
    PixelCounts counts{};
    std::size_t saturated = 0; ///< kept pixels with the greatest possible whole number

    std::size_t seen() const { return counts[static_cast<std::size_t>(PixelKind::Kept)]; }
    std::string source() const { return options.depth == "-" ? "stdin" : options.depth; }
};

/// The points of window depths in single precision, by the fastest loops.
/// @return how many points lie in the range of Scalar
template <class Scalar>
std::size_t writeDepths(const Cloud &c, ByteSink &sink, Extent &extent, ProgressBar &progress)
{
    const DepthCloud<Scalar> cloud(c.unprojection, c.setup, c.image);
    constexpr std::size_t kBufferNumbers = std::size_t{1} << 16;
    const std::size_t rowNumbers = 3 * c.image.size.width, height = c.image.size.height;
    std::vector<Scalar> buffer(std::max(kBufferNumbers, rowNumbers));
    std::size_t count = c.seen();
    if (cloud.canOverflow()) {
        count = 0;
        for (std::size_t j = 0; j < height; ++j)
            count += cloud.row(j, buffer.data());
    }
    sink.write(plyHeader<Scalar>(count, false));
    std::size_t filled = 0;
    for (std::size_t j = 0; j < height && sink.state() == ByteSink::State::Open; ++j) {
        filled += 3 * cloud.row(j, buffer.data() + filled);
        if (filled + rowNumbers > buffer.size() || j + 1 == height) {
            if constexpr (std::is_same_v<Scalar, float>) {
                for (std::size_t i = 0; i < filled; i += 3)
                    extent.add({buffer[i], buffer[i + 1], buffer[i + 2]});
            }
            makeLittleEndian(std::span<Scalar>(buffer.data(), filled));
            sink.write({reinterpret_cast<const char *>(buffer.data()), filled * sizeof(Scalar)});
            filled = 0;
        }
        progress.advance(c.image.size.width);
    }
    return count;
}

/// The points of all other numbers, and points with colors.
/// @return as writeDepths
template <class Scalar>
std::size_t writeDistances(const Cloud &c, ByteSink &sink, Extent &extent, ProgressBar &progress)
{
    const DistanceCloud cloud(c.unprojection, c.lines, c.rows);
    const std::size_t width = c.image.size.width, height = c.image.size.height;
    PointRow row;
    std::string bytes;
    /// @param use  receives the index and the point of each pixel that has one
    const auto eachPoint = [&](std::size_t j, const auto &use) {
        cloud.row(j, row);
        for (std::size_t i = 0; i < width; ++i) {
            const double *of = row.coordinates.data() + 3 * i;
            const std::array<Scalar, 3> point{static_cast<Scalar>(of[0]), static_cast<Scalar>(of[1]),
                                              static_cast<Scalar>(of[2])};
            if (row.distances.kinds[i] == PixelKind::Kept
                && std::ranges::all_of(point, [](Scalar v) { return std::isfinite(v); }))
                use(j * width + i, point);
        }
    };
    std::size_t count = c.seen();
    if (cloud.canOverflow<Scalar>(c.setup, c.clip.value_or(ClipDistances{}))) {
        count = 0;
        for (std::size_t j = 0; j < height; ++j)
            eachPoint(j, [&](std::size_t, const auto &) { ++count; });
    }
    sink.write(plyHeader<Scalar>(count, c.colors.has_value()));
    for (std::size_t j = 0; j < height && sink.state() == ByteSink::State::Open; ++j) {
        bytes.clear();
        eachPoint(j, [&](std::size_t pixel, std::array<Scalar, 3> point) {
            extent.add({point[0], point[1], point[2]});
            makeLittleEndian(std::span<Scalar>(point));
            bytes.append(reinterpret_cast<const char *>(point.data()), sizeof(point));
            constexpr std::size_t kChannels = 3;
            if (c.colors)
                bytes.append(reinterpret_cast<const char *>(c.colors->colors.get() + kChannels * pixel), kChannels);
        });
        sink.write(bytes);
        progress.advance(width);
    }
    return count;
}

/// True for window depths in single precision, which need no conversion.
bool areWindowFloats(const images::NumberImage &image, const DepthNumbers &numbers)
{
    return numbers.meaning == DepthMeaning::Buffer && numbers.noData.empty()
           && std::holds_alternative<std::unique_ptr<float[]>>(image.numbers);
}

/// Reports what is assumed of the numbers, and the pixels without a point unless they are nothing
/// but background.
void reportNumbers(const Cloud &c)
{
    const auto say = [&](const std::string &what) { complain(c.source() + ": " + what); };
    if (!c.options.numbers.isMeaningGiven && c.image.greatest > 0.0)
        say(tr("the whole numbers are taken for depths of the window, as shares of %1 (--depth-is buffer); for "
               "distances give --depth-is z or distance",
               shortestText(c.image.greatest)));
    const std::size_t leftOut = pixelsOf(c.setup) - c.seen();
    const bool isBackground = !c.clip && leftOut == c.counts[static_cast<std::size_t>(PixelKind::AtFar)];
    if (leftOut > 0 && !isBackground)
        say(tr("left out: %1", leftOutText(c.counts, c.clip)));
    if (c.saturated > 0)
        say(tr(c.saturated == 1
                   ? "%1 pixel has a point by the greatest possible number, %2. Many cameras write it where "
                     "they measure nothing: --no-data %2 leaves it out"
                   : "%1 pixels have a point by the greatest possible number, %2. Many cameras write it "
                     "where they measure nothing: --no-data %2 leaves them out",
               c.saturated, shortestText(c.image.greatest)));
    if (c.seen() > 0)
        return;
    if (c.clip)
        say(tr("no pixel has a point: the scene shows distances from %1 to %2; check --depth-is and --depth-scale",
               shortestText(c.clip->atNear), shortestText(c.clip->atFar)));
    else if (!isBackground)
        say(tr("no pixel has a point: depths of the window lie from %1 to %2; for distances give --depth-is z or "
               "distance",
               shortestText(std::min(c.setup.depthRange.atNear, c.setup.depthRange.atFar)),
               shortestText(std::max(c.setup.depthRange.atNear, c.setup.depthRange.atFar))));
}

template <class Scalar>
ExitCode writeCloud(const Cloud &c, ByteSink &sink)
{
    ProgressBar progress(pixelsOf(c.setup), ProgressBar::Unit::Points);
    Extent extent;
    const bool isFast = areWindowFloats(c.image, c.options.numbers) && !c.colors;
    const std::size_t count =
        isFast ? writeDepths<Scalar>(c, sink, extent, progress) : writeDistances<Scalar>(c, sink, extent, progress);
    const ExitCode written = sink.finish();
    progress.finish();
    if (written != ExitCode::Done)
        return written;
    if (count < c.seen()) {
        constexpr bool isDouble = std::is_same_v<Scalar, double>;
        complain(c.source() + ": "
                 + tr(isDouble
                          ? "%1 points lie beyond the range of double precision"
                          : "%1 points lie beyond the range of single precision; --precision double reaches further",
                      c.seen() - count));
        return ExitCode::SomeRowsBad;
    }
    if (const double rounding = extent.floatRounding(); std::is_same_v<Scalar, float> && rounding > 0.0)
        complain(
            c.source() + ": "
            + tr(
                "so far from the origin single precision rounds coordinates by up to %1; --precision double keeps them",
                shortestText(rounding, 0.1 * rounding)));
    if (c.options.output != "-") // in a pipe the next program prints
        complain(c.options.output + ": "
                 + tr(count == 1 ? "%1 point of %2 pixels" : "%1 points of %2 pixels", count, pixelsOf(c.setup)));
    return ExitCode::Done;
}

/// Counts the pixels of each kind: PLY states the number of points first.
void count(Cloud &c)
{
    const images::NumberImage &image = c.image;
    if (areWindowFloats(image, c.options.numbers)) {
        const auto &floats = std::get<std::unique_ptr<float[]>>(image.numbers);
        const Surfaces surfaces(c.setup.depthRange);
        for (std::size_t j = 0; j < image.size.height; ++j)
            surfaces.count({floats.get() + image.start(j), image.size.width}, c.counts);
        return;
    }
    DistanceRow row;
    for (std::size_t j = 0; j < image.size.height; ++j) {
        c.rows.read(j, row);
        for (const PixelKind kind : row.kinds)
            ++c.counts[static_cast<std::size_t>(kind)];
        c.saturated += c.rows.saturated(j, row);
    }
}

ExitCode runCloud(CloudOptions &options)
{
    if (const std::string fault =
            faultOf(options.numbers, {"--depth-is", "--depth-scale", "--baseline", "--disparity-offset"});
        !fault.empty())
        refuse(fault);
    if (!options.size.empty()) {
        const cameras::ImageSize size = sizeGiven("--size", options.size);
        if (size.width < 1 || size.height < 1)
            refuse(tr("%1: width and height must be at least 1 pixel", "--size " + options.size));
        options.choices.size =
            images::PixelSize{static_cast<std::size_t>(size.width), static_cast<std::size_t>(size.height)};
    }
    const SceneFile scene = readScene(options.scene);
    const Setup g = setupOf(scene);
    const bool isMatrix = options.method == Method::Matrix;
    const BatchUnprojection unprojection =
        needed(isMatrix ? BatchUnprojection::byMatrix(g, {}) : BatchUnprojection::byFormula(g, {}), options.scene);
    PixelLines lines;
    std::optional<ClipDistances> clip;
    if (options.numbers.meaning != DepthMeaning::Buffer && options.numbers.meaning != DepthMeaning::Range) {
        lines = needed(isMatrix ? PixelLines::byMatrix(g) : PixelLines::byFormula(g), options.scene);
        clip = needed(clipDistances(g), options.scene);
        if (options.numbers.meaning == DepthMeaning::Disparity && !lines.isPerspective())
            refuse(options.scene + ": " + tr("a parallel projection has no disparities; give --depth-is z"));
    }
    InputFiles inputs = filesOf(scene, options.scene);
    inputs.push_back(options.depth);
    if (!options.color.empty())
        inputs.push_back(options.color);
    ByteSink sink(options.output, inputs); // an unwritable output is reported before the computation
    const images::PixelSize window{static_cast<std::size_t>(g.surface.widthPixels),
                                   static_cast<std::size_t>(g.surface.heightPixels)};
    std::optional<images::ColorImage> colors;
    if (!options.color.empty())
        colors = readColors(options.color, window);
    ProgressBar progress(pixelsOf(g), ProgressBar::Unit::Points);
    const images::NumberImage image =
        readDepthImage(options.depth, options.choices, window, [&](std::size_t count) { progress.advance(count); });
    progress.finish();
    const DepthRows rows(image, options.numbers, g, lines, clip.value_or(ClipDistances{}));
    Cloud cloud{options, g, unprojection, image, rows, lines, clip, std::move(colors)};
    count(cloud);
    reportNumbers(cloud);
    return options.precision == PointPrecision::Double ? writeCloud<double>(cloud, sink)
                                                       : writeCloud<float>(cloud, sink);
}

} // namespace

void addCloud(const Command &command)
{
    const auto options = std::make_shared<CloudOptions>();
    const auto finite = [](const std::string &given) {
        return finiteNumberIn(given) ? std::string() : tr("\"%1\" is not a finite number", given);
    };
    const auto positive = [](const std::string &given) {
        return finiteNumberIn(given).value_or(0.0) > 0.0 ? std::string() : tr("\"%1\" is not a number above 0", given);
    };
    command.file("SCENE", options->scene)->required();
    command.file("DEPTH", options->depth)->required();
    command.file("-o,--output", options->output)->required();
    command.file("--color", options->color);
    command.add("--size", options->size);
    command.add("--channel", options->choices.channel);
    command.choice("--byte-order", options->choices.byteOrder,
                   {{"little", std::endian::little}, {"big", std::endian::big}});
    command.choice("--depth-is", options->numbers.meaning,
                   {{"buffer", DepthMeaning::Buffer},
                    {"range", DepthMeaning::Range},
                    {"z", DepthMeaning::Z},
                    {"distance", DepthMeaning::Distance},
                    {"disparity", DepthMeaning::Disparity}});
    command.add("--depth-scale", options->numbers.scale)->check(positive);
    command.add("--baseline", options->numbers.baseline)->check(positive);
    command.add("--disparity-offset", options->numbers.disparityOffset)->check(finite);
    command.add("--no-data", options->numbers.noData)->delimiter(',')->allow_extra_args(false)->check(finite);
    command.choice("--method", options->method, {{"formula", Method::Formula}, {"matrix", Method::Matrix}});
    command.choice("--precision", options->precision,
                   {{"float", PointPrecision::Float}, {"double", PointPrecision::Double}});
    command.runs(options, [command](CloudOptions &given) {
        given.numbers.isMeaningGiven = command.has("--depth-is");
        return runCloud(given);
    });
}

} // namespace unprojector::cli
