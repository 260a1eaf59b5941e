#include "core/cli/cloud_command.h"

#include "core/cli/byte_stream.h"
#include "core/cli/core_error_text.h"
#include "core/cli/depth_cloud.h"
#include "core/cli/progress_bar.h"
#include "core/cli/scene_input.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace unprojector {
namespace {

/// Floats as PLY's binary_little_endian wants them.
void makeLittleEndian([[maybe_unused]] std::span<float> values)
{
    if constexpr (std::endian::native == std::endian::big)
        swapBytes(values);
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
    const auto pixels =
        static_cast<std::uint64_t>(g.surface.widthPixels) * static_cast<std::uint64_t>(g.surface.heightPixels);
    std::size_t seen = 0;
    std::optional<ProgressBar> progress(std::in_place, pixels, ProgressBar::Unit::Points);
    const std::optional<DepthImage> image =
        readDepthImage(options.depth, options.size, static_cast<std::size_t>(g.surface.widthPixels),
                       static_cast<std::size_t>(g.surface.heightPixels), std::min(dn, df), std::max(dn, df),
                       [&](std::span<const float> depths) {
                           seen += surfaces.countIn(depths);
                           progress->advance(depths.size());
                       });
    progress.reset();
    if (!image)
        return ExitCode::UnusableInput;

    DepthCloud cloud(*unprojection, g, *image);
    constexpr std::size_t kBufferFloats = std::size_t{1} << 16;
    const std::size_t rowFloats = 3 * image->width;
    std::vector<float> buffer(std::max(kBufferFloats, rowFloats));
    std::size_t count = seen;
    if (cloud.canOverflow()) {
        count = 0;
        for (std::size_t j = 0; j < image->height; ++j)
            count += cloud.row(j, buffer.data());
    }

    ByteSink sink(options.output);
    if (!sink.isOpen())
        return ExitCode::UnusableInput;
    sink.write("ply\nformat binary_little_endian 1.0\ncomment world coordinates\nelement vertex " + std::to_string(count)
               + "\nproperty float x\nproperty float y\nproperty float z\nend_header\n");
    std::size_t filled = 0;
    progress.emplace(pixels, ProgressBar::Unit::Points);
    for (std::size_t j = 0; j < image->height && sink.state() == ByteSink::State::Open; ++j) {
        filled += 3 * cloud.row(j, buffer.data() + filled);
        if (filled + rowFloats > buffer.size() || j + 1 == image->height) {
            makeLittleEndian({buffer.data(), filled});
            sink.write({reinterpret_cast<const char *>(buffer.data()), filled * sizeof(float)});
            filled = 0;
        }
        progress->advance(image->width);
    }
    sink.flush();
    progress.reset();
    if (sink.state() == ByteSink::State::Failed)
        return ExitCode::UnusableInput;
    if (count < seen) {
        complain(options.depth + ": " + std::to_string(seen - count) + " points lie beyond the range of single precision");
        return ExitCode::SomeRowsBad;
    }
    return ExitCode::Done;
}

} // namespace unprojector
