#include "core/base/json.h"
#include "core/base/number_text.h"
#include "core/base/path_text.h"
#include "core/base/translation.h"
#include "core/cameras/lens.h"
#include "core/cli/commands/command.h"
#include "core/cli/commands/inputs.h"
#include "core/cli/rows/scene_input.h"
#include "core/cli/terminal/refusal.h"
#include "core/doctor/diagnosis.h"
#include "core/doctor/known_points.h"
#include "core/doctor/mistakes.h"
#include "core/doctor/report_text.h"
#include "core/doctor/written_points.h"
#include "core/opening/models.h"
#include "core/ray/mesh_point.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace unprojector::cli {
using namespace geometry;
using namespace scene;
using namespace scene_file;
using namespace unproject;
using namespace doctor;
using namespace base;
namespace {

struct DoctorOptions {
    std::string scene;              ///< a model, a scene or clicks; "-" is a scene from stdin
    std::string pixel;              ///< "X,Y", continuous device pixels
    std::string depth;              ///< empty: unknown
    std::string got;                ///< "X,Y,Z", as the program printed them
    std::string gotSpace = "world"; ///< world, eye, object or object:NAME
    std::string points;             ///< CSV px,py,depth,x,y,z, replaces pixel, depth and got; "-" is stdin
    std::string otherSize;          ///< "WxH"; empty: none
    std::string distortion;         ///< see SceneLens; empty: none
    bool isJson = false;
};

/// The points of a table, and whether all its rows were used.
struct WrongPoints {
    std::vector<WrongPoint> points;
    std::vector<std::string> names; ///< name of each point, for messages: "wrong.csv:3", "--pixel"
    bool isComplete = true;
};

std::string rowErrorText(const PointRow &row, std::size_t index)
{
    if (index >= kPointColumns.size())
        return tr("the row has more than six cells; give px,py,depth,x,y,z, with a point for the decimals");
    return std::string(kPointColumns[index]) + ": " + tr("\"%1\" is not a number", row.cells[index]);
}

/// The size limit of the input, far above the need of that many points.
constexpr std::size_t kMostPointBytes = std::size_t{1} << 24;

/// Reads CSV with the columns px,py,depth,x,y,z, found by name, or in this order without a header.
/// @param file  UTF-8; "-" for stdin
WrongPoints wrongPoints(const std::string &file)
{
    ByteSource source(file);
    const std::string text = source.readAll(kMostPointBytes);
    if (text.size() > kMostPointBytes)
        refuse(tr("%1: larger than %2 MB; give only the points to check, of which the first %3 are used", source.name(),
                  kMostPointBytes >> 20, kMostWrongPoints));
    const auto where = [&](std::size_t line) { return source.name() + ':' + std::to_string(line) + ": "; };
    const Result<std::vector<PointRow>, CsvError> rows = pointRows(text);
    if (!rows)
        refuse(where(rows.error().line) + rows.error().text);
    WrongPoints result;
    std::size_t surplus = 0;
    for (const PointRow &row : *rows) {
        if (result.points.size() == kMostWrongPoints) {
            ++surplus;
            continue;
        }
        if (const auto point = pointOf(row)) {
            result.points.push_back(*point);
            result.names.push_back(source.name() + ':' + std::to_string(row.line));
        } else {
            complain(where(row.line) + rowErrorText(row, point.error()));
            result.isComplete = false;
        }
    }
    if (surplus > 0)
        complain(tr(surplus == 1 ? "%1: the first %2 points are used; %3 more is ignored"
                                 : "%1: the first %2 points are used; %3 more are ignored",
                    source.name(), kMostWrongPoints, surplus));
    if (result.points.empty())
        refuse(tr("%1: there is no point in it; give rows of px,py,depth,x,y,z", source.name()));
    return result;
}

Json jsonOf(const glm::dvec3 &v)
{
    return Json::array({jsonNumber(v.x), jsonNumber(v.y), jsonNumber(v.z)});
}

/// One number, an array of several, or a word under each name.
Json jsonOf(const std::vector<SolvedValue> &values)
{
    Json json = Json::object();
    for (const SolvedValue &value : values) {
        Json numbers = Json::array();
        for (const double number : value.numbers)
            numbers.push_back(jsonNumber(number));
        json[value.name] = !value.word.empty() ? Json(value.word) : numbers.size() == 1 ? numbers.front() : numbers;
    }
    return json;
}

// Words of the JSON, in the order of ErrorKind, Alike, Shared, DepthKnown and KnownPoint::Kind.
constexpr std::string_view kWrongNames[] = {"right", "pixel", "depth", "matrix"};
constexpr std::string_view kAlikeNames[] = {"no", "digits", "here", "always"};
constexpr std::string_view kSharedNames[] = {"window", "depth", "projection", "view", "ndc", "matrix", "point"};
constexpr std::string_view kDepthNames[] = {"given", "mesh", "unknown"};
constexpr std::string_view kKnownNames[] = {"eye",          "view-translation", "camera-centre",
                                            "world-origin", "object-origin",    "vertex"};

Json jsonOf(const KnownPoint &known)
{
    Json one{{"kind", kKnownNames[std::size_t(known.kind)]}, {"point", jsonOf(known.point)}};
    if (!known.object.empty())
        one["object"] = known.object;
    if (known.kind == KnownPoint::Kind::Vertex)
        one["vertex"] = known.vertex;
    return one;
}

std::string doctorJson(const Diagnosis &diagnosis)
{
    const InEnglish english;
    Json json;
    json["verdict"] = diagnosis.verdict;
    if (diagnosis.except)
        json["except"] = Json::array({diagnosis.except->point + 1});
    json["candidates"] = Json::array();
    for (const Candidate &candidate : diagnosis.candidates) {
        Json one{{"id", candidate.id},
                 {"point", jsonOf(candidate.point)},
                 {"distance", jsonNumber(candidate.distance)},
                 {"digits", candidate.digits},
                 {"explains", candidate.explains}};
        if (!candidate.values.empty())
            one["values"] = jsonOf(candidate.values);
        if (!candidate.ways.empty())
            one["variant"] = waysText(candidate.ways);
        if (candidate.alike != Alike::No)
            one["alike"] = kAlikeNames[std::size_t(candidate.alike)];
        if (candidate.shared)
            one["shared"] = kSharedNames[std::size_t(*candidate.shared)];
        json["candidates"].push_back(one);
    }
    json["known"] = Json::array();
    for (const KnownPoint &known : diagnosis.known)
        json["known"].push_back(jsonOf(known));
    json["projected"] = diagnosis.projected ? jsonOf(*diagnosis.projected) : Json();
    json["next"] = Json();
    if (diagnosis.next)
        json["next"] = {{"pixel", Json::array({jsonNumber(diagnosis.next->x), jsonNumber(diagnosis.next->y)})},
                        {"apart", jsonNumber(diagnosis.nextApart)}};
    json["right"] = diagnosis.right ? jsonOf(*diagnosis.right) : Json();
    json["digitsGiven"] = diagnosis.digitsGiven;
    json["digitsWritten"] = diagnosis.digitsWritten;
    json["wrong"] = diagnosis.tellsWrong() ? Json(kWrongNames[std::size_t(diagnosis.wrong)]) : Json();
    json["depth"] = kDepthNames[std::size_t(diagnosis.depthKnown)];
    json["tried"] = diagnosis.tried;
    json["singlePrecision"] = diagnosis.isSinglePrecision;
    json["chance"] = jsonNumber(diagnosis.chance);
    json["sentence"] = diagnosis.verdict == "known-point" ? knownPointSentence(diagnosis.known)
                       : diagnosis.namesMistake()         ? candidateSentence(diagnosis.candidates.front())
                                                          : std::string();
    json["code"] = Json::array();
    for (const std::string &part : partsOf(diagnosis.verdict)) {
        for (const CodeChange &change : codeOf(part, diagnosis.candidates.front().values))
            json["code"].push_back(
                {{"id", part}, {"library", change.library}, {"wrong", change.wrong}, {"right", change.right}});
    }
    return jsonLine(json) + '\n';
}

/// A case, and the files of its scene.
struct CaseRead {
    Case scene;
    InputFiles files;
};

/// True if all models of a scene exist and are readable.
bool areModelsThere(const std::string &file)
{
    if (file == "-")
        return false;
    const std::vector<std::filesystem::path> models = opening::modelFiles(readScene(file), base::pathFromUtf8(file));
    return std::all_of(models.begin(), models.end(), [](const std::filesystem::path &model) {
        std::error_code ignored;
        return std::filesystem::exists(model, ignored);
    });
}

/// The vertices of a scene's models, read on the first call; none if a model is missing.
std::function<std::vector<KnownPoint>(const Box &)> verticesOnceRead(const std::string &file)
{
    return [file, objects = std::vector<SceneObject>(), isRead = false](const Box &world) mutable {
        if (!std::exchange(isRead, true)) {
            try {
                if (areModelsThere(file))
                    objects = openScene(file).objects;
            } catch (const Refused &) { // the reason is printed
            }
        }
        return verticesIn(objects, world);
    };
}

CaseRead withoutMesh(const std::string &file)
{
    const SceneFile scene = readScene(file);
    Case result{setupOf(scene), {}, {}, {}, verticesOnceRead(file)};
    for (const SceneFileObject &object : scene.objects)
        result.models.push_back({object.name, preciseWorldFromObject(object.transform)});
    return {std::move(result), filesOf(scene, file)};
}

CaseRead withMesh(const std::string &file)
{
    const OpenedScene opened = openScene(file);
    Case result{setupOf(opened, std::string()), {}, {}, {}, {}};
    for (const SceneObject &object : opened.objects)
        result.models.push_back({object.name, preciseWorldFromObject(object.transform)});
    const Unprojector unprojector = needed(Unprojector::of(result.setup), opened.name);
    if (!opened.objects.empty()) {
        result.pointOnMesh = ray::MeshPoint(std::make_shared<ray::SceneRays>(raysOf(opened, unprojector)));
        result.verticesIn = [objects = opened.objects](const Box &world) { return verticesIn(objects, world); };
    }
    return {std::move(result), opened.files};
}

/// The case of a scene. Meshes are loaded only where a depth is missing, so that otherwise a scene
/// without its models suffices.
CaseRead caseOf(const std::string &file, bool isDepthMissing)
{
    if (isMeantAsScene(file) && !isDepthMissing)
        return withoutMesh(file);
    try {
        return withMesh(file);
    } catch (const Refused &) {
        if (!isMeantAsScene(file) || file == "-")
            throw;
    }
    CaseRead result = withoutMesh(file);
    complain(tr("%1: without its models, pixels without a depth are checked by their rays only", file));
    return result;
}

/// Sets the space of the points.
void setSpace(std::vector<WrongPoint> &points, const std::string &space, const Case &scene)
{
    PointSpace named = PointSpace::World;
    std::size_t model = 0;
    constexpr std::string_view kObject = "object";
    if (space == "eye") {
        named = PointSpace::Eye;
    } else if (space.starts_with(kObject)) {
        named = PointSpace::Object;
        std::string name = space.size() > kObject.size() ? space.substr(kObject.size() + 1) : std::string();
        std::string names;
        for (const PlacedModel &placed : scene.models)
            names += (names.empty() ? "" : ", ") + placed.name;
        if (space == kObject && scene.models.size() == 1)
            name = scene.models.front().name;
        const auto found = std::find_if(scene.models.begin(), scene.models.end(),
                                        [&](const PlacedModel &placed) { return placed.name == name; });
        if (found == scene.models.end())
            refuse(scene.models.empty()
                       ? tr("--got-space %1: the scene has no objects", space)
                       : tr("--got-space %1: give object:NAME with one of the scene's objects: %2", space, names));
        model = std::size_t(found - scene.models.begin());
    }
    for (WrongPoint &point : points) {
        point.space = named;
        point.model = model;
    }
}

/// Removes the points whose pixels lie outside the view, and reports them on stderr.
void leaveOutside(WrongPoints &given, const Surface &surface)
{
    WrongPoints inside{{}, {}, given.isComplete};
    for (std::size_t i = 0; i < given.points.size(); ++i) {
        const DevicePoint &at = given.points[i].pixel;
        if (at.x >= 0.0 && at.y >= 0.0 && at.x <= surface.widthPixels && at.y <= surface.heightPixels) {
            inside.points.push_back(given.points[i]);
            inside.names.push_back(given.names[i]);
            continue;
        }
        inside.isComplete = false;
        complain(tr("%1: %2,%3 lies outside the view of %4x%5; give device pixels from its top left corner",
                    given.names[i], shortestText(at.x), shortestText(at.y), surface.widthPixels, surface.heightPixels));
    }
    given = std::move(inside);
}

/// The message that names the point with the rejected depth, and the remedy.
std::string depthRefused(const WrongPoints &given, double depth, const Setup &setup)
{
    const auto refused = std::find_if(given.points.begin(), given.points.end(),
                                      [depth](const WrongPoint &point) { return point.depth == depth; });
    const std::string place = refused == given.points.end() || given.names.front() == "--pixel"
                                  ? "--depth"
                                  : given.names[std::size_t(refused - given.points.begin())] + ": depth";
    return place + ": " + depthOutsideText(shortestText(depth), setup.depthRange);
}

/// Sets the distortion, and removes the points whose pixels it cannot be undone for. Reports them on
/// stderr.
void setDistortion(Case &scene, WrongPoints &given, const DoctorOptions &options)
{
    const SceneLens lens = sceneLens(options.distortion, scene.setup, options.scene);
    scene.distortion = lens.distortion;
    for (std::size_t i = given.points.size(); i-- > 0;) {
        if (cameras::undistortedPixel(lens.distortion, lens.pinhole, given.points[i].pixel.coordinates()))
            continue;
        complain(tr("%1: the distortion cannot be undone at this pixel: %2 fold the image over there; check them",
                    given.names[i], cameras::coefficientsText(lens.distortion)));
        given.isComplete = false;
        given.points.erase(given.points.begin() + std::ptrdiff_t(i));
        given.names.erase(given.names.begin() + std::ptrdiff_t(i));
    }
}

ExitCode runDoctor(const DoctorOptions &options)
{
    WrongPoints given;
    if (options.points.empty()) {
        const auto point = wrongPointOf(options.pixel, options.depth, options.got, {"--pixel", "--depth", "--got"});
        if (!point)
            refuse(point.error());
        given = {{*point}, {"--pixel"}};
    } else {
        if (options.points == "-" && options.scene == "-")
            refuse(tr("the scene and the points cannot both come from standard input; give a file for one of them"));
        given = wrongPoints(options.points);
    }
    const bool isDepthMissing =
        std::any_of(given.points.begin(), given.points.end(), [](const WrongPoint &p) { return !p.depth; });
    std::optional<Surface> otherSize;
    if (!options.otherSize.empty())
        otherSize = surfaceGiven("--other-size", options.otherSize);
    CaseRead read = caseOf(options.scene, isDepthMissing);
    Case &scene = read.scene;
    setSpace(given.points, options.gotSpace, scene);
    if (!options.points.empty())
        read.files.push_back(options.points);
    ByteSink sink("-", read.files);
    scene.otherSize = otherSize;
    leaveOutside(given, scene.setup.surface);
    if (!options.distortion.empty())
        setDistortion(scene, given, options);
    if (given.points.empty())
        throw Refused();
    const Result<Diagnosis> diagnosis = diagnose(scene, given.points);
    if (!diagnosis && diagnosis.error().code == geometry::ErrorCode::DepthOutsideRange)
        refuse(depthRefused(given, diagnosis.error().value, scene.setup));
    const Diagnosis found = needed(diagnosis, options.scene);
    if (options.isJson)
        sink.write(doctorJson(found));
    else
        sink.print(asText(reportOf(found, given.points[found.firstPoint()])));
    return std::max(sink.finish(), given.isComplete ? ExitCode::Done : ExitCode::SomeRowsBad);
}

} // namespace

void addDoctor(const Command &command)
{
    const auto options = std::make_shared<DoctorOptions>();
    command.modelOrScene(options->scene);
    CLI::Option *pixel = command.add("--pixel", options->pixel);
    CLI::Option *depth = command.add("--depth", options->depth);
    CLI::Option *got = command.add("--got", options->got);
    command
        .word(
            "--got-space", "world, eye, object, object:NAME",
            [options](const std::string &given) { options->gotSpace = given; },
            [](const std::string &given) {
                return given == "world" || given == "eye" || given == "object" || given.starts_with("object:");
            })
        ->default_str("world");
    command.file("--points", options->points)->excludes(pixel)->excludes(depth)->excludes(got);
    command.add("--other-size", options->otherSize);
    command.add("--distortion", options->distortion);
    command.flag("--json", options->isJson);
    command.runs(options, [command](const DoctorOptions &given) {
        for (const char *option : {"--pixel", "--got"}) {
            if (!command.has("--points") && !command.has(option))
                throw CLI::RequiredError(tr("%1 (or --points)", option));
        }
        return runDoctor(given);
    });
}

} // namespace unprojector::cli
