// The commands that go from pixels to points and back.

#include "core/cli/commands/cloud_command.h"
#include "core/cli/commands/doctor_command.h"
#include "core/cli/commands/pick_command.h"
#include "core/cli/commands/points_command.h"
#include "core/cli/commands/project_command.h"
#include "core/cli/commands/usage.h"
#include "core/cli/commands/usage_options.h"

#include <memory>
#include <string>
#include <vector>

namespace unprojector::cli {
using namespace unproject;
using text::tr;
namespace {

/// The options of commands that take rows.
void addRowOptions(CLI::App &command, RowOptions &options, const std::string &columns)
{
    addSceneFile(command, options.scene);
    addFile(command, "POINTS", options.input, columns);
    command.add_option("--space", options.space, tr("Where the points lie: world, eye or object:NAME"))
        ->default_str("world");
    addChoice<RowFormat>(command, "--format", options.format, {{"csv", RowFormat::Csv}, {"jsonl", RowFormat::Jsonl}},
                         tr("How to write"));
    command.add_flag("--no-header", options.isHeaderless,
                     tr("Write rows only, to put several results behind each other"));
    addSpreadsheetSafe(command, options.isSpreadsheetSafe);
    addCount(command, "--threads", options.threads, 64, tr("How many threads compute"));
}

/// The format of two options together.
template <class Options>
RowFormat formatOf(const Options &options)
{
    return options.isSpreadsheetSafe && options.format == RowFormat::Csv ? RowFormat::SafeCsv : options.format;
}

std::string badRows()
{
    return "\n\n"
           + tr("Other columns (names, notes) pass through unchanged, each where it stands; one that has the name of a "
                "result is\nwritten anew.\n\nA row that cannot be computed has empty cells and a line on stderr; the "
                "others go on, and the exit code is 1.");
}

} // namespace

void addPoints(CLI::App &app, Run &run)
{
    CLI::App *command =
        app.add_subcommand("points", tr("Pixels and depths to points, by the formulas and by the inverted matrix"));
    auto options = std::make_shared<PointsOptions>();
    addRowOptions(
        *command, options->rows,
        tr("CSV with the columns px,py,depth; - or nothing: standard input.\npx and py are device pixels from "
           "the top left corner, the centre of the\nfirst pixel is 0.5,0.5; depth is in the depth range"));
    addChoice<std::vector<Method>>(*command, "--method", options->methods,
                                   {{"all", {kMethods.begin(), kMethods.end()}},
                                    {"both", {Method::Formula, Method::Matrix}},
                                    {"formula", {Method::Formula}},
                                    {"matrix", {Method::Matrix}},
                                    {"matrixInFloat", {Method::MatrixInFloat}}},
                                   tr("How to compute"));
    command->add_flag("--pixel", options->isPixel,
                      tr("px and py are whole indices of pixels; their centres are meant (1/2 is added)"));
    command->footer(
        tr("Clicks that 'unprojector --screenshot' printed are taken as they are: instead of SCENE and POINTS give\n"
           "their file. Each is computed with its own scene, to the digits that were printed. A click on the\n"
           "background has no point: its cells are empty, as those of a bad row. With POINTS, - too, it is the rows\n"
           "that are computed, with the scene of the clicks.\n"
           "\n"
           "The columns have the same names in every space: give 'unproject project' the same --space.")
        + "\n\n" + tr("Examples:")
        + "\n  unproject points scene.json clicks.csv > points.csv\n  unproject points clicks.json\n  printf "
          "'px,py,depth\\n400,300,0.5\\n' | unproject points scene.json -\n  unproject points --method formula --space "
          "eye --pixel --format jsonl scene.json pixels.csv\n  parallel -k --pipe --header : unproject points "
          "--no-header scene.json - < many.csv > rows.csv"
        + badRows());
    command->callback([options, command, &run] {
        options->rows.isInputGiven = command->get_option("POINTS")->count() > 0;
        options->rows.format = formatOf(options->rows);
        run = [options] { return runPoints(*options); };
    });
}

void addPick(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("pick", tr("Pixels to what their rays meet, on the mesh itself"));
    auto options = std::make_shared<PickOptions>();
    addModelOrScene(*command, options->scene);
    CLI::Option *input = addFile(*command, "PIXELS", options->input,
                                 tr("CSV with the columns px,py; - or nothing: standard input. px and py are device\n"
                                    "pixels from the top left corner, the centre of the first pixel is 0.5,0.5"));
    CLI::Option *at =
        command->add_option("--at", options->positions, tr("A position instead of PIXELS; may be given again"))
            ->type_name("X,Y")
            ->allow_extra_args(false)
            ->excludes(input);
    command
        ->add_option("--size", options->size,
                     tr("Of the picture in device pixels. Without it: a scene file's own, 800x600 of a\nmodel"))
        ->type_name("WxH");
    addChoice<ray::Snap>(*command, "--snap", options->snap,
                         {{"surface", ray::Snap::Surface},
                          {"vertex", ray::Snap::Vertex},
                          {"edge", ray::Snap::Edge},
                          {"face", ray::Snap::Face}},
                         tr("What is taken: what the ray meets, or the nearest in sight within 8 pixels"));
    command->add_flag("--json", options->isJson, tr("Of --at: one JSON object a position, one a line"))->needs(at);
    addChoice<RowFormat>(*command, "--format", options->format, {{"csv", RowFormat::Csv}, {"jsonl", RowFormat::Jsonl}},
                         tr("How to write rows"))
        ->excludes(at);
    command
        ->add_flag("--no-header", options->isHeaderless,
                   tr("Write rows only, to put several results behind each other"))
        ->excludes(at);
    addSpreadsheetSafe(*command, options->isSpreadsheetSafe)->excludes(at);
    command->add_option("--threads", options->threads, tr("How many threads compute, 1 to 64; without it, one a core"))
        ->type_name("N")
        ->check(wholeNumber(64));
    command->footer(
        tr("No window and no OpenGL: the triangle that the ray meets is intersected in double precision. A model is "
           "seen as the\n"
           "window starts with it, a scene file as it says. What is hidden, clipped away or outside the picture is not "
           "met;\n"
           "a position outside the picture is said, and makes the exit code 1.\n"
           "\n"
           "Triangles and vertices count from 0, through all meshes of an object: triangles in the file's order, "
           "polygons\n"
           "cut where they stand, so that edges and faces are those of triangles; vertices in the file's order.\n"
           "'uncertainty' (dx, dy, dz) is how far the point may be off what the file says, by rounding in double "
           "precision;\n"
           "what a pixel covers is not in it. A row whose ray meets nothing has empty cells. Points\n"
           "of a cloud are taken where their dot of 3 pixels is met, else, where no surface is, within 8 pixels; they "
           "have\n"
           "no triangle, normal and edge.")
        + "\n\n" + tr("Examples:")
        + "\n  unproject pick scan.ply --at 400.5,300.5\n  unproject pick --json --snap vertex scene.json --at "
          "400.5,300.5 --at 10.5,20.5\n  unproject pick scene.json pixels.csv > points.csv"
        + badRows());
    command->callback([options, &run] {
        options->format = formatOf(*options);
        run = [options] { return runPick(*options); };
    });
}

void addProject(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("project", tr("Points to the window, every stage on the way"));
    auto options = std::make_shared<RowOptions>();
    addRowOptions(
        *command, *options,
        tr("CSV with the columns x,y,z, or formula_x,formula_y,formula_z as 'unproject points' writes them; - "
           "or\nnothing: standard input. They lie in the space that --space names"));
    command->footer(
        tr("The stages: eye, clip, ndc, window (device pixels from the bottom left corner), widget (logical pixels\n"
           "from the top left corner); px,py,depth are what 'unproject points' takes. All of them are OpenGL's, with y "
           "up,\n"
           "whatever \"conventions\" the scene has; ndc_z goes by the depths of its projection, -1 to 1 or 0 to 1.")
        + "\n\n" + tr("Examples:")
        + "\n  printf 'x,y,z\\n0,0,0\\n' | unproject project scene.json\n  unproject project scene.json points.csv | "
          "unproject points scene.json\n  unproject points scene.json clicks.csv | unproject project scene.json"
        + badRows());
    command->callback([options, &run] {
        options->format = formatOf(*options);
        run = [options] { return runProject(*options); };
    });
}

void addCloud(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("cloud", tr("A whole depth image to a point cloud in world space"));
    auto options = std::make_shared<CloudOptions>();
    addSceneFile(*command, options->scene);
    addFile(*command, "DEPTH", options->depth,
            tr("Depths of the window: PFM, 16-bit PGM, or raw 32-bit floats row by row\n"
               "from the top; - is standard input"))
        ->required();
    addFile(*command, "-o,--output", options->output, tr("Binary PLY; - is standard output"))->required();
    command->add_option("--size", options->size, tr("Of raw floats, in pixels"))->type_name("WxH");
    addChoice<DepthNumbers>(*command, "--depths", options->depths,
                            {{"range", DepthNumbers::Range}, {"window", DepthNumbers::Window}},
                            tr("What the picture's numbers are, in PGM over its greatest one: depths of the\n"
                               "window, or 0 to 1 over the scene's depth range"));
    addChoice<Method>(*command, "--method", options->method, {{"formula", Method::Formula}, {"matrix", Method::Matrix}},
                      tr("How to compute"));
    addChoice<PointPrecision>(*command, "--precision", options->precision,
                              {{"float", PointPrecision::Float}, {"double", PointPrecision::Double}},
                              tr("Of the numbers written"));
    command->footer(
        tr("Pixels at the far end of the depth range are background and left out, and so are depths outside it.\n"
           "Floats have 7 digits: where coordinates are large, as on maps, take --precision double.")
        + "\n\n" + tr("Examples:")
        + "\n  unproject cloud scene.json depth.pfm -o cloud.ply\n  unproject cloud --size 1920x1080 scene.json "
          "depth.raw -o cloud.ply");
    command->callback([options, &run] { run = [options] { return runCloud(*options); }; });
}

void addDoctor(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("doctor", tr("Which mistake of a program makes its wrong coordinate"));
    auto options = std::make_shared<DoctorOptions>();
    addModelOrScene(*command, options->scene);
    CLI::Option *pixel =
        command
            ->add_option(
                "--pixel", options->pixel,
                tr("The click in device pixels from the top left corner; the centre of the first pixel\nis 0.5,0.5"))
            ->type_name("X,Y");
    CLI::Option *depth =
        command
            ->add_option("--depth", options->depth,
                         tr("The right depth there, in the scene's depth range. Without it: that of the scene's\n"
                            "mesh; without a mesh answers are rays"))
            ->type_name("D");
    CLI::Option *got =
        command
            ->add_option(
                "--got", options->got,
                tr("The wrong point as the program prints it: 1.50,2,3 or vec3(1.5, 2, 3). Its digits count: 1.50\n"
                   "has two decimals"))
            ->type_name("X,Y,Z");
    command
        ->add_option("--got-space", options->gotSpace,
                     tr("The space that the point is meant in: world, eye, object (of the only one) or object:NAME"))
        ->type_name("SPACE")
        ->default_str("world")
        ->check([](const std::string &given) {
            const bool isKnown =
                given == "world" || given == "eye" || given == "object" || given.starts_with("object:");
            return isKnown ? std::string() : tr("\"%1\" is none of %2", given, "world, eye, object, object:NAME");
        });
    CLI::Option *points = addFile(*command, "--points", options->points,
                                  tr("Several wrong points of one program instead: CSV with the columns\n"
                                     "px,py,depth,x,y,z, depth may be empty; - is standard input"));
    points->excludes(pixel)->excludes(depth)->excludes(got);
    command
        ->add_option("--other-size", options->otherSize,
                     tr("A size in device pixels that the program may still go by: the window's before, or that of\n"
                        "another framebuffer"))
        ->type_name("WxH");
    command->add_flag("--json", options->isJson, tr("Write one JSON object"));
    command->footer(tr("Every mistake that is known, and every pair of them, is made on the click; what comes closest "
                       "to the point, in\n"
                       "units of its last digit, is named, with what would tell it from the next best and with the "
                       "lines of code to\n"
                       "change. A point that is right is called right. Where nothing explains the point, or so few "
                       "digits are given that\n"
                       "something would by chance, the verdict is \"unknown\".\n"
                       "\n"
                       "The chance is counted, not assumed: by how many of the mistakes and pairs that were tried have "
                       "their answers how\n"
                       "close to the point. One mistake is named up to 20 %, a pair up to 2 %.\n"
                       "\n"
                       "A depth of four decimals or more counts as rounded to them, one of fewer as exact. Mistakes of "
                       "the pixel ratio are\n"
                       "tried with the scene's ratio and 1.25, 1.5, 1.75, 2 and 3, near and far with 1/100, 1/10, 10 "
                       "and 100 times.")
                    + "\n\n" + tr("Examples:")
                    + "\n  unproject doctor scene.json --pixel 568.647,274.338 --depth 0.838331 --got "
                      "0.7051,-0.4122,0.0918\n  unproject doctor scan.ply --pixel 400.5,300.5 --got 1.07,2.31,-0.55 "
                      "--json\n  unproject doctor scene.json --points wrong.csv");
    command->callback([options, pixel, got, points, &run] {
        if (points->count() == 0) {
            for (const CLI::Option *needed : {pixel, got}) {
                if (needed->count() == 0)
                    throw CLI::RequiredError(tr("%1 (or --points)", needed->get_name()));
            }
        }
        run = [options] { return runDoctor(*options); };
    });
}

} // namespace unprojector::cli
