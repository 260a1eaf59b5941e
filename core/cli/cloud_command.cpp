#include "core/cli/cloud_command.h"

#include "core/batch_unproject.h"
#include "core/cli/byte_stream.h"
#include "core/cli/core_error_text.h"
#include "core/cli/depth_image.h"
#include "core/cli/scene_input.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace unprojector {
namespace {

/// Which depths are of a surface: inside the range, and not the one that the buffer was cleared to, the far end's.
/// Two comparisons and no jump: loops over millions of depths ask.
class Surfaces {
public:
    explicit Surfaces(const DepthRange &range)
    {
        const auto atNear = static_cast<float>(range.atNear), atFar = static_cast<float>(range.atFar);
        const float beforeFar = std::nextafter(atFar, atNear);
        m_low = std::min(atNear, beforeFar);
        m_high = std::max(atNear, beforeFar);
    }

    std::size_t countIn(std::span<const float> depths) const
    {
        std::uint32_t count = 0; // of 32 bits, as the depths, so that they are compared side by side
        for (const float depth : depths)
            count += has(depth);
        return count;
    }

    /// 1 for each depth that is of one, 0 for the others.
    void mark(std::span<const float> depths, std::uint32_t *marks) const
    {
        const Surfaces self = *this; // no mark written can change it
        for (std::size_t i = 0; i < depths.size(); ++i)
            marks[i] = self.has(depths[i]);
    }

private:
    std::uint32_t has(float depth) const { return std::uint32_t(depth >= m_low) & std::uint32_t(depth <= m_high); }

    float m_low, m_high;
};

/// Floats as PLY's binary_little_endian wants them.
void makeLittleEndian([[maybe_unused]] std::span<float> values)
{
    if constexpr (std::endian::native == std::endian::big)
        swapBytes(values);
}

/// The points of one row at a time, so that everything stays in the processor's cache.
class RowUnprojection {
public:
    RowUnprojection(const BatchUnprojection &unprojection, const DepthImage &image, const Surfaces &surfaces,
                    bool canOverflow)
        : m_unprojection(unprojection), m_image(image), m_surfaces(surfaces), m_canOverflow(canOverflow)
    {
        for (auto *column : {&m_px, &m_py, &m_x, &m_y, &m_z})
            column->resize(image.width);
        m_marks.resize(image.width);
        for (std::size_t i = 0; i < image.width; ++i)
            m_px[i] = static_cast<float>(i) + 0.5f;
    }

    /// Unprojects the row j, background and all: that costs less than picking the rest out first.
    /// @param points  room for as many points as the row has pixels; x, y, z one after the other
    /// @return how many of them are of a surface and have finite coordinates
    std::size_t operator()(std::size_t j, float *points)
    {
        const float *depths = m_image.row(j);
        std::fill(m_py.begin(), m_py.end(), static_cast<float>(j) + 0.5f);
        m_unprojection(BatchInput<float>{m_px.data(), m_py.data(), depths},
                       BatchOutput<float>{m_x.data(), m_y.data(), m_z.data()}, m_image.width);
        m_surfaces.mark({depths, m_image.width}, m_marks.data());
        if (m_canOverflow)
            unmarkInfinite();
        return gathered(points);
    }

private:
    void unmarkInfinite()
    {
        for (std::size_t i = 0; i < m_image.width; ++i)
            m_marks[i] &= std::uint32_t(std::isfinite(m_x[i]) && std::isfinite(m_y[i]) && std::isfinite(m_z[i]));
    }

    std::size_t gathered(float *points) const
    {
        const float *x = m_x.data(), *y = m_y.data(), *z = m_z.data();
        std::size_t kept = 0;
        for (std::size_t i = 0; i < m_image.width; ++i) {
            points[3 * kept] = x[i];
            points[3 * kept + 1] = y[i];
            points[3 * kept + 2] = z[i];
            kept += m_marks[i];
        }
        return kept;
    }

    const BatchUnprojection &m_unprojection;
    const DepthImage &m_image;
    const Surfaces &m_surfaces;
    const bool m_canOverflow;
    std::vector<float> m_px, m_py, m_x, m_y, m_z;
    std::vector<std::uint32_t> m_marks;
};

/// Whether the numbers of some pixel could leave the range of single precision: those in between the window's corners and
/// the ends of the depth range lie between theirs.
bool canOverflow(const BatchUnprojection &unprojection, const PictureGeometry &g)
{
    const double w = g.surface.widthPixels, h = g.surface.heightPixels, n = g.depthRange.atNear, f = g.depthRange.atFar;
    const std::array<double, 8> px{0, w, 0, w, 0, w, 0, w}, py{0, 0, h, h, 0, 0, h, h}, depth{n, n, n, n, f, f, f, f};
    std::array<double, 8> x, y, z;
    unprojection(BatchInput<double>{px.data(), py.data(), depth.data()},
                 BatchOutput<double>{x.data(), y.data(), z.data()}, px.size());
    constexpr double kSafe = 1e38;
    for (const auto &column : {x, y, z}) {
        for (const double value : column) {
            if (!(std::abs(value) < kSafe))
                return true;
        }
    }
    return false;
}

} // namespace

ExitCode runCloud(const CloudOptions &options)
{
    const std::optional<SceneInput> scene = sceneInput(options.scene);
    if (!scene)
        return ExitCode::UnusableInput;
    const PictureGeometry &g = scene->geometry;
    const Result<BatchUnprojection> unprojection = options.method == Methods::Matrix
                                                       ? BatchUnprojection::byMatrix(g, {})
                                                       : BatchUnprojection::byFormula(g, {});
    if (!unprojection) {
        complain(options.scene + ": " + errorText(unprojection.error()));
        return ExitCode::UnusableInput;
    }
    // PLY says first how many points there are: they are counted as they come.
    const auto &[dn, df] = g.depthRange;
    const Surfaces surfaces(g.depthRange);
    std::size_t seen = 0;
    const std::optional<DepthImage> image =
        readDepthImage(options.depth, options.size, static_cast<std::size_t>(g.surface.widthPixels),
                       static_cast<std::size_t>(g.surface.heightPixels), std::min(dn, df), std::max(dn, df),
                       [&](std::span<const float> depths) { seen += surfaces.countIn(depths); });
    if (!image)
        return ExitCode::UnusableInput;

    RowUnprojection pointsOfRow(*unprojection, *image, surfaces, canOverflow(*unprojection, g));
    constexpr std::size_t kBufferFloats = std::size_t{1} << 16;
    const std::size_t rowFloats = 3 * image->width;
    std::vector<float> buffer(std::max(kBufferFloats, rowFloats));
    std::size_t count = seen;
    if (canOverflow(*unprojection, g)) {
        count = 0;
        for (std::size_t j = 0; j < image->height; ++j)
            count += pointsOfRow(j, buffer.data());
    }

    ByteSink sink(options.output);
    if (!sink.isOpen())
        return ExitCode::UnusableInput;
    sink.write("ply\nformat binary_little_endian 1.0\ncomment world coordinates\nelement vertex " + std::to_string(count)
               + "\nproperty float x\nproperty float y\nproperty float z\nend_header\n");
    std::size_t filled = 0;
    for (std::size_t j = 0; j < image->height && sink.state() == ByteSink::State::Open; ++j) {
        filled += 3 * pointsOfRow(j, buffer.data() + filled);
        if (filled + rowFloats > buffer.size() || j + 1 == image->height) {
            makeLittleEndian({buffer.data(), filled});
            sink.write({reinterpret_cast<const char *>(buffer.data()), filled * sizeof(float)});
            filled = 0;
        }
    }
    sink.flush();
    if (sink.state() == ByteSink::State::Failed)
        return ExitCode::UnusableInput;
    if (count < seen) {
        complain(options.depth + ": " + std::to_string(seen - count) + " points lie beyond the range of single precision");
        return ExitCode::SomeRowsBad;
    }
    return ExitCode::Done;
}

} // namespace unprojector
