// A depth image: PFM, PGM or raw floats.

#include "core/cli/rows/depth_image.h"
#include "tests/fuzz/fuzzing.h"

#include <span>
#include <string>

using namespace unprojector::cli;

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
    fuzz::silence();
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string file = fuzz::fileOf("depth.pfm", data, size).string();
    for (const char *given : {"", "3x2"}) {
        std::size_t seen = 0;
        const auto image = readDepthImage(file, given, 3, 2, DepthEnds{0.25, 0.75},
                                          [&](std::span<const float> depths) { seen += depths.size(); });
        if (!image)
            continue;
        fuzz::require(image->width == 3 && image->height == 2, "a picture has the size asked for");
        fuzz::require(seen == 6, "every depth is handed out once");
        float sum = 0.0f;
        for (std::size_t j = 0; j < image->height; ++j) {
            for (std::size_t i = 0; i < image->width; ++i)
                sum += image->row(j)[i];
        }
        static_cast<void>(sum);
    }
    return 0;
}
