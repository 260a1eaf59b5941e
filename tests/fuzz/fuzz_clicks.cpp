// The clicks that the window prints: read, written, read again.

#include "core/scene_file/clicks.h"
#include "tests/fuzz/fuzzing.h"

using namespace unprojector::scene_file;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const auto read = parseSceneOrClicks(fuzz::text(data, size), "clicks.json");
    if (!read || !std::holds_alternative<std::vector<Click>>(*read))
        return 0;
    const auto written = clicksText(std::get<std::vector<Click>>(*read));
    fuzz::require(written.hasValue(), "what was read can be written");
    const auto again = parseSceneOrClicks(*written, "clicks.json");
    fuzz::require(again.hasValue() && std::holds_alternative<std::vector<Click>>(*again),
                  "what was written can be read");
    const auto writtenAgain = clicksText(std::get<std::vector<Click>>(*again));
    fuzz::require(writtenAgain.hasValue() && *writtenAgain == *written, "clicks read and written again stay the same");
    return 0;
}
