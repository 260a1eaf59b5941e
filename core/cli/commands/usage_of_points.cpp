// The commands that go from pixels to points and back.

#include "core/cli/commands/cloud_command.h"
#include "core/cli/commands/doctor_command.h"
#include "core/cli/commands/pick_command.h"
#include "core/cli/commands/points_command.h"
#include "core/cli/commands/project_command.h"
#include "core/cli/commands/usage.h"
#include "core/cli/commands/usage_options.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cli {
using namespace clouds;
using namespace unproject;
using base::tr;
namespace {

/// The options of commands that take rows.
void addRowOptions(CLI::App &command, RowOptions &options, const std::string &columns)
{
    addSceneFile(command, options.scene);
    addFile(command, "POINTS", options.input, columns);
    command.add_option("--space", options.space, tr("Space of the points: world, eye or object:NAME"))
        ->default_str("world");
    addChoice<RowFormat>(command, "--format", options.format, {{"csv", RowFormat::Csv}, {"jsonl", RowFormat::Jsonl}},
                         tr("Output format"));
    command.add_flag("--no-header", options.isHeaderless, tr("Write only rows, so that several results can be joined"));
    addSpreadsheetSafe(command, options.isSpreadsheetSafe);
    addCount(command, "--threads", options.threads, 64, tr("Number of threads"));
}

/// The format of two options together.
template <class Options>
RowFormat formatOf(const Options &options)
{
    return options.isSpreadsheetSafe && options.format == RowFormat::Csv ? RowFormat::SafeCsv : options.format;
}

void addDistortion(CLI::App &command, std::string &target, const std::string &description)
{
    command.add_option("--distortion", target, description)->type_name("FILE|K1,K2,P1,P2,K3");
}

std::string badRows()
{
    return "\n\n"
           + tr("Other columns (names, notes) pass through unchanged, in their order. A column with the name of a "
                "result is\noverwritten.\n\nA row that cannot be computed has empty cells and a line on stderr; the "
                "others are computed, and the exit code is 1.");
}

/// A finite number in full.
std::optional<double> numberIn(std::string_view given)
{
    double number = 0.0;
    const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), number);
    const bool isWhole = error == std::errc{} && end == given.data() + given.size();
    return isWhole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::string finiteNumber(const std::string &given)
{
    return numberIn(given) ? std::string() : tr("\"%1\" is not a finite number", given);
}

/// An option that takes a number above 0.
void addPositive(CLI::App &command, const std::string &name, std::optional<double> &target,
                 const std::string &description)
{
    command.add_option(name, target, description)->type_name("N")->check([](const std::string &given) {
        return numberIn(given).value_or(0.0) > 0.0 ? std::string() : tr("\"%1\" is not a number above 0", given);
    });
}

/// An option that takes finite numbers with commas between them.
void addNumbers(CLI::App &command, const std::string &name, std::vector<double> &target, const std::string &description)
{
    command.add_option(name, target, description)
        ->type_name("N")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(finiteNumber);
}

} // namespace

void addPoints(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand(
        "points", tr("Unproject pixels with depths to points, by the formulas and by the inverted matrix"));
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
                                   tr("Method"));
    command->add_flag("--pixel", options->isPixel,
                      tr("px and py are integer indices of pixels; 1/2 is added to get their centres"));
    addDistortion(*command, options->distortion,
                  tr("The pixels are of an image that a lens distorts: undo it, with the scene's K.\nA file of a "
                     "camera, or coefficients in OpenCV's order"));
    command->footer(
        tr("The input can also be clicks printed by 'unprojector --screenshot': give their file instead of SCENE and "
           "POINTS.\nEach click is computed with its own scene, to the digits that were printed. A click on the "
           "background has no\npoint: its cells are empty, like those of a bad row. With POINTS (also -), the rows are "
           "computed instead, with\nthe scene of the clicks.\n\nThe columns have the same names in every space: give "
           "'unproject project' the same --space.")
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
    CLI::App *command = app.add_subcommand("pick", tr("Pick pixels by their rays, on the mesh itself"));
    auto options = std::make_shared<PickOptions>();
    addModelOrScene(*command, options->scene);
    CLI::Option *input = addFile(*command, "PIXELS", options->input,
                                 tr("CSV with the columns px,py; - or nothing: standard input. px and py are device\n"
                                    "pixels from the top left corner, the centre of the first pixel is 0.5,0.5"));
    CLI::Option *at =
        command->add_option("--at", options->positions, tr("A position instead of PIXELS; may be repeated"))
            ->type_name("X,Y")
            ->allow_extra_args(false)
            ->excludes(input);
    command
        ->add_option("--size", options->size,
                     tr("Size of the view in device pixels. Default: the scene file's, or 800x600 for a\nmodel"))
        ->type_name("WxH");
    addChoice<ray::Snap>(*command, "--snap", options->snap,
                         {{"surface", ray::Snap::Surface},
                          {"vertex", ray::Snap::Vertex},
                          {"edge", ray::Snap::Edge},
                          {"face", ray::Snap::Face}},
                         tr("Snap to the hit of the ray, or to the nearest visible element within 8 pixels"));
    command
        ->add_flag("--edges", options->hasEdges,
                   tr("Add the columns pixel_edge, beyond_edge and behind: 1 if an edge of the surface crosses\nthe "
                      "pixel, the object on its other side, and how far behind it lies. Takes longer"))
        ->excludes(at);
    command->add_flag("--json", options->isJson, tr("With --at: one JSON object per position, one per line"))
        ->needs(at);
    addChoice<RowFormat>(*command, "--format", options->format, {{"csv", RowFormat::Csv}, {"jsonl", RowFormat::Jsonl}},
                         tr("Output format of rows"))
        ->excludes(at);
    command
        ->add_flag("--no-header", options->isHeaderless, tr("Write only rows, so that several results can be joined"))
        ->excludes(at);
    addSpreadsheetSafe(*command, options->isSpreadsheetSafe)->excludes(at);
    command->add_option("--threads", options->threads, tr("Number of threads, 1 to 64; default: one per core"))
        ->type_name("N")
        ->check(wholeNumber(64));
    command->footer(
        tr("Needs no window and no OpenGL: the ray is intersected with the triangles in double precision. A model is "
           "seen as\nthe window shows it at the start, a scene file as its camera says. Rays do not hit what is "
           "hidden, clipped away or\noutside the view. A position outside the view is reported, and the exit code is "
           "1.\n\nTriangles and vertices are counted from 0 through all meshes of an object, in the file's order. "
           "Polygons are split\ninto triangles, so edges and faces are those of triangles. 'uncertainty' (dx, dy, dz) "
           "is the rounding error of the\npoint in double precision; the size of a pixel is not in it. A row whose ray "
           "hits nothing has empty cells. A point\nof a cloud is hit in its dot of 3 pixels, or within 8 pixels if the "
           "ray hits no surface; it has no triangle,\nnormal or edge.")
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
    CLI::App *command = app.add_subcommand("project", tr("Project points to the window, with every stage"));
    auto options = std::make_shared<RowOptions>();
    addRowOptions(
        *command, *options,
        tr("CSV with the columns x,y,z, or formula_x,formula_y,formula_z as 'unproject points' writes them; - "
           "or\nnothing: standard input. They lie in the space that --space names"));
    auto distortion = std::make_shared<std::string>();
    addDistortion(*command, *distortion,
                  tr("Write px and py of the image that a lens distorts, with the scene's K. A file\nof a camera, or "
                     "coefficients in OpenCV's order"));
    command->footer(
        tr("The stages: eye, clip, ndc, window (device pixels from the bottom left corner), widget (logical "
           "pixels\nfrom the top left corner); px,py,depth are the input of 'unproject points'. All of them are "
           "OpenGL's, with y up,\nfor all \"conventions\" of the scene; ndc_z uses the depths of its projection, -1 to "
           "1 or 0 to 1.")
        + "\n\n" + tr("Examples:")
        + "\n  printf 'x,y,z\\n0,0,0\\n' | unproject project scene.json\n  unproject project scene.json points.csv | "
          "unproject points scene.json\n  unproject points scene.json clicks.csv | unproject project scene.json"
        + badRows());
    command->callback([options, distortion, &run] {
        options->format = formatOf(*options);
        run = [options, distortion] { return runProject(*options, *distortion); };
    });
}

void addCloud(CLI::App &app, Run &run)
{
    CLI::App *command =
        app.add_subcommand("cloud", tr("Unproject a whole depth image to a point cloud in world space"));
    auto options = std::make_shared<CloudOptions>();
    addSceneFile(*command, options->scene);
    addFile(*command, "DEPTH", options->depth,
            tr("Depth image: PNG of 8 or 16 bits, .npy, OpenEXR, TIFF, PFM, PGM, COLMAP's .bin, or\nraw 32-bit floats "
               "row by row from the top; - is standard input"))
        ->required();
    addFile(*command, "-o,--output", options->output, tr("Binary PLY; - is standard output"))->required();
    addFile(*command, "--color", options->color, tr("Colors of the same pixels: PNG or JPEG"));
    command->add_option("--size", options->size, tr("Size of raw floats, in pixels"))->type_name("WxH");
    command->add_option("--channel", options->channel, tr("Channel of OpenEXR that holds the depths"))
        ->type_name("NAME");
    addChoice<std::optional<std::endian>>(
        *command, "--byte-order", options->byteOrder, {{"little", std::endian::little}, {"big", std::endian::big}},
        tr("Byte order of a PGM of 16 bits, default big, or of raw floats, default\nlittle"));
    CLI::Option *meaning = addChoice<DepthMeaning>(
        *command, "--depth-is", options->numbers.meaning,
        {{"buffer", DepthMeaning::Buffer},
         {"range", DepthMeaning::Range},
         {"z", DepthMeaning::Z},
         {"distance", DepthMeaning::Distance},
         {"disparity", DepthMeaning::Disparity}},
        tr("Meaning of the numbers: depths of the window, 0 to 1 over the scene's depth range,\ndistance "
           "along the view axis, distance along the pixel's ray, or disparity in pixels"));
    addPositive(*command, "--depth-scale", options->numbers.scale,
                tr("Divides the numbers of z, distance and disparity: 1000 for millimetres in a\nscene in metres"));
    addPositive(*command, "--baseline", options->numbers.baseline,
                tr("Distance of the two cameras of a disparity, world units"));
    command
        ->add_option("--disparity-offset", options->numbers.disparityOffset,
                     tr("Added to disparities, pixels: the second camera's cx less the first's, as doffs\nof "
                        "Middlebury"))
        ->type_name("N")
        ->check(finiteNumber);
    addNumbers(*command, "--no-data", options->numbers.noData,
               tr("Numbers of the image that mean no measurement, before --depth-scale: 65535"));
    addChoice<Method>(*command, "--method", options->method, {{"formula", Method::Formula}, {"matrix", Method::Matrix}},
                      tr("Method"));
    addChoice<PointPrecision>(*command, "--precision", options->precision,
                              {{"float", PointPrecision::Float}, {"double", PointPrecision::Double}},
                              tr("Precision of the written numbers"));
    command->footer(
        tr("Whole numbers as depths of the window count from 0 to their greatest possible one; all others as they are. "
           "Pixels with\n0, NaN, infinity or a number of --no-data, before the near plane, on the far plane or behind "
           "it "
           "have no point; they\nare counted on stderr. Floats have 7 digits: for large coordinates, as on maps, use "
           "--precision double.")
        + "\n\n" + tr("Examples:")
        + "\n  unproject cloud scene.json depth.pfm -o cloud.ply\n  unproject cloud --size 1920x1080 scene.json "
          "depth.raw -o cloud.ply\n  unproject cloud scene.json depth.npy --depth-is z --depth-scale 1000 -o "
          "cloud.ply");
    command->callback([options, meaning, &run] {
        options->numbers.isMeaningGiven = meaning->count() > 0;
        run = [options] { return runCloud(*options); };
    });
}

void addDoctor(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("doctor", tr("Find the mistake that gives a program a wrong coordinate"));
    auto options = std::make_shared<DoctorOptions>();
    addModelOrScene(*command, options->scene);
    CLI::Option *pixel =
        command
            ->add_option(
                "--pixel", options->pixel,
                tr("The click in device pixels from the top left corner; the centre of the first pixel\nis 0.5,0.5"))
            ->type_name("X,Y");
    CLI::Option *depth = command
                             ->add_option("--depth", options->depth,
                                          tr("The right depth there, in the scene's depth range. Default: that of the "
                                             "scene's\nmesh; without a mesh answers are rays"))
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
                     tr("Space of the point: world, eye, object (of the only one) or object:NAME"))
        ->type_name("SPACE")
        ->default_str("world")
        ->check([](const std::string &given) {
            const bool isKnown =
                given == "world" || given == "eye" || given == "object" || given.starts_with("object:");
            return isKnown ? std::string() : tr("\"%1\" is not one of %2", given, "world, eye, object, object:NAME");
        });
    CLI::Option *points = addFile(*command, "--points", options->points,
                                  tr("Several wrong points of one program instead: CSV with the columns\n"
                                     "px,py,depth,x,y,z, depth may be empty; - is standard input"));
    points->excludes(pixel)->excludes(depth)->excludes(got);
    command
        ->add_option("--other-size", options->otherSize,
                     tr("A size in device pixels that the program may use by mistake: an earlier size of the\nwindow, "
                        "or another framebuffer's"))
        ->type_name("WxH");
    addDistortion(
        *command, options->distortion,
        tr("The pixels are those of the image that a lens distorts, with the scene's K.\nA file of a camera, or "
           "coefficients in OpenCV's order"));
    command->add_flag("--json", options->isJson, tr("Write one JSON object"));
    command->footer(
        tr("Every known mistake, and every pair of them, is applied to the click. The result names the mistake whose "
           "answer is\nclosest to the point, in units of its last digit. It adds a click that separates it from the "
           "next best, and the\nlines of code to change. A right point is called right. If no mistake explains the "
           "point, or so few digits are\ngiven that one would by chance, the verdict is \"unknown\".\n\nThe chance is "
           "counted, not assumed: it depends on how many of the tried mistakes and pairs have answers close to\nthe "
           "point. One mistake is named up to 20 %, a pair up to 2 %.\n\nA depth of four decimals or more counts as "
           "rounded to them, one of fewer as exact.\n\nValues are solved from the wrong point: near, far, the field of "
           "view, a shift of the pixel, the viewport's size, a\npixel ratio, a scale. They are not tried in pairs. "
           "Where one point allows several values, a second point decides.")
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
