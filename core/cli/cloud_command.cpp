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
#include <vector>

namespace unprojector {
namespace {

/// Whether a depth is of a surface: inside the range, and not the one that the buffer was cleared to, the far end's.
class Surfaces {
public:
    explicit Surfaces(const DepthRange &range)
        : m_low(static_cast<float>(std::min(range.atNear, range.atFar))),
          m_high(static_cast<float>(std::max(range.atNear, range.atFar))), m_background(static_cast<float>(range.atFar))
    {
    }
    bool has(float depth) const { return depth >= m_low && depth <= m_high && depth != m_background; }

private:
    float m_low, m_high, m_background;
};

/// Appends floats as PLY's binary_little_endian wants them.
void appendLittleEndian(std::string &bytes, std::vector<float> &values, std::size_t count)
{
    if constexpr (std::endian::native == std::endian::big) {
        for (std::size_t i = 0; i < count; ++i) {
            const auto bits = std::bit_cast<std::uint32_t>(values[i]);
            values[i] = std::bit_cast<float>(bits << 24 | (bits & 0xff00) << 8 | (bits >> 8 & 0xff00) | bits >> 24);
        }
    }
    bytes.append(reinterpret_cast<const char *>(values.data()), count * sizeof(float));
}

/// The points of one row at a time, so that everything stays in the processor's cache.
class RowUnprojection {
public:
    RowUnprojection(const BatchUnprojection &unprojection, const DepthImage &image, const Surfaces &surfaces)
        : m_unprojection(unprojection), m_image(image), m_surfaces(surfaces)
    {
        for (auto *column : {&m_px, &m_py, &m_depth, &m_x, &m_y, &m_z})
            column->resize(image.width);
        m_interleaved.resize(3 * image.width);
    }

    /// Unprojects the row j.
    /// @return how many of its points have finite coordinates; `points` holds those, x, y, z one after the other
    std::size_t unproject(std::size_t j)
    {
        const float *depths = m_image.depths.data() + j * m_image.width;
        std::size_t count = 0, kept = 0;
        for (std::size_t i = 0; i < m_image.width; ++i) {
            m_px[count] = static_cast<float>(i) + 0.5f;
            m_py[count] = static_cast<float>(j) + 0.5f;
            m_depth[count] = depths[i];
            count += m_surfaces.has(depths[i]) ? 1 : 0;
        }
        m_unprojection(BatchInput<float>{m_px.data(), m_py.data(), m_depth.data()},
                       BatchOutput<float>{m_x.data(), m_y.data(), m_z.data()}, count);
        for (std::size_t i = 0; i < count; ++i) {
            m_interleaved[3 * kept] = m_x[i];
            m_interleaved[3 * kept + 1] = m_y[i];
            m_interleaved[3 * kept + 2] = m_z[i];
            kept += std::isfinite(m_x[i]) && std::isfinite(m_y[i]) && std::isfinite(m_z[i]) ? 1 : 0;
        }
        return kept;
    }
    std::vector<float> &points() { return m_interleaved; }

private:
    const BatchUnprojection &m_unprojection;
    const DepthImage &m_image;
    const Surfaces &m_surfaces;
    std::vector<float> m_px, m_py, m_depth, m_x, m_y, m_z, m_interleaved;
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
    const auto &[dn, df] = g.depthRange;
    const std::optional<DepthImage> image =
        readDepthImage(options.depth, options.size, static_cast<std::size_t>(g.surface.widthPixels),
                       static_cast<std::size_t>(g.surface.heightPixels), std::min(dn, df), std::max(dn, df));
    if (!image)
        return ExitCode::UnusableInput;

    // PLY says first how many points there are.
    const Surfaces surfaces(g.depthRange);
    const auto seen = static_cast<std::size_t>(std::count_if(image->depths.begin(), image->depths.end(),
                                                             [&](float depth) { return surfaces.has(depth); }));
    RowUnprojection row(*unprojection, *image, surfaces);
    std::size_t count = seen;
    if (canOverflow(*unprojection, g)) {
        count = 0;
        for (std::size_t j = 0; j < image->height; ++j)
            count += row.unproject(j);
    }

    ByteSink sink(options.output);
    if (!sink.isOpen())
        return ExitCode::UnusableInput;
    sink.write("ply\nformat binary_little_endian 1.0\ncomment world coordinates\nelement vertex " + std::to_string(count)
               + "\nproperty float x\nproperty float y\nproperty float z\nend_header\n");
    std::string bytes;
    for (std::size_t j = 0; j < image->height && sink.state() == ByteSink::State::Open; ++j) {
        const std::size_t found = row.unproject(j);
        bytes.clear();
        appendLittleEndian(bytes, row.points(), 3 * found);
        sink.write(bytes);
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
