#include "core/cli/command_line.h"

#include "core/cli/cloud_command.h"
#include "core/cli/compare_command.h"
#include "core/cli/matrices_command.h"
#include "core/cli/points_command.h"
#include "core/cli/project_command.h"
#include "core/cli/scene_command.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace unprojector {
namespace {

using Run = std::function<ExitCode()>;

template <class Choice>
void addChoice(CLI::App &command, const std::string &name, Choice &target, const std::map<std::string, Choice> &choices,
               const std::string &description)
{
    std::string names;
    for (const auto &choice : choices)
        names += (names.empty() ? "" : ", ") + choice.first;
    command.add_option_function<std::string>(
               name, [&target, choices](const std::string &given) { target = choices.at(given); },
               description + ": " + names)
        ->check([choices, names](const std::string &given) {
            return choices.contains(given) ? std::string() : '"' + given + "\" is none of " + names;
        });
}

/// The options of commands that take rows.
void addRowOptions(CLI::App &command, RowOptions &options, const std::string &columns, const std::string &spaces)
{
    command.add_option("SCENE", options.scene, "Scene file (JSON)")->required();
    command.add_option("POINTS", options.input, "CSV with the columns " + columns);
    command.add_option("--space", options.space, "Where the points lie: " + spaces)->default_str("world");
    addChoice<RowFormat>(command, "--format", options.format, {{"csv", RowFormat::Csv}, {"jsonl", RowFormat::Jsonl}},
                         "How to write");
    command.add_flag("--no-header", options.isHeaderless, "Write rows only, to put several results behind each other");
    command.add_option("--threads", options.threads, "How many threads compute")
        ->check(CLI::Range(1, 64))
        ->default_str("2");
}

void addPoints(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("points", "Pixels and depths to points, by the formulas and by the inverted matrix");
    auto options = std::make_shared<PointsOptions>();
    addRowOptions(
        *command, options->rows,
        "px,py,depth; - or nothing: standard input. px and py are device pixels from the top left corner, the "
        "centre of the first pixel is 0.5,0.5",
        "eye, world or object:NAME");
    addChoice<Methods>(*command, "--method", options->methods,
                       {{"both", Methods::Both}, {"formula", Methods::Formula}, {"matrix", Methods::Matrix}},
                       "How to compute");
    command->add_flag("--pixel", options->isPixel,
                      "px and py are whole indices of pixels; their centres are meant (1/2 is added)");
    command->footer("Examples:\n"
                    "  unproject points scene.json clicks.csv > points.csv\n"
                    "  printf 'px,py,depth\\n400,300,0.5\\n' | unproject points scene.json -\n"
                    "  unproject points --method formula --space eye --pixel --format jsonl scene.json pixels.csv\n"
                    "\n"
                    "A row that cannot be computed has empty cells and a line on stderr; the others go on.");
    command->callback([options, &run] { run = [options] { return runPoints(*options); }; });
}

void addProject(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("project", "Points to the window, every stage on the way");
    auto options = std::make_shared<RowOptions>();
    addRowOptions(*command, *options, "x,y,z; - or nothing: standard input", "world or object:NAME");
    command->footer("The stages: eye, clip, ndc, window (device pixels from the bottom left corner), widget (logical pixels\n"
                    "from the top left corner); px,py,depth are what 'unproject points' takes.\n"
                    "\n"
                    "Examples:\n"
                    "  printf 'x,y,z\\n0,0,0\\n' | unproject project scene.json\n"
                    "  unproject project scene.json points.csv | unproject points scene.json");
    command->callback([options, &run] { run = [options] { return runProject(*options); }; });
}

void addMatrices(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("matrices", "All matrices of a scene");
    auto options = std::make_shared<MatricesOptions>();
    command->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
    addChoice<MatrixLayout>(*command, "--layout", options->layout,
                            {{"column", MatrixLayout::Column}, {"row", MatrixLayout::Row}},
                            "Column vectors, M v, or row vectors, v M");
    addChoice<MatricesFormat>(*command, "--format", options->format,
                              {{"text", MatricesFormat::Text},
                               {"json", MatricesFormat::Json},
                               {"c", MatricesFormat::C},
                               {"numpy", MatricesFormat::NumPy},
                               {"latex", MatricesFormat::Latex}},
                              "How to write");
    command->footer("C arrays have OpenGL's order in memory in either layout.\n"
                    "\n"
                    "Examples:\n"
                    "  unproject matrices scene.json\n"
                    "  unproject matrices --format numpy --layout row scene.json > matrices.py");
    command->callback([options, &run] { run = [options] { return runMatrices(*options); }; });
}

void addCompare(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("compare", "How far both methods are from the truth");
    auto options = std::make_shared<CompareOptions>();
    command->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
    command->add_flag("--json", options->isJson, "Write JSON instead of a table");
    command->add_option("--pixels", options->pixels, "Pixels across and down of the grid")
        ->check(CLI::Range(1, 1000))->default_str("32");
    command->add_option("--depths", options->depths, "Depths of the grid, from one end to the other")
        ->check(CLI::Range(1, 1000))->default_str("17");
    command->footer("Formula and matrix, in double and in single precision, against the same picture computed with 50 digits.\n"
                    "\n"
                    "Example:\n"
                    "  unproject compare scene.json");
    command->callback([options, &run] { run = [options] { return runCompare(*options); }; });
}

void addCloud(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("cloud", "A whole depth image to a point cloud in world space");
    auto options = std::make_shared<CloudOptions>();
    command->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
    command->add_option("DEPTH", options->depth, "Depths of the window: PFM, 16-bit PGM, or raw 32-bit floats row by row "
                                                 "from the top; - is standard input")->required();
    command->add_option("-o,--output", options->output, "Binary PLY; - is standard output")->required();
    command->add_option("--size", options->size, "Of raw floats, in pixels: WxH");
    addChoice<Methods>(*command, "--method", options->method,
                       {{"formula", Methods::Formula}, {"matrix", Methods::Matrix}}, "How to compute");
    command->footer("Pixels at the far end of the depth range are background and left out, and so are depths outside it.\n"
                    "\n"
                    "Examples:\n"
                    "  unproject cloud scene.json depth.pfm -o cloud.ply\n"
                    "  unproject cloud --size 1920x1080 scene.json depth.raw -o cloud.ply");
    command->callback([options, &run] { run = [options] { return runCloud(*options); }; });
}

void addScene(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("scene", "A scene file from another program's matrices");
    auto options = std::make_shared<SceneOptions>();
    command->add_option("--from-matrices", options->fromMatrices,
                        "Modelview (16 numbers), projection (16) and viewport (4: x y width height), or a text file that "
                        "has them; - is standard input. In this order, or each behind its name")
        ->required()->expected(1, 64);
    addChoice<bool>(*command, "--order", options->isRowByRow, {{"column", false}, {"row", true}},
                    "How the 16 numbers follow each other, column by column (as OpenGL has them) or row by row");
    command->add_option("--window", options->window, "The window's size in pixels, WxH; without it, what the viewport needs");
    command->add_option("-o,--output", options->output, "Scene file; - is standard output")->default_str("-");
    command->footer("Brackets, commas and other words between the numbers are passed over.\n"
                    "\n"
                    "Examples:\n"
                    "  unproject scene --from-matrices matrices.txt -o scene.json\n"
                    "  unproject scene --from-matrices \"modelview 1 0 0 0  0 1 0 0  0 0 1 0  0 0 -5 1\n"
                    "      projection 1 0 0 0  0 1 0 0  0 0 -1.2 -1  0 0 -2.2 0  viewport 0 0 800 600\"");
    command->callback([options, &run] { run = [options] { return runScene(*options); }; });
}

} // namespace

ExitCode runCommandLine(const std::vector<std::string> &arguments)
{
    CLI::App app("The world coordinates under pixels, computed twice: by formulas in closed form and by the inverted matrix.",
                 "unproject");
    app.require_subcommand(1);
    app.footer("unproject COMMAND --help says more.\n\nExit code: 0 done, 1 some rows bad, 2 unusable input.");
    Run run;
    addPoints(app, run);
    addProject(app, run);
    addScene(app, run);
    addCloud(app, run);
    addCompare(app, run);
    addMatrices(app, run);
    try {
        std::vector<const char *> words;
        for (const std::string &argument : arguments)
            words.push_back(argument.c_str());
        app.parse(static_cast<int>(words.size()), words.data());
    } catch (const CLI::ParseError &error) {
        return app.exit(error) == 0 ? ExitCode::Done : ExitCode::UnusableInput;
    }
    return run();
}

} // namespace unprojector
