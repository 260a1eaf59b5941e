#include "core/cli/commands/code_command.h"

#include "core/cli/rows/byte_stream.h"
#include "core/cli/rows/scene_input.h"

#include <optional>

namespace unprojector::cli {
using namespace scene_file;

ExitCode runCode(const CodeOptions &options)
{
    const std::optional<SceneFile> scene = readScene(options.scene);
    if (!scene)
        return ExitCode::UnusableInput;
    ByteSink sink(options.output, filesOf(*scene, options.scene));
    if (!sink.isOpen())
        return ExitCode::UnusableInput;
    sink.write(scene_code::sceneCode(*scene, options.dialect));
    return sink.finish();
}

} // namespace unprojector::cli
