#include "core/cli/commands/doctor_command.h"

#include "core/base/number_text.h"
#include "core/base/path_text.h"
#include "core/base/translation.h"
#include "core/cameras/lens.h"
#include "core/cli/commands/doctor_texts.h"
#include "core/cli/commands/lens_option.h"
#include "core/cli/commands/opened_scene.h"
#include "core/cli/commands/size_text.h"
#include "core/cli/commands/wrong_points.h"
#include "core/cli/rows/byte_stream.h"
#include "core/cli/rows/scene_input.h"
#include "core/doctor/known_points.h"
#include "core/doctor/program.h"
#include "core/doctor/report_text.h"
#include "core/doctor/written_points.h"
#include "core/geometry/error_text.h"
#include "core/opening/models.h"
#include "core/ray/mesh_point.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
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

/// A case, and the files of its scene.
struct CaseRead {
    Case scene;
    InputFiles files;
};

/// True if all models of a scene exist and are readable.
bool areModelsThere(const std::string &file)
{
    const std::optional<SceneFile> scene = file == "-" ? std::nullopt : readScene(file);
    if (!scene)
        return false;
    const std::vector<std::filesystem::path> models = opening::modelFiles(*scene, base::pathFromUtf8(file));
    return std::all_of(models.begin(), models.end(), [](const std::filesystem::path &model) {
        std::error_code ignored;
        return std::filesystem::exists(model, ignored);
    });
}

/// The vertices of a scene's models, read on the first call; none if a model is missing.
std::function<std::vector<KnownPoint>(const Box &)> verticesOnceRead(const std::string &file)
{
    return [file, opened = std::optional<OpenedScene>(), isRead = false](const Box &world) mutable {
        if (!isRead && areModelsThere(file))
            opened = openScene(file);
        isRead = true;
        return opened ? verticesIn(opened->objects, world) : std::vector<KnownPoint>();
    };
}

/// The case without meshes. Errors are printed on stderr.
std::optional<CaseRead> withoutMesh(const std::string &file)
{
    const std::optional<SceneFile> scene = readScene(file);
    if (!scene)
        return std::nullopt;
    Case result{setupOf(*scene), {}, {}, {}, verticesOnceRead(file)};
    for (const SceneFileObject &object : scene->objects)
        result.models.push_back({object.name, preciseWorldFromObject(object.transform)});
    return CaseRead{std::move(result), filesOf(*scene, file)};
}

std::optional<CaseRead> withMesh(const std::string &file)
{
    const std::optional<OpenedScene> opened = openScene(file);
    const std::optional<Setup> setup = opened ? setupOf(*opened, std::string()) : std::nullopt;
    if (!setup)
        return std::nullopt;
    Case result{*setup, {}, {}, {}, {}};
    for (const SceneObject &object : opened->objects)
        result.models.push_back({object.name, preciseWorldFromObject(object.transform)});
    const Result<Unprojector> unprojector = Unprojector::of(*setup);
    if (!unprojector) {
        complain(opened->name + ": " + errorText(unprojector.error()));
        return std::nullopt;
    }
    if (!opened->objects.empty()) {
        result.pointOnMesh = ray::MeshPoint(std::make_shared<ray::SceneRays>(raysOf(*opened, *unprojector)));
        result.verticesIn = [objects = opened->objects](const Box &world) { return verticesIn(objects, world); };
    }
    return CaseRead{std::move(result), opened->files};
}

/// The case of a scene. Meshes are loaded only where a depth is missing, so that otherwise a scene
/// without its models suffices.
std::optional<CaseRead> caseOf(const std::string &file, bool isDepthMissing)
{
    if (!isMeantAsScene(file))
        return withMesh(file);
    if (!isDepthMissing)
        return withoutMesh(file);
    std::optional<CaseRead> result = withMesh(file);
    if (result || file == "-")
        return result;
    result = withoutMesh(file);
    if (result)
        complain(tr("%1: without its models, pixels without a depth are checked by their rays only", file));
    return result;
}

/// Sets the space of the points. Errors are printed on stderr.
bool setSpace(std::vector<WrongPoint> &points, const std::string &space, const Case &scene)
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
        if (found == scene.models.end()) {
            complain(scene.models.empty()
                         ? tr("--got-space %1: the scene has no objects", space)
                         : tr("--got-space %1: give object:NAME with one of the scene's objects: %2", space, names));
            return false;
        }
        model = std::size_t(found - scene.models.begin());
    }
    for (WrongPoint &point : points) {
        point.space = named;
        point.model = model;
    }
    return true;
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

/// Sets the distortion, and removes the points whose pixels it cannot be undone for. Errors are
/// printed on stderr.
bool setDistortion(Case &scene, WrongPoints &given, const DoctorOptions &options)
{
    const std::optional<SceneLens> lens = sceneLens(options.distortion, scene.setup, options.scene);
    if (!lens)
        return false;
    scene.distortion = lens->distortion;
    for (std::size_t i = given.points.size(); i-- > 0;) {
        if (cameras::undistortedPixel(lens->distortion, lens->pinhole, given.points[i].pixel.coordinates()))
            continue;
        complain(tr("%1: the distortion cannot be undone at this pixel: %2 fold the image over there; check them",
                    given.names[i], cameras::coefficientsText(lens->distortion)));
        given.isComplete = false;
        given.points.erase(given.points.begin() + std::ptrdiff_t(i));
        given.names.erase(given.names.begin() + std::ptrdiff_t(i));
    }
    return true;
}

} // namespace

ExitCode runDoctor(const DoctorOptions &options)
{
    WrongPoints given;
    if (options.points.empty()) {
        const std::optional<WrongPoint> point = wrongPoint(options.pixel, options.depth, options.got);
        if (!point)
            return ExitCode::UnusableInput;
        given = {{*point}, {"--pixel"}};
    } else {
        if (options.points == "-" && options.scene == "-") {
            complain(tr("the scene and the points cannot both come from standard input; give a file for one of them"));
            return ExitCode::UnusableInput;
        }
        std::optional<WrongPoints> table = wrongPoints(options.points);
        if (!table)
            return ExitCode::UnusableInput;
        given = std::move(*table);
    }
    const bool isDepthMissing =
        std::any_of(given.points.begin(), given.points.end(), [](const WrongPoint &p) { return !p.depth; });
    std::optional<SizeGiven> otherSize;
    if (!options.otherSize.empty() && !(otherSize = sizeGiven("--other-size", options.otherSize)))
        return ExitCode::UnusableInput;
    std::optional<CaseRead> read = caseOf(options.scene, isDepthMissing);
    if (!read || !setSpace(given.points, options.gotSpace, read->scene))
        return ExitCode::UnusableInput;
    if (!options.points.empty())
        read->files.push_back(options.points);
    ByteSink sink("-", read->files);
    if (!sink.isOpen())
        return ExitCode::UnusableInput;
    Case &scene = read->scene;
    if (otherSize) {
        scene.otherSize = Surface{otherSize->width, otherSize->height, 1.0};
        if (const Check valid = check(*scene.otherSize); !valid) {
            complain("--other-size " + options.otherSize + ": " + errorText(valid.error()));
            return ExitCode::UnusableInput;
        }
    }
    leaveOutside(given, scene.setup.surface);
    if (!options.distortion.empty() && !setDistortion(scene, given, options))
        return ExitCode::UnusableInput;
    if (given.points.empty())
        return ExitCode::UnusableInput;
    const Result<Diagnosis> diagnosis = diagnose(scene, given.points);
    if (!diagnosis) {
        const Error &error = diagnosis.error();
        complain(error.code == ErrorCode::DepthOutsideRange ? depthRefused(given, error.value, scene.setup)
                                                            : options.scene + ": " + errorText(error));
        return ExitCode::UnusableInput;
    }
    if (options.isJson)
        sink.write(doctorJson(*diagnosis));
    else
        sink.print(reportText(*diagnosis, given.points[diagnosis->firstPoint()]));
    const ExitCode written = sink.finish();
    return written == ExitCode::Done && !given.isComplete ? ExitCode::SomeRowsBad : written;
}

} // namespace unprojector::cli
