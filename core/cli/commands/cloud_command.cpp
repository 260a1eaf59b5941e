#include "core/cli/commands/cloud_command.h"

#include "core/cli/rows/byte_stream.h"
#include "core/cli/rows/depth_cloud.h"
#include "core/cli/rows/scene_input.h"
#include "core/cli/terminal/progress_bar.h"
#include "core/text/error_text.h"
#include "core/text/number_text.h"
#include "core/text/translation.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace unprojector::cli {
using namespace geometry;
using namespace scene_file;
using namespace unproject;
using namespace text;
namespace {

/// Converts numbers to PLY's binary_little_endian.
template <class Scalar>
void makeLittleEndian([[maybe_unused]] std::span<Scalar> values)
{
    if constexpr (std::endian::native == std::endian::big)
        swapBytes(values);
}

std::uint64_t pixelsOf(const Setup &g)
{
    return static_cast<std::uint64_t>(g.surface.widthPixels) * static_cast<std::uint64_t>(g.surface.heightPixels);
}

template <class Scalar>
std::string plyHeader(std::size_t count)
{
    const std::string property = std::is_same_v<Scalar, double> ? "property double " : "property float ";
    return "ply\nformat binary_little_endian 1.0\ncomment world coordinates\nelement vertex " + std::to_string(count)
           + '\n' + property + "x\n" + property + "y\n" + property + "z\nend_header\n";
}

/// The extent of the written points.
class Extent {
public:
    /// @param numbers  x, y, z of each point in turn
    template <class Scalar>
    void add(std::span<const Scalar> numbers)
    {
        for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double value = numbers[i + axis];
                m_lowest[axis] = std::min(m_lowest[axis], value);
                m_highest[axis] = std::max(m_highest[axis], value);
            }
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

/// @param seen  number of depths on a surface
template <class Scalar>
ExitCode writeCloud(const CloudOptions &options, ByteSink &sink, const BatchUnprojection &unprojection, const Setup &g,
                    const DepthImage &image, std::size_t seen)
{
    const DepthCloud<Scalar> cloud(unprojection, g, image);
    constexpr std::size_t kBufferNumbers = std::size_t{1} << 16;
    const std::size_t rowNumbers = 3 * image.width;
    std::vector<Scalar> buffer(std::max(kBufferNumbers, rowNumbers));
    std::size_t count = seen;
    if (cloud.canOverflow()) {
        count = 0;
        for (std::size_t j = 0; j < image.height; ++j)
            count += cloud.row(j, buffer.data());
    }

    sink.write(plyHeader<Scalar>(count));
    ProgressBar progress(pixelsOf(g), ProgressBar::Unit::Points);
    std::size_t filled = 0;
    Extent extent;
    for (std::size_t j = 0; j < image.height && sink.state() == ByteSink::State::Open; ++j) {
        filled += 3 * cloud.row(j, buffer.data() + filled);
        if (filled + rowNumbers > buffer.size() || j + 1 == image.height) {
            if constexpr (std::is_same_v<Scalar, float>)
                extent.add(std::span<const Scalar>(buffer.data(), filled));
            makeLittleEndian(std::span<Scalar>(buffer.data(), filled));
            sink.write({reinterpret_cast<const char *>(buffer.data()), filled * sizeof(Scalar)});
            filled = 0;
        }
        progress.advance(image.width);
    }
    const ExitCode written = sink.finish();
    progress.finish();
    if (written != ExitCode::Done)
        return written;
    const std::string source = options.depth == "-" ? "stdin" : options.depth;
    if (count < seen) {
        constexpr bool isDouble = std::is_same_v<Scalar, double>;
        complain(source + ": "
                 + tr(isDouble
                          ? "%1 points lie beyond the range of double precision"
                          : "%1 points lie beyond the range of single precision; --precision double reaches further",
                      seen - count));
        return ExitCode::SomeRowsBad;
    }
    if (const double rounding = extent.floatRounding(); rounding > 0.0)
        complain(
            source + ": "
            + tr(
                "so far from the origin single precision rounds coordinates by up to %1; --precision double keeps them",
                shortestText(rounding, 0.1 * rounding)));
    if (options.output != "-") // in a pipe the next program prints
        complain(options.output + ": "
                 + tr(count == 1 ? "%1 point of %2 pixels" : "%1 points of %2 pixels", count, pixelsOf(g)));
    return ExitCode::Done;
}

} // namespace

ExitCode runCloud(const CloudOptions &options)
{
    const std::optional<SceneFile> scene = readScene(options.scene);
    if (!scene)
        return ExitCode::UnusableInput;
    const Setup g = setupOf(*scene);
    const Result<BatchUnprojection> unprojection =
        options.method == Method::Matrix ? BatchUnprojection::byMatrix(g, {}) : BatchUnprojection::byFormula(g, {});
    if (!unprojection) {
        complain(options.scene + ": " + errorText(unprojection.error()));
        return ExitCode::UnusableInput;
    }
    InputFiles inputs = filesOf(*scene, options.scene);
    inputs.push_back(options.depth);
    ByteSink sink(options.output, inputs); // an unwritable output is reported before the computation
    if (!sink.isOpen())
        return ExitCode::UnusableInput;
    // PLY states the number of points first, so they are counted while they are read.
    const auto &[dn, df] = g.depthRange;
    const Surfaces surfaces(g.depthRange);
    std::size_t seen = 0;
    ProgressBar progress(pixelsOf(g), ProgressBar::Unit::Points);
    std::optional<DepthEnds> ends;
    if (options.depths == DepthNumbers::Range)
        ends = {std::min(dn, df), std::max(dn, df)};
    const std::optional<DepthImage> image =
        readDepthImage(options.depth, options.size, static_cast<std::size_t>(g.surface.widthPixels),
                       static_cast<std::size_t>(g.surface.heightPixels), ends, [&](std::span<const float> depths) {
                           seen += surfaces.countIn(depths);
                           progress.advance(depths.size());
                       });
    progress.finish();
    if (!image)
        return ExitCode::UnusableInput;
    return options.precision == PointPrecision::Double
               ? writeCloud<double>(options, sink, *unprojection, g, *image, seen)
               : writeCloud<float>(options, sink, *unprojection, g, *image, seen);
}

} // namespace unprojector::cli
