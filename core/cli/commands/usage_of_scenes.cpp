// The commands about models, scenes, their matrices and maps, and files of landmarks.

#include "core/cli/commands/code_command.h"
#include "core/cli/commands/compare_command.h"
#include "core/cli/commands/info_command.h"
#include "core/cli/commands/landmarks_command.h"
#include "core/cli/commands/map_command.h"
#include "core/cli/commands/matrices_command.h"
#include "core/cli/commands/scene_command.h"
#include "core/cli/commands/usage.h"
#include "core/cli/commands/usage_options.h"

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace unprojector::cli {
using namespace geometry;
using namespace matrices;
using namespace unproject;
using text::tr;
namespace {

CLI::Option *addConventions(CLI::App &command, std::optional<Api> &target, const std::string &description)
{
    std::map<std::string, std::optional<Api>> choices;
    for (const Api api : kApis)
        choices.emplace(conventionsOf(api).key, api);
    return addChoice<std::optional<Api>>(command, "--conventions", target, choices, description);
}

std::string conventionNames()
{
    // Chinese help is wrapped on display.
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

CLI::Option *addLandmarkFormat(CLI::App &command, const std::string &name,
                               std::optional<landmark_files::Format> &target, const std::string &description,
                               bool isWritten)
{
    const std::string names = isWritten ? landmark_files::writtenWords() : landmark_files::readWords();
    return command
        .add_option_function<std::string>(
            name, [&target](const std::string &given) { target = landmark_files::formatOfSuffix(given); },
            description + ": " + names)
        ->type_name("WORD")
        ->check([names, isWritten](const std::string &given) {
            const auto format = landmark_files::formatOfSuffix(given);
            return format && (!isWritten || landmark_files::isWritten(*format))
                       ? std::string()
                       : tr("\"%1\" is none of %2", given, names);
        });
}

} // namespace

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
        tr("Brackets, commas, subscripts (m[3] =) and other words between the numbers are passed over. A matrix\n"
           "that is a camera's in one order of its numbers alone is read in that order; where nothing tells the\n"
           "order, --order has to. What else is to be seen of a matrix is said, and nothing changed: an inverse,\n"
           "depths from 0 to 1 or reversed, y turned round, a scale.")
        + "\n\n" + tr("Examples:")
        + "\n  unproject scene --from-matrices matrices.txt -o scene.json\n  unproject scene --from-matrices "
          "\"modelview 1 0 0 0  0 1 0 0  0 0 1 0  0 0 -5 1\n      projection 1 0 0 0  0 1 0 0  0 0 -1.2 -1  0 0 -2.2 0 "
          " viewport 0 0 800 600\"");
    command->callback([options, &run] { run = [options] { return runScene(*options); }; });
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
                            {"three", CodeDialect::ThreeJs},
                            {"numpy", CodeDialect::NumPy}},
                           tr("What it is written for"));
    addFile(*command, "-o,--output", options->output,
            tr("C++, JavaScript for three, Python for numpy; - is standard output"))
        ->default_str("-");
    command->footer(
        tr("Its screen2world(i, j, depth) unprojects the centre of a pixel, counted from the top left corner in\n"
           "device pixels. For glu, handlers for a view of MFC stand at the end. Models are only named; what the\n"
           "library has no word for is said in comments.")
        + "\n\n" + tr("Examples:")
        + "\n  unproject code scene.json --for glm\n  unproject code scene.json --for three -o scene.js\n"
          "  unproject code scene.json --for numpy -o scene.py");
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
            if (maps::conventionNamed(given) != nullptr)
                return std::string();
            std::string names = conventionNames();
            std::erase(names, '\n');
            return tr("\"%1\" is none of %2", given, names);
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

void addLandmarks(CLI::App &app, Run &run)
{
    CLI::App *command =
        app.add_subcommand("landmarks", tr("Landmarks from one program's file to another's, or to a table"));
    auto options = std::make_shared<LandmarksOptions>();
    CLI::Option *input = addFile(*command, "IN", options->input, tr("File of landmarks; - is standard input"));
    CLI::Option *converted = addFile(*command, "OUT", options->output, tr("File of landmarks; - is standard output"));
    CLI::Option *from =
        addLandmarkFormat(*command, "--from", options->from, tr("What IN is, where its name does not say"), false);
    CLI::Option *to =
        addLandmarkFormat(*command, "--to", options->to, tr("What OUT is to be, where its name does not say"), true);
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
    addSpreadsheetSafe(*command, options->isSpreadsheetSafe);
    command->footer(
        tr("csv  ours: name,x,y,z,object,face,u,v,w,note; keeps all that points have. Tables of R, 3D Slicer, "
           "CloudCompare\n"
           "and spreadsheets are read too (.txt, .tsv), with commas, semicolons, tabs or blanks between the columns\n"
           "pp, pptpl  MeshLab: picked points, and a template of names\n"
           "mrk.json, fcsv  3D Slicer. Points in RAS get x and y negated, as a mesh's file has them (LPS)\n"
           "pts  IDAV Landmark\n"
           "tps, nts  tpsDig, geomorph, NTSYS (.dta too): many specimens\n"
           "landmarkAscii, ljson  Amira and Avizo, landmarker.io; only read\n"
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

} // namespace unprojector::cli
