// Matrices as other programs print them, pasted behind `unproject scene --from-matrices`.

#include "core/cli/scene_command.h"
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
    options.isRowByRow = size % 2 == 1;
    options.output = made.string();
    if (runScene(options) == cli::ExitCode::Done)
        fuzz::require(scene_file::readSceneFile(made).hasValue(), "a scene that was made can be read");
    return 0;
}
