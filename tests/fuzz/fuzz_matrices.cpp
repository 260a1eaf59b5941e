// Matrices as other programs print them, pasted behind `unproject scene --from-matrices`.

#include "core/cli/commands/scene_command.h"
#include "core/cli/terminal/refusal.h"
#include "core/scene_file/scene_file.h"
#include "tests/fuzz/fuzzing.h"

#include <string>

using namespace unprojector;

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
    fuzz::silence();
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::filesystem::path made = fuzz::folder() / "made.json";
    cli::SceneOptions options;
    // Two words are the numbers themselves, never the name of a file.
    options.fromMatrices = {std::string(fuzz::text(data, size)), ""};
    if (size % 3 > 0)
        options.order = size % 3 == 1 ? cameras::NumberOrder::ByRows : cameras::NumberOrder::ByColumns;
    options.isReversed = size % 5 == 1;
    if (size % 7 < 2)
        options.isYDown = size % 7 == 1;
    options.output = made.string();
    try {
        if (runScene(options) == cli::ExitCode::Done)
            fuzz::require(scene_file::readSceneFile(made).hasValue(), "a scene that was made can be read");
    } catch (const cli::Refused &) { // the text has no matrices
    }
    return 0;
}
