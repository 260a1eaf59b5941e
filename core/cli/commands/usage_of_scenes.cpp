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
using landmark_files::TableForm;
using namespace matrices;
using namespace unproject;
using base::tr;
namespace {

CLI::Option *addConventions(CLI::App &command, std::optional<Api> &target, const std::string &description)
{
    std::map<std::string, std::optional<Api>> choices;
    for (const Api api : kApis)
        choices.emplace(conventionsOf(api).key, api);
    return addChoice<std::optional<Api>>(command, "--conventions", target, choices, description);
}

/// The options about another program's camera.
void addCameraOptions(CLI::App &command, SceneOptions &options)
{
    using namespace cameras;
    CameraChoices &camera = options.camera;
    command
        .add_option("--image", camera.image,
                    tr("Of several images or frames: the name of one, or its index from 0; default:\nthe first"))
        ->type_name("NAME");
    command
        .add_option("--size", options.size,
                    tr("Size of the camera's image in pixels; default: the file's, or twice the\nprincipal point"))
        ->type_name("WxH");
    command
        .add_option("--near", camera.nearDistance,
                    tr("Distance of the near plane; default: the file's, or by the "
                       "objects"))
        ->type_name("D");
    command.add_option("--far", camera.farDistance, tr("Distance of the far plane; default: as for near"))
        ->type_name("D");
    std::map<std::string, std::optional<EyeAxes>> axes;
    for (const EyeAxes one : kEyeAxes)
        axes.emplace(keyOf(one), one);
    addChoice<std::optional<EyeAxes>>(command, "--axes", camera.axes, axes,
                                      tr("Axes of the camera's pose; default: as the program has them"));
    addChoice<std::optional<PoseDirection>>(
        command, "--pose", camera.direction,
        {{keyOf(PoseDirection::WorldToCamera), PoseDirection::WorldToCamera},
         {keyOf(PoseDirection::CameraToWorld), PoseDirection::CameraToWorld}},
        tr("Direction of the pose; default: as its name tells, else by which the camera\nsees the objects"));
    addChoice<std::optional<PixelCentres>>(command, "--pixel-centers", camera.centres,
                                           {{"integer", PixelCentres::AtIntegers}, {"half", PixelCentres::AtHalves}},
                                           tr("Coordinates of the first pixel's centre, 0 or 1/2, in the principal "
                                              "point;\ndefault: as the program has them"));
    command.add_flag("--undistorted", camera.isUndistorted,
                     tr("Pixels are those of the undistorted image: drop the distortion coefficients"));
    command
        .add_option("--objects", options.objects,
                    tr("Models or scenes, whose objects the scene gets; they decide the pose's direction"))
        ->type_name("FILE")
        ->expected(1, 64);
}

std::string conventionNames()
{
    // Chinese help is wrapped on display.
    const std::size_t mostInLine = base::language() == base::Language::English ? 80 : std::string::npos;
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
                       : tr("\"%1\" is not one of %2", given, names);
        });
}

} // namespace

void addInfo(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("info", tr("Describe a model or a scene"));
    auto options = std::make_shared<InfoOptions>();
    addModelOrScene(*command, options->file);
    command->add_flag("--json", options->isJson, tr("Write JSON instead of a table"));
    command->footer(tr("All numbers are in world space, in double precision; hidden objects count too. 'vertices' are "
                       "the file's;\nvertices that STL repeats for each triangle count once. The volume is defined for "
                       "a closed surface only. It is\nabove 0 if the file's triangles are counter-clockwise as seen "
                       "from outside, also if the object is mirrored.")
                    + "\n\n" + tr("Examples:") + "\n  unproject info scan.ply\n  unproject info --json scene.json");
    command->callback([options, &run] { run = [options] { return runInfo(*options); }; });
}

void addScene(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("scene", tr("Make a scene file from another program's camera or matrices"));
    auto options = std::make_shared<SceneOptions>();
    CLI::Option *from =
        command
            ->add_option("FILE,--from", options->from,
                         tr("Files of a camera, recognised by their contents: OpenCV (K, R, t; YAML, XML,\n"
                            "JSON), ROS camera_info and the other programs of the manual's page\n"
                            "conventions; - is standard input. Or the text itself"))
            ->type_name("FILE")
            ->expected(1, 64);
    CLI::Option *matrices =
        command
            ->add_option("--from-matrices", options->fromMatrices,
                         tr("Modelview (16 numbers), projection (16) and viewport (4: x y width height),\n"
                            "or their product (16) and the viewport, or a text file that has them; - is\n"
                            "standard input. In this order, or each behind its name (modelview, view,\n"
                            "projection, MVP, viewport)"))
            ->expected(1, 64)
            ->excludes(from);
    addCameraOptions(*command, *options);
    addChoice<std::optional<NumberOrder>>(
        *command, "--order", options->order, {{"column", NumberOrder::ByColumns}, {"row", NumberOrder::ByRows}},
        tr("Order of the 16 numbers. Default, as programs print them: 16 in a row by\ncolumns, four lines or four "
           "brackets of four by rows, glm::to_string by\ncolumns"));
    CLI::Option *depth = addChoice<std::optional<NdcDepth>>(
        *command, "--depth", options->depth,
        {{"minus-one-to-one", NdcDepth::MinusOneToOne}, {"zero-to-one", NdcDepth::ZeroToOne}},
        tr("NDC depths of the projection"));
    CLI::Option *y = addChoice<std::optional<bool>>(*command, "--y", options->isYDown, {{"up", false}, {"down", true}},
                                                    tr("Direction of NDC y; down, as in Vulkan, flips it"));
    command->add_flag("--reversed", options->isReversed,
                      tr("Depths are 1 on the near plane: by the projection, or else by the depth\nrange"));
    addConventions(*command, options->conventions, tr("Conventions of the matrices, kept in the scene"))
        ->excludes(depth)
        ->excludes(y);
    command->add_flag(
        "--orthonormal", options->isOrthonormal,
        tr("Use the nearest view whose axes are perpendicular and of length 1, for a\nview printed with few digits"));
    command
        ->add_option("--window", options->window, tr("Size of the window in pixels; default: what the viewport needs"))
        ->type_name("WxH");
    addFile(*command, "-o,--output", options->output, tr("Scene file; - is standard output"))->default_str("-");
    command->footer(
        tr("Brackets, commas, subscripts (m[3] =) and other words between the numbers are ignored. If only one\norder "
           "of the numbers gives a camera, the matrix is read in that order; if both do, give --order. Other\nfindings "
           "are reported and the matrix is not changed: an inverse, depths from 0 to 1 or reversed, y\nflipped, a "
           "scale.")
        + "\n\n" + tr("Examples:")
        + "\n  unproject scene camera.yml --near 0.1 --far 100 -o scene.json --objects scan.ply\n  unproject scene "
          "--from-matrices "
          "matrices.txt -o scene.json\n  unproject scene --from-matrices "
          "\"modelview 1 0 0 0  0 1 0 0  0 0 1 0  0 0 -5 1\n      projection 1 0 0 0  0 1 0 0  0 0 -1.2 -1  0 0 -2.2 0 "
          " viewport 0 0 800 600\"");
    command->callback([options, from, matrices, &run] {
        if (from->count() == 0 && matrices->count() == 0)
            throw CLI::RequiredError(tr("%1 (or --from-matrices)", "FILE"));
        run = [options] { return runScene(*options); };
    });
}

void addMatrices(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("matrices", tr("Print all matrices of a scene"));
    auto options = std::make_shared<MatricesOptions>();
    addSceneFile(*command, options->scene);
    addConventions(*command, options->conventions, tr("Conventions of axes, depths and pixels; default: the scene's"));
    addChoice<std::optional<MatrixLayout>>(
        *command, "--layout", options->layout, {{"column", MatrixLayout::Column}, {"row", MatrixLayout::Row}},
        tr("Column vectors, M v, or row vectors, v M; default: as in the conventions"));
    addChoice<MatricesFormat>(*command, "--format", options->format,
                              {{"text", MatricesFormat::Text},
                               {"json", MatricesFormat::Json},
                               {"c", MatricesFormat::C},
                               {"numpy", MatricesFormat::NumPy},
                               {"latex", MatricesFormat::Latex}},
                              tr("Output format"));
    command->footer(tr("C arrays have OpenGL's order in memory in either layout.") + "\n\n" + tr("Examples:")
                    + "\n  unproject matrices scene.json\n  unproject matrices --conventions direct3d scene.json\n  "
                      "unproject matrices --format numpy --layout row scene.json > matrices.py");
    command->callback([options, &run] { run = [options] { return runMatrices(*options); }; });
}

void addCode(CLI::App &app, Run &run)
{
    using scene_code::CodeDialect;
    CLI::App *command =
        app.add_subcommand("code", tr("Write a scene as source code: its calls, and the inverse from a pixel"));
    auto options = std::make_shared<CodeOptions>();
    addSceneFile(*command, options->scene);
    addChoice<CodeDialect>(*command, "--for", options->dialect,
                           {{"glu", CodeDialect::Glu},
                            {"glm", CodeDialect::Glm},
                            {"qt", CodeDialect::Qt},
                            {"three", CodeDialect::ThreeJs},
                            {"numpy", CodeDialect::NumPy}},
                           tr("Library of the code"));
    addFile(*command, "-o,--output", options->output,
            tr("C++, JavaScript for three, Python for numpy; - is standard output"))
        ->default_str("-");
    command->footer(tr("Its screen2world(i, j, depth) unprojects the centre of a pixel, counted from the top left "
                       "corner in\ndevice pixels. For glu, handlers for a view of MFC follow at the end. Models are "
                       "only named. Comments list\nwhat the library cannot express.")
                    + "\n\n" + tr("Examples:")
                    + "\n  unproject code scene.json --for glm\n  unproject code scene.json --for three -o scene.js"
                      "\n  unproject code scene.json --for numpy -o scene.py");
    command->callback([options, &run] { run = [options] { return runCode(*options); }; });
}

void addCompare(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("compare", tr("Measure the errors of both methods"));
    auto options = std::make_shared<CompareOptions>();
    addSceneFile(*command, options->scene);
    command->add_flag("--json", options->isJson, tr("Write JSON instead of a table"));
    addCount(*command, "--pixels", options->pixels, 1000, tr("Pixels of the grid, across and down"));
    addCount(*command, "--depths", options->depths, 1000, tr("Depths of the grid, over the whole range"));
    command->footer(
        tr("Compares formula and matrix, in double and in single precision, with a computation in 50 digits.") + "\n\n"
        + tr("Example:") + "\n  unproject compare scene.json");
    command->callback([options, &run] { run = [options] { return runCompare(*options); }; });
}

void addMap(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("map", tr("Write an error map: a number for each pixel, as a float map"));
    auto options = std::make_shared<MapOptions>();
    addModelOrScene(*command, options->scene);
    std::map<std::string, maps::Quantity> quantities;
    for (const maps::Quantity quantity : maps::kQuantities)
        quantities.emplace(maps::keyOf(quantity), quantity);
    addChoice<maps::Quantity>(*command, "--what", options->quantity, quantities, tr("Quantity of the map"))
        ->default_str("")
        ->required();
    command
        ->add_option("--convention", options->convention,
                     tr("For a displacement, the program that answers or the mistake that is made:") + '\n'
                         + conventionNames())
        ->type_name("WORD")
        ->check([](const std::string &given) {
            if (maps::conventionNamed(given) != nullptr)
                return std::string();
            std::string names = conventionNames();
            std::erase(names, '\n');
            return tr("\"%1\" is not one of %2", given, names);
        });
    addChoice<maps::Unit>(*command, "--unit", options->unit, {{"world", maps::Unit::World}, {"ulp", maps::Unit::Ulps}},
                          tr("World units, or units in the last place of the formulas' largest coordinate"));
    command
        ->add_option("--size", options->size,
                     tr("Size of the view in device pixels. Default: the scene file's, or 800x600 for a\nmodel"))
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
                           tr("Rounding of the surfaces' depths: bits of an integer, or a float"));
    command->add_flag("--json", options->isJson, tr("Write the statistics as JSON to standard output"));
    addFile(*command, "-o,--output", options->output, tr("Portable float map (PFM); - is standard output"))->required();
    command->footer(
        tr("Needs no window and no OpenGL: the depth of each pixel's centre is that of its ray's hit, rounded as in a "
           "depth\nbuffer. Without a hit the map has NaN; rays do not hit points of clouds. Rows go from the bottom "
           "up, as in PFM.\n\n  formula-matrix  distance between the points of the formulas and of the inverted "
           "matrix\n  formula-ray     distance from the formulas' point to the hit on the mesh; matrix-ray: from the "
           "matrix's point\n  uncertainty     greatest distance of the surface from the point: the length of the +- of "
           "a click\n  displacement    distance from the formulas' point to that of another program, or of a mistake")
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
    CLI::App *command = app.add_subcommand("landmarks", tr("Convert landmarks between file formats, or to a table"));
    auto options = std::make_shared<LandmarksOptions>();
    CLI::Option *input = addFile(*command, "IN", options->input, tr("File of landmarks; - is standard input"));
    CLI::Option *converted = addFile(*command, "OUT", options->output, tr("File of landmarks; - is standard output"));
    CLI::Option *from =
        addLandmarkFormat(*command, "--from", options->from, tr("Format of IN, if its name does not tell"), false);
    CLI::Option *to =
        addLandmarkFormat(*command, "--to", options->to, tr("Format of OUT, if its name does not tell"), true);
    CLI::Option *mesh =
        addFile(*command, "--mesh", options->mesh,
                tr("Model; every landmark is moved onto it, to the closest point, and the distance is reported"))
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
                tr("Files of the same landmarks, placed two or more times, or a folder of them: the mean and the error "
                   "of each landmark"))
            ->type_name("FILE|FOLDER")
            ->excludes(input)
            ->excludes(converted)
            ->excludes(to)
            ->excludes(mesh)
            ->excludes(folder)
            ->expected(1, CLI::detail::expected_max_vector_size);
    CLI::Option *errors =
        addFile(*command, "--errors", options->errors,
                tr("With --repeats, the table of each landmark's error of measurement over all specimens"))
            ->needs(repeats);
    addFile(*command, "--measures", options->measures, tr("With --table, a protocol: its measures are columns"))
        ->needs(folder);
    CLI::Option *output = addFile(*command, "-o,--output", options->output, tr("The table; - is standard output"));
    addFile(*command, "--sliders", options->sliders,
            tr("Also write the sliders of semilandmarks, for geomorph's gpagen(curves=)"))
        ->excludes(repeats);
    auto form = std::make_shared<TableForm>(TableForm::Long);
    CLI::Option *given = addChoice<TableForm>(
        *command, "--format", *form,
        {{"long", TableForm::Long}, {"wide", TableForm::Wide}, {"tps", TableForm::Tps}, {"nts", TableForm::Nts}},
        tr("Form of the table: a row per landmark, a row per specimen, or a file of specimens; without it, by the "
           "name"));
    given->default_str("");
    addSpreadsheetSafe(*command, options->isSpreadsheetSafe);
    command->footer(
        tr("csv  this program's: name,x,y,z,object,face,u,v,w,note; keeps everything. Tables of R, 3D Slicer, "
           "CloudCompare\nand spreadsheets are read too (.txt, .tsv), with commas, semicolons, tabs or blanks between "
           "the columns\npp, pptpl  MeshLab: picked points, and a template of names\nmrk.json, fcsv  3D Slicer. Points "
           "in RAS get x and y negated, as in a mesh's file (LPS)\npts  IDAV Landmark\ntps, nts  tpsDig, geomorph, "
           "NTSYS (.dta too): many specimens\nlandmarkAscii, ljson  Amira and Avizo, landmarker.io; only "
           "read\n\nCoordinates keep all their digits. Data that a format cannot hold are reported on stderr. A file "
           "of a folder that\ncannot be read is reported on stderr and left out, and the exit code is 1. With --mesh "
           "the csv table has the\ntriangle of each landmark and its position there. Landmarks farther from the mesh "
           "than 1 % of its size are named.\nThe error of --repeats is the standard deviation of one placing, all "
           "three coordinates together; farthest is the\ngreatest distance from the mean. Landmarks are matched by "
           "their names.\n\nTables have all landmarks of all files, with NA where a specimen lacks one. Files beside a "
           "scan, as\nface.ply.points-2.csv, are placings of one specimen; the column placing tells them apart. A "
           "protocol is a table\nname,kind,landmarks; kinds are distance, angle, height, length and surface.")
        + "\n\n" + tr("Examples:")
        + "\n  unproject landmarks skull.pp skull.mrk.json\n  unproject landmarks --from fcsv --to csv - - < "
          "points.fcsv\n  unproject landmarks --table skulls -o all.csv\n  unproject landmarks --table skulls -o "
          "all.csv --format wide\n  unproject landmarks --table skulls --measures protocol.csv -o all.csv --format "
          "wide\n  unproject landmarks "
          "--repeats monday.pp tuesday.pp -o repeats.csv\n  unproject landmarks --repeats scans --errors errors.csv");
    command->callback([options, input, converted, output, folder, repeats, errors, form, given, &run] {
        if (given->count() > 0)
            options->table = *form;
        if (folder->count() == 0 && repeats->count() == 0) {
            if (output->count() > 0)
                throw CLI::RequiredError(tr("--table or --repeats (with -o)"));
            for (const CLI::Option *needed : {input, converted}) {
                if (needed->count() == 0)
                    throw CLI::RequiredError(tr("%1 (or --table)", needed->get_name()));
            }
        } else if (output->count() == 0 && errors->count() == 0) {
            throw CLI::RequiredError("-o,--output");
        }
        run = [options] { return runLandmarks(*options); };
    });
}

} // namespace unprojector::cli
