#include "core/cli/command_line.h"

#include "core/cli/byte_stream.h"
#include "core/cli/cloud_command.h"
#include "core/cli/code_command.h"
#include "core/cli/compare_command.h"
#include "core/cli/doctor_command.h"
#include "core/cli/help_formatter.h"
#include "core/cli/info_command.h"
#include "core/cli/landmarks_command.h"
#include "core/cli/map_command.h"
#include "core/cli/matrices_command.h"
#include "core/cli/pick_command.h"
#include "core/cli/points_command.h"
#include "core/cli/project_command.h"
#include "core/cli/scene_command.h"
#include "core/text/translation.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

namespace unprojector::cli {
using text::tr;
namespace {

using Run = std::function<ExitCode()>;

/// @param target  holds the default
template <class Choice>
CLI::Option *addChoice(CLI::App &command, const std::string &name, Choice &target,
                       const std::map<std::string, Choice> &choices, const std::string &description)
{
    std::string names, usual;
    for (const auto &[word, choice] : choices) {
        names += (names.empty() ? "" : ", ") + word;
        usual = choice == target ? word : usual;
    }
    return command
        .add_option_function<std::string>(
            name, [&target, choices](const std::string &given) { target = choices.at(given); },
            description + ": " + names)
        ->type_name("WORD")
        ->default_str(usual)
        ->check([choices, names](const std::string &given) {
            return choices.contains(given) ? std::string() : tr("\"%1\" is none of %2", given, names);
        });
}

/// Of an option that takes a whole number from 1 on.
std::function<std::string(const std::string &)> wholeNumber(int highest)
{
    return [highest](const std::string &given) {
        int number = 0;
        const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), number);
        const bool isOne = error == std::errc{} && end == given.data() + given.size();
        return isOne && number >= 1 && number <= highest ? std::string()
                                                         : tr("Value %1 not in range 1 to %2", given, highest);
    };
}

template <class Count>
void addCount(CLI::App &command, const std::string &name, Count &target, int highest, const std::string &description)
{
    command.add_option(name, target, tr("%1, 1 to %2", description, highest))
        ->type_name("N")
        ->default_str(std::to_string(target))
        ->check(wholeNumber(highest));
}

CLI::Option *addFile(CLI::App &command, const std::string &name, std::string &target, const std::string &description)
{
    return command.add_option(name, target, description)->type_name("FILE")->check([](const std::string &given) {
        return given.empty() ? std::string(tr("give the name of a file")) : std::string();
    });
}

void addSceneFile(CLI::App &command, std::string &target)
{
    addFile(command, "SCENE", target, tr("Scene file (JSON), or clicks on one scene; - is standard input"))->required();
}

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
    addCount(command, "--threads", options.threads, 64, tr("How many threads compute"));
}

std::string badRows()
{
    return "\n\n"
           + tr("Other columns (names, notes) pass through unchanged, each where it stands; one that has the name of a "
                "result is\nwritten anew.\n\nA row that cannot be computed has empty cells and a line on stderr; the "
                "others go on, and the exit code is 1.");
}

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
        run = [options] { return runPoints(*options); };
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
    command->callback([options, &run] { run = [options] { return runProject(*options); }; });
}

CLI::Option *addConventions(CLI::App &command, std::optional<Api> &target, const std::string &description)
{
    std::map<std::string, std::optional<Api>> choices;
    for (const Api api : kApis)
        choices.emplace(conventionsOf(api).key, api);
    return addChoice<std::optional<Api>>(command, "--conventions", target, choices, description);
}

void addMatrices(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("matrices", tr("All matrices of a scene"));
    auto options = std::make_shared<MatricesOptions>();
    addSceneFile(*command, options->scene);
    addConventions(*command, options->conventions,
                   tr("Whose axes, depths and pixels the matrices have; without it, the scene's"));
    addChoice<std::optional<MatrixLayout>>(
        *command, "--layout", options->layout, {{"column", MatrixLayout::Column}, {"row", MatrixLayout::Row}},
        tr("Column vectors, M v, or row vectors, v M; without it, as the conventions have\nit"));
    addChoice<MatricesFormat>(*command, "--format", options->format,
                              {{"text", MatricesFormat::Text},
                               {"json", MatricesFormat::Json},
                               {"c", MatricesFormat::C},
                               {"numpy", MatricesFormat::NumPy},
                               {"latex", MatricesFormat::Latex}},
                              tr("How to write"));
    command->footer(tr("C arrays have OpenGL's order in memory in either layout.") + "\n\n" + tr("Examples:")
                    + "\n  unproject matrices scene.json\n  unproject matrices --conventions direct3d scene.json\n  "
                      "unproject matrices --format numpy --layout row scene.json > matrices.py");
    command->callback([options, &run] { run = [options] { return runMatrices(*options); }; });
}

void addCode(CLI::App &app, Run &run)
{
    using scene_code::CodeDialect;
    CLI::App *command =
        app.add_subcommand("code", tr("A scene as source code: its calls, and the way back from a pixel"));
    auto options = std::make_shared<CodeOptions>();
    addSceneFile(*command, options->scene);
    addChoice<CodeDialect>(*command, "--for", options->dialect,
                           {{"glu", CodeDialect::Glu},
                            {"glm", CodeDialect::Glm},
                            {"qt", CodeDialect::Qt},
                            {"three", CodeDialect::ThreeJs}},
                           tr("What it is written for"));
    addFile(*command, "-o,--output", options->output, tr("C++, or JavaScript for three; - is standard output"))
        ->default_str("-");
    command->footer(
        tr("Its screen2world(i, j, depth) unprojects the centre of a pixel, counted from the top left corner in\n"
           "device pixels. For glu, handlers for a view of MFC stand at the end. Models are only named; what the\n"
           "library has no word for is said in comments.")
        + "\n\n" + tr("Examples:")
        + "\n  unproject code scene.json --for glm\n  unproject code scene.json --for three -o scene.js");
    command->callback([options, &run] { run = [options] { return runCode(*options); }; });
}

void addCompare(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("compare", tr("How far both methods are from the truth"));
    auto options = std::make_shared<CompareOptions>();
    addSceneFile(*command, options->scene);
    command->add_flag("--json", options->isJson, tr("Write JSON instead of a table"));
    addCount(*command, "--pixels", options->pixels, 1000, tr("Pixels across and down of the grid"));
    addCount(*command, "--depths", options->depths, 1000, tr("Depths of the grid, from one end to the other"));
    command->footer(
        tr("Formula and matrix, in double and in single precision, against the same picture computed with 50 digits.")
        + "\n\n" + tr("Example:") + "\n  unproject compare scene.json");
    command->callback([options, &run] { run = [options] { return runCompare(*options); }; });
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

void addScene(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("scene", tr("A scene file from another program's matrices"));
    auto options = std::make_shared<SceneOptions>();
    command
        ->add_option("--from-matrices", options->fromMatrices,
                     tr("Modelview (16 numbers), projection (16) and viewport (4: x y width height),\n"
                        "or their product (16) and the viewport, or a text file that has them; - is\n"
                        "standard input. In this order, or each behind its name (modelview, view,\n"
                        "projection, MVP, viewport)"))
        ->required()
        ->expected(1, 64);
    addChoice<std::optional<NumberOrder>>(
        *command, "--order", options->order, {{"column", NumberOrder::ByColumns}, {"row", NumberOrder::ByRows}},
        tr("How the 16 numbers follow each other; without it, as programs\n"
           "write them: 16 in a row by columns, four lines or four brackets of four by\n"
           "rows, glm::to_string by columns"));
    CLI::Option *depth = addChoice<std::optional<NdcDepth>>(
        *command, "--depth", options->depth,
        {{"minus-one-to-one", NdcDepth::MinusOneToOne}, {"zero-to-one", NdcDepth::ZeroToOne}},
        tr("NDC depths that the projection goes by"));
    CLI::Option *y = addChoice<std::optional<bool>>(*command, "--y", options->isYDown, {{"up", false}, {"down", true}},
                                                    tr("Which way NDC y grows: down, as in Vulkan, turns it round"));
    command->add_flag("--reversed", options->isReversed,
                      tr("Depths are 1 on the near plane: by the projection, or else by the depth\nrange"));
    addConventions(*command, options->conventions, tr("Whose matrices they are, kept in the scene"))
        ->excludes(depth)
        ->excludes(y);
    command->add_flag("--orthonormal", options->isOrthonormal,
                      tr("Takes the nearest view whose axes are perpendicular and of length 1, for\n"
                         "one that was printed with few digits"));
    command
        ->add_option("--window", options->window,
                     tr("The window's size in pixels; without it, what the viewport needs"))
        ->type_name("WxH");
    addFile(*command, "-o,--output", options->output, tr("Scene file; - is standard output"))->default_str("-");
    command->footer(
        tr("Brackets, commas, subscripts (m[3] =) and other words between the numbers are passed over. What is\n"
           "to be seen of a matrix is said, and nothing changed: transposed, an inverse, depths from 0 to 1 or\n"
           "reversed, y turned round, a scale.")
        + "\n\n" + tr("Examples:")
        + "\n  unproject scene --from-matrices matrices.txt -o scene.json\n  unproject scene --from-matrices "
          "\"modelview 1 0 0 0  0 1 0 0  0 0 1 0  0 0 -5 1\n      projection 1 0 0 0  0 1 0 0  0 0 -1.2 -1  0 0 -2.2 0 "
          " viewport 0 0 800 600\"");
    command->callback([options, &run] { run = [options] { return runScene(*options); }; });
}

CLI::Option *addModelOrScene(CLI::App &command, std::string &target)
{
    return addFile(command, "SCENE", target,
                   tr("Model (OBJ, STL, PLY, OFF, glTF, GLB), scene file (JSON), or clicks on one\n"
                      "scene; - is a scene from standard input"))
        ->required();
}

void addInfo(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("info", tr("What a model or a scene holds"));
    auto options = std::make_shared<InfoOptions>();
    addModelOrScene(*command, options->file);
    command->add_flag("--json", options->isJson, tr("Write JSON instead of a table"));
    command->footer(
        tr("World space, in double precision; objects that are hidden count as the others do. 'vertices' are the\n"
           "file's; those that STL repeats for each triangle count once a place. The volume is that of a closed\n"
           "surface, above 0 where the file has its triangles go round counter-clockwise as seen from outside (whether "
           "or\n"
           "not the object is mirrored); of an open one it says nothing.")
        + "\n\n" + tr("Examples:") + "\n  unproject info scan.ply\n  unproject info --json scene.json");
    command->callback([options, &run] { run = [options] { return runInfo(*options); }; });
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
           "cut where they stand, so that edges and faces are those of triangles; vertices as they are held, which is "
           "the\n"
           "file's order unless corners of one vertex differ in normals or texture coordinates, or no face uses it.\n"
           "'uncertainty' (dx, dy, dz) is how far the point may be off what the file says, by the single precision "
           "that\n"
           "vertices are held in; what a pixel covers is not in it. A row whose ray meets nothing has empty cells. "
           "Points\n"
           "of a cloud are taken where their dot of 3 pixels is met, else, where no surface is, within 8 pixels; they "
           "have\n"
           "no triangle, normal and edge.")
        + "\n\n" + tr("Examples:")
        + "\n  unproject pick scan.ply --at 400.5,300.5\n  unproject pick --json --snap vertex scene.json --at "
          "400.5,300.5 --at 10.5,20.5\n  unproject pick scene.json pixels.csv > points.csv"
        + badRows());
    command->callback([options, &run] { run = [options] { return runPick(*options); }; });
}

std::string conventionNames()
{
    // Chinese help is wrapped where it is shown.
    const std::size_t mostInLine = text::language() == text::Language::English ? 80 : std::string::npos;
    std::string names, line;
    for (const maps::NamedConvention &convention : maps::namedConventions()) {
        if (line.size() + convention.key.size() > mostInLine) {
            names += line + '\n';
            line.clear();
        }
        line += std::string(convention.key) + ", ";
    }
    return names + line.substr(0, line.size() - 2);
}

void addMap(CLI::App &app, Run &run)
{
    CLI::App *command =
        app.add_subcommand("map", tr("A picture of differences: a number for each pixel, as a float map"));
    auto options = std::make_shared<MapOptions>();
    addModelOrScene(*command, options->scene);
    std::map<std::string, maps::Quantity> quantities;
    for (const maps::Quantity quantity : maps::kQuantities)
        quantities.emplace(maps::keyOf(quantity), quantity);
    addChoice<maps::Quantity>(*command, "--what", options->quantity, quantities, tr("What the numbers are"))
        ->default_str("")
        ->required();
    command
        ->add_option("--convention", options->convention,
                     tr("Of a displacement, which program answers, or which mistake is made:") + '\n'
                         + conventionNames())
        ->type_name("WORD")
        ->check([](const std::string &given) {
            return maps::conventionNamed(given) != nullptr ? std::string()
                                                           : tr("\"%1\" is none of\n%2", given, conventionNames());
        });
    addChoice<maps::Unit>(*command, "--unit", options->unit, {{"world", maps::Unit::World}, {"ulp", maps::Unit::Ulps}},
                          tr("World units, or units in the last place of the formulas' largest coordinate"));
    command
        ->add_option("--size", options->size,
                     tr("Of the picture in device pixels. Without it: a scene file's own, 800x600 of a\nmodel"))
        ->type_name("WxH");
    command
        ->add_option("--depth", options->depth,
                     tr("This depth everywhere, in the depth range, instead of the surfaces'"))
        ->type_name("D");
    addChoice<DepthFormat>(*command, "--depth-buffer", options->format,
                           {{"16", DepthFormat(16)},
                            {"24", DepthFormat(24)},
                            {"32", DepthFormat(32)},
                            {"float", DepthFormat::floatingPoint()}},
                           tr("How the depths of the surfaces are rounded: bits of a whole number, or a float"));
    command->add_flag("--json", options->isJson, tr("Write the statistics as JSON to standard output"));
    addFile(*command, "-o,--output", options->output, tr("Portable float map (PFM); - is standard output"))->required();
    command->footer(tr("No window and no OpenGL: the depth of each pixel's centre is that of what its ray meets, "
                       "rounded as a depth\n"
                       "buffer does it. Where nothing is met the map has NaN; points of clouds are not met. Rows lie "
                       "from the bottom\n"
                       "up, as PFM has them.\n"
                       "\n"
                       "  formula-matrix  how far the formulas' point is from the inverted matrix's\n"
                       "  formula-ray     the formulas' point from where the ray meets the mesh; matrix-ray: the "
                       "inverted matrix's\n"
                       "  uncertainty     how far the surface may be from the point: the length of the +- of a click\n"
                       "  displacement    how far the point of another program, or of a mistake, is from the formulas'")
                    + "\n\n" + tr("Examples:")
                    + "\n  unproject map scan.ply --what formula-matrix --unit ulp -o map.pfm\n  unproject map "
                      "scene.json --what displacement --convention meshlab --size 1920x1080 -o map.pfm\n  unproject "
                      "map scene.json --what displacement --convention pixel-corner --depth 0.5 -o map.pfm");
    command->callback([options, command, &run] {
        const bool isOfOther = options->quantity == maps::Quantity::Displacement;
        if (isOfOther && options->convention.empty())
            throw CLI::RequiredError(tr("--convention (with --what displacement)"));
        if (!isOfOther && !options->convention.empty())
            throw CLI::ValidationError("--convention " + options->convention,
                                       tr("is for --what displacement, not for --what %1; leave one of them out",
                                          maps::keyOf(options->quantity)));
        options->isDepthGiven = command->get_option("--depth")->count() > 0;
        run = [options] { return runMap(*options); };
    });
}

CLI::Option *addLandmarkFormat(CLI::App &command, const std::string &name,
                               std::optional<landmark_files::Format> &target, const std::string &description)
{
    std::string names;
    for (const landmark_files::Format format : landmark_files::kFormats)
        names += (names.empty() ? "" : ", ") + std::string(landmark_files::suffixOf(format));
    return command
        .add_option_function<std::string>(
            name, [&target](const std::string &given) { target = landmark_files::formatOfSuffix(given); },
            description + ": " + names)
        ->type_name("WORD")
        ->check([names](const std::string &given) {
            return landmark_files::formatOfSuffix(given) ? std::string() : tr("\"%1\" is none of %2", given, names);
        });
}

void addLandmarks(CLI::App &app, Run &run)
{
    CLI::App *command =
        app.add_subcommand("landmarks", tr("Landmarks from one program's file to another's, or to a table"));
    auto options = std::make_shared<LandmarksOptions>();
    CLI::Option *input = addFile(*command, "IN", options->input, tr("File of landmarks; - is standard input"));
    CLI::Option *converted = addFile(*command, "OUT", options->output, tr("File of landmarks; - is standard output"));
    CLI::Option *from =
        addLandmarkFormat(*command, "--from", options->from, tr("What IN is, where its name does not say"));
    CLI::Option *to =
        addLandmarkFormat(*command, "--to", options->to, tr("What OUT is to be, where its name does not say"));
    CLI::Option *mesh = addFile(*command, "--mesh", options->mesh,
                                tr("Model that every point is moved onto, to the closest place; how far is said"))
                            ->type_name("MODEL");
    CLI::Option *folder =
        addFile(*command, "--table", options->folder, tr("One table of all files of landmarks in this folder"))
            ->type_name("FOLDER")
            ->excludes(input)
            ->excludes(converted)
            ->excludes(from)
            ->excludes(to)
            ->excludes(mesh);
    CLI::Option *repeats =
        command
            ->add_option(
                "--repeats", options->repeats,
                tr("The same points placed two or more times, a file each: the mean and the error of each point"))
            ->type_name("FILE")
            ->excludes(input)
            ->excludes(converted)
            ->excludes(to)
            ->excludes(mesh)
            ->excludes(folder)
            ->expected(2, CLI::detail::expected_max_vector_size);
    CLI::Option *output = addFile(*command, "-o,--output", options->output, tr("The table; - is standard output"));
    addChoice<LandmarkTable>(*command, "--format", options->table,
                             {{"long", LandmarkTable::Long},
                              {"wide", LandmarkTable::Wide},
                              {"tps", LandmarkTable::Tps},
                              {"nts", LandmarkTable::Nts}},
                             tr("Of the table: a row a point, a row a specimen, or a file of specimens"));
    command->footer(
        tr("csv  ours: name,x,y,z,object,face,u,v,w,note; keeps all that points have\n"
           "pp, pptpl  MeshLab: picked points, and a template of names\n"
           "mrk.json, fcsv  3D Slicer. Points in RAS get x and y negated, as a mesh's file has them (LPS)\n"
           "pts  IDAV Landmark\n"
           "tps, nts  tpsDig, geomorph, NTSYS: many specimens; nts is only written\n"
           "\n"
           "Coordinates keep all their digits. What a file has no place for is said on stderr. Of a folder, a file "
           "that\n"
           "cannot be read is said on stderr and left out, and the exit code is 1. With --mesh a table of ours has "
           "the\n"
           "triangle of each point and its place there; who was farther from the mesh than 1 % of its size is named.\n"
           "The error of --repeats is the standard deviation of one placing, all three coordinates together; farthest "
           "is\n"
           "that from the mean. Points belong together by their names.")
        + "\n\n" + tr("Examples:")
        + "\n  unproject landmarks skull.pp skull.mrk.json\n  unproject landmarks --from fcsv --to csv - - < "
          "points.fcsv\n  unproject landmarks --table skulls -o all.csv\n  unproject landmarks --table skulls -o "
          "all.csv --format wide\n  unproject landmarks --repeats monday.pp tuesday.pp -o error.csv");
    command->callback([options, input, converted, output, folder, repeats, &run] {
        if (folder->count() == 0 && repeats->count() == 0) {
            if (output->count() > 0)
                throw CLI::RequiredError(tr("--table or --repeats (with -o)"));
            for (const CLI::Option *needed : {input, converted}) {
                if (needed->count() == 0)
                    throw CLI::RequiredError(tr("%1 (or --table)", needed->get_name()));
            }
        } else if (output->count() == 0) {
            throw CLI::RequiredError("-o,--output");
        }
        run = [options] { return runLandmarks(*options); };
    });
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

/// An option or positional as it was given: "--at 1,2".
std::string asGiven(const CLI::App &command, const std::string &name)
{
    std::string words = name;
    if (const CLI::Option *option = command.get_option_no_throw(name)) {
        for (const std::string &word : option->results())
            words += ' ' + word;
    }
    return words;
}

/// What is wrong with the words. The library's own sentence does not always name the value and never says what to do.
std::string mistakeText(const CLI::App &app, const CLI::ParseError &error)
{
    const std::vector<const CLI::App *> commands = app.get_subcommands([](const CLI::App *) { return true; });
    const auto parsed =
        std::find_if(commands.begin(), commands.end(), [](const CLI::App *command) { return command->parsed(); });
    const CLI::App &command = parsed == commands.end() ? app : **parsed;
    const std::string called = parsed == commands.end() ? "unproject" : "unproject " + command.get_name();
    // A word that is an option's by its looks may be why something else is missing.
    const std::vector<std::string> left = command.remaining();
    const auto unknown = std::find_if(left.begin(), left.end(),
                                      [](const std::string &word) { return word.size() > 1 && word.front() == '-'; });
    if (unknown != left.end())
        return tr("%1 is no option of '%2'; '%2 --help' names them", *unknown, called);
    std::string what = error.what();
    // Behind -- the words do not come to the command; the library's sentence ends with them.
    if (dynamic_cast<const CLI::ExtrasError *>(&error) != nullptr)
        return tr("\"%1\" is one word too many for '%2'; '%2 --help' says what it takes",
                  left.empty() ? what.substr(what.find_last_of(" :") + 1) : left.back(), called);

    // The library's sentence is English: the names are taken out of it.
    const auto parts = [&what](std::string_view between) -> std::optional<std::pair<std::string, std::string>> {
        const std::size_t at = what.find(between);
        if (at == what.npos)
            return std::nullopt;
        return std::pair(what.substr(0, at), what.substr(at + between.size()));
    };
    if (const auto both = parts(" excludes "); both && dynamic_cast<const CLI::ExcludesError *>(&error) != nullptr)
        return tr("%1 and %2 exclude each other; leave one of them out", asGiven(command, both->first),
                  asGiven(command, both->second));
    constexpr std::string_view kNoNumber = "Could not convert: ";
    if (what.starts_with(kNoNumber))
        return tr("%1: give a number",
                  asGiven(command, what.substr(kNoNumber.size(), what.find(" = ") - kNoNumber.size())));
    if (dynamic_cast<const CLI::ValidationError *>(&error) != nullptr)
        return what; // by our own checks, which speak the user's language
    if (const auto both = parts(" requires "); both && dynamic_cast<const CLI::RequiresError *>(&error) != nullptr)
        return tr("%1 requires %2; '%3 --help' says more", both->first, both->second, called);
    if (dynamic_cast<const CLI::RequiredError *>(&error) != nullptr) {
        if (what == "A subcommand is required")
            return tr("A subcommand is required; '%1 --help' says more", called);
        if (const auto both = parts(" is required"))
            return tr("%1 is required; '%2 --help' says more", both->first, called);
    }
    const CLI::Option *option = command.get_option_no_throw(what.substr(0, what.find(':')));
    if (option == nullptr || dynamic_cast<const CLI::ArgumentMismatch *>(&error) == nullptr)
        return tr("%1; '%2 --help' says more", what, called);
    const int needed = option->get_items_expected_min();
    const std::string given = asGiven(command, option->get_name());
    return needed > 1 ? tr("%1: %2 or more are needed behind it, and %3 is given; '%4 --help' says what it takes",
                           given, needed, option->results().size(), called)
                      : tr("%1: %2 is missing behind it; '%3 --help' says what it takes", given,
                           typeName(option->get_type_name()), called);
}

} // namespace

ExitCode runCommandLine(const std::vector<std::string> &arguments)
{
    CLI::App app(tr("The world coordinates under pixels, computed twice: by formulas in closed form and by the "
                    "inverted matrix."),
                 "unproject");
    app.allow_windows_style_options(false); // on Windows too, /scans/face.json is a file
    app.require_subcommand(1);
    app.set_help_flag("-h,--help", tr("Print this help message and exit"));
    app.set_version_flag("--version", "unproject " UNPROJECTOR_VERSION,
                         tr("Display program version information and exit"));
    app.footer(tr("unproject COMMAND --help says more.\n\nExit code: 0 done, 1 some rows bad, 2 unusable input."));
    app.formatter(helpFormatter());
    Run run;
    addPoints(app, run);
    addPick(app, run);
    addProject(app, run);
    addInfo(app, run);
    addScene(app, run);
    addCloud(app, run);
    addCompare(app, run);
    addMap(app, run);
    addMatrices(app, run);
    addCode(app, run);
    addLandmarks(app, run);
    addDoctor(app, run);
    nameGroups(app);
    // The library would only say that a command is missing.
    if (arguments.size() > 1 && !arguments[1].starts_with('-')) {
        std::string names;
        bool isKnown = false;
        for (const CLI::App *command : app.get_subcommands([](CLI::App *) { return true; })) {
            isKnown = isKnown || command->get_name() == arguments[1];
            names += ", " + command->get_name();
        }
        if (!isKnown) {
            complain(tr("\"%1\" is no command; give one of %2", arguments[1], names.substr(2)));
            return ExitCode::UnusableInput;
        }
    }
    try {
        std::vector<const char *> words;
        words.reserve(arguments.size());
        for (const std::string &argument : arguments)
            words.push_back(argument.c_str());
        app.parse(static_cast<int>(words.size()), words.data());
    } catch (const CLI::ParseError &error) {
        std::ostringstream output, errors;
        const bool isDone = app.exit(error, output, errors) == 0; // help and version come this way too
        if (!errors.str().empty())
            complain(mistakeText(app, error));
        ByteSink sink;
        sink.write(output.str());
        const ExitCode written = sink.finish();
        return isDone ? written : ExitCode::UnusableInput;
    }
    return run();
}

} // namespace unprojector::cli
