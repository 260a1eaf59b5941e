// A depth image of any format, and colors.

#include "core/cli/rows/depth_image.h"
#include "tests/fuzz/fuzzing.h"

#include <bit>
#include <optional>
#include <string>
#include <variant>

using namespace unprojector;
using namespace unprojector::cli;

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
    fuzz::silence();
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string file = fuzz::fileOf("depth", data, size).string();
    for (const DepthImageChoices &given :
         {DepthImageChoices{}, DepthImageChoices{images::PixelSize{3, 2}, {}, std::endian::big},
          DepthImageChoices{{}, "Z", {}}, DepthImageChoices{{}, {}, std::endian::little}}) {
        std::size_t seen = 0;
        std::optional<images::NumberImage> image;
        try {
            image = readDepthImage(file, given, {3, 2}, [&](std::size_t count) { seen += count; });
        } catch (const Refused &) { // the file
            continue;
        }
        fuzz::require(image->size.pixels() == 6, "an image has the size asked for");
        fuzz::require(seen == 6, "every pixel is reported once");
        double sum = 0.0;
        std::visit(
            [&](const auto &numbers) {
                for (std::size_t j = 0; j < 2; ++j) {
                    for (std::size_t i = 0; i < 3; ++i)
                        sum += static_cast<double>(numbers[image->start(j) + i]);
                }
            },
            image->numbers);
        static_cast<void>(sum);
    }
    try {
        const images::ColorImage colors = readColors(file, {3, 2});
        unsigned sum = 0;
        for (std::size_t i = 0; i < 18; ++i)
            sum += colors.colors[i];
        static_cast<void>(sum);
    } catch (const Refused &) { // the file
    }
    return 0;
}
