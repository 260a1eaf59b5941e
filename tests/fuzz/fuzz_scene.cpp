// A scene file: read, its curves led over a mesh, written, read again.

#include "core/scene_file/scene_file.h"
#include "tests/fuzz/curves_on_mesh.h"
#include "tests/fuzz/fuzzing.h"

using namespace unprojector::scene_file;

// The name is that which libFuzzer calls. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const auto scene = parseScene(fuzz::text(data, size), "scene.json");
    if (!scene)
        return 0;
    fuzz::leadCurves(scene->landmarks);
    const auto written = sceneText(*scene);
    fuzz::require(written.hasValue(), "what was read can be written");
    const auto again = parseScene(*written, "scene.json");
    fuzz::require(again.hasValue(), "what was written can be read");
    const auto writtenAgain = sceneText(*again);
    fuzz::require(writtenAgain.hasValue() && *writtenAgain == *written,
                  "a scene read and written again stays the same");
    return 0;
}
