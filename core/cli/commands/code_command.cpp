#include "core/cli/commands/command.h"
#include "core/cli/rows/scene_input.h"
#include "core/cli/terminal/refusal.h"
#include "core/scene_code/scene_code.h"

#include <memory>
#include <string>

namespace unprojector::cli {
using namespace scene_file;
using scene_code::CodeDialect;
namespace {

struct CodeOptions {
    std::string scene;
    CodeDialect dialect = CodeDialect::Glu;
    std::string output = "-";
};

ExitCode runCode(const CodeOptions &options)
{
    const SceneFile scene = readScene(options.scene);
    ByteSink sink(options.output, filesOf(scene, options.scene));
    sink.write(scene_code::sceneCode(scene, options.dialect));
    return sink.finish();
}

} // namespace

void addCode(const Command &command)
{
    const auto options = std::make_shared<CodeOptions>();
    command.file("SCENE", options->scene)->required();
    command.choice("--for", options->dialect,
                   {{"glu", CodeDialect::Glu},
                    {"glm", CodeDialect::Glm},
                    {"qt", CodeDialect::Qt},
                    {"three", CodeDialect::ThreeJs},
                    {"numpy", CodeDialect::NumPy}});
    command.file("-o,--output", options->output)->default_str("-");
    command.runs(options, runCode);
}

} // namespace unprojector::cli
