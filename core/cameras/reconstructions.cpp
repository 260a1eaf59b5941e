#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/cameras/camera_json.h"
#include "core/cameras/camera_matrices.h"
#include "core/cameras/camera_reader.h"
#include "core/geometry/numbers.h"

#include <nlohmann/json.hpp>

#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

// JSON of reconstructions from photographs, one function a program.

namespace unprojector::cameras {
using namespace geometry;
using base::tr;
using Json = nlohmann::ordered_json;

namespace {

/// The size of the lens in the file, which its numbers count in.
ImageSize lensSize(Reading &reading, const Json &lens)
{
    reading.camera.size = sizeOf(spelledNumber(lens, "width"), spelledNumber(lens, "height"));
    return reading.camera.size ? *reading.camera.size : reading.neededSize();
}

/// A view of a reconstruction, with the keys of its parts.
struct View {
    std::string name, id, lens, pose;
};

/// Chooses a view. Where the file has poses, those without one are left out.
View chosenView(Reading &reading, std::vector<View> views, const Json &poses, const char *key)
{
    std::set<std::string> posed;
    for (const Json &pose : poses)
        posed.insert(wordOf(pose, key));
    if (!posed.empty())
        std::erase_if(views, [&](const View &view) { return !posed.contains(view.pose); });
    if (views.empty())
        reading.fail(tr("there are no cameras"));
    std::vector<std::string> ids;
    for (const View &view : views) {
        reading.camera.images.push_back(view.name);
        ids.push_back(view.id);
    }
    reading.chooseImage(ids);
    return views[reading.camera.image];
}

[[noreturn]] void failWithoutLens(const Reading &reading, const std::string &image)
{
    reading.fail(tr("%1 has no intrinsics in the file; give a file that has them", image));
}

} // namespace

// Source: OpenMVG, cameras/Camera_Pinhole*_io.hpp, Camera_undistort_image.hpp (pixel centres at whole
// numbers), and the documentation of its poses: R from world to camera, and the centre C.
bool readOpenMvg(Reading &reading)
{
    const Json file = documentWith(reading.text, {"sfm_data_version", "views"});
    if (!file.is_object())
        return false;
    ForeignCamera &camera = reading.camera;
    reading.begin("OpenMVG", PoseDirection::WorldToCamera, EyeAxes::RightDownAhead);
    const JsonKeys data{"value", "ptr_wrapper", "data"};
    std::vector<View> views;
    for (const Json &entry : inside(file, {"views"})) {
        const Json &view = inside(entry, data);
        views.push_back(
            {wordOf(view, "filename"), wordOf(view, "id_view"), wordOf(view, "id_intrinsic"), wordOf(view, "id_pose")});
    }
    const Json &poses = inside(file, {"extrinsics"});
    const View view = chosenView(reading, std::move(views), poses, "key");
    const Json &entry = entryOf(inside(file, {"intrinsics"}), "key", view.lens), &lens = inside(entry, data),
               &base = memberOf(lens, "value0") ? inside(lens, {"value0"}) : lens; // of a parent class
    if (!lens.is_object())
        failWithoutLens(reading, view.name);
    // A later lens of the same class has no name, so the coefficients' key tells the model.
    std::optional<std::vector<double>> coefficients;
    if (memberOf(base, "focal_length") && !memberOf(lens, "fisheye"))
        coefficients.emplace();
    for (const char *key : {"disto_k1", "disto_k3", "disto_t2"}) {
        if (memberOf(lens, key))
            coefficients = numbersOf(lens, key);
    }
    const std::string name = wordOf(inside(entry, {"value"}), "polymorphic_name");
    setDistortion(reading, name.empty() ? "fisheye" : name, coefficients);
    lensSize(reading, base);
    const double focal = neededNumber(reading, base, "focal_length");
    const std::vector<double> centre = neededNumbers(reading, base, "principal_point", 2);
    camera.intrinsics = Intrinsics{focal, focal, centre[0], centre[1], 0.0, PixelCentres::AtIntegers};
    if (const Json &pose = inside(entryOf(poses, "key", view.pose), {"value"}); pose.is_object()) {
        camera.pose = matrixByRows(neededNumbers(reading, pose, "rotation", 9));
        camera.center = neededVector(reading, pose, "center");
    }
    return true;
}

namespace {

void setAliceVisionLens(Reading &reading, const Json &lens, const std::vector<double> &v)
{
    const std::vector<double> pixels = spelledNumbers(lens, "pxFocalLength"),
                              centre = neededNumbers(reading, lens, "principalPoint", 2);
    const double version = v.size() == 3 ? 1e4 * v[0] + 1e2 * v[1] + v[2] : pixels.empty() ? 10205 : 0;
    const ImageSize size = lensSize(reading, lens);
    const glm::dvec2 origin = version < 10201 ? glm::dvec2(0.0) : glm::dvec2(size.width, size.height) / 2.0;
    Intrinsics k{0.0, 0.0, origin.x + centre[0], origin.y + centre[1]};
    if (pixels.empty()) {
        const double ratio = spelledNumber(lens, "pixelRatio").value_or(1.0),
                     sensor = spelledNumber(lens, "sensorWidth").value_or(36.0); // AliceVision's own default
        k.fx = neededNumber(reading, lens, "focalLength") / sensor * size.width;
        k.fy = version < 10205 ? k.fx / ratio : k.fx * ratio;
        if (ratio != 1.0)
            reading.camera.assumed.push_back(tr("The pixel ratio is %1: fy is assumed %2 and fx %3.",
                                                base::shortestText(ratio), base::significantText(k.fy, 6),
                                                base::significantText(k.fx, 6)));
    } else {
        k.fx = pixels.front();
        k.fy = pixels.back();
    }
    reading.camera.intrinsics = k;
    // Later versions name the distortion apart from the projection, and keep 3DE's as an undistortion.
    const std::string type = wordOf(lens, "type"), later = wordOf(lens, "distortionType");
    std::vector<double> c = spelledNumbers(lens, "distortionParams");
    const auto areZero = [](const std::vector<double> &numbers) {
        return std::all_of(numbers.begin(), numbers.end(), [](double number) { return number == 0.0; });
    };
    constexpr std::array kBrown{"pinhole", "radial1", "radial3", "radialk1", "radialk3", "brown"};
    const std::string &model = later.empty() || later == "none" ? type : later;
    const bool isBrown = std::find(kBrown.begin(), kBrown.end(), model) != kBrown.end() || areZero(c);
    const bool isRead = isBrown && !type.starts_with("fisheye") && !type.starts_with("equi")
                        && areZero(spelledNumbers(lens, "undistortionParams"));
    setDistortion(reading, model, isRead ? std::optional(std::move(c)) : std::nullopt);
}

} // namespace

// Source: AliceVision, sfmDataIO/jsonIO.cpp: versions, units and what the principal point counts from;
// saveMatrix writes Eigen's order, by columns; image/undistort.cpp has pixel centres at whole numbers.
bool readAliceVision(Reading &reading)
{
    const Json file = documentWith(reading.text, {"views", "intrinsics", "intrinsicId"});
    if (!file.is_object())
        return false;
    ForeignCamera &camera = reading.camera;
    reading.begin("AliceVision", PoseDirection::WorldToCamera, EyeAxes::RightDownAhead);
    const Json &list = inside(file, {"views"}), &poses = inside(file, {"poses"});
    std::vector<View> views;
    for (const Json &view : list) {
        const std::string id = wordOf(view, "viewId"), pose = wordOf(view, "poseId");
        views.push_back({wordOf(view, "path"), id, wordOf(view, "intrinsicId"), pose.empty() ? id : pose});
    }
    const View view = chosenView(reading, std::move(views), poses, "poseId");
    const Json &lens = entryOf(inside(file, {"intrinsics"}), "intrinsicId", view.lens);
    if (!lens.is_object())
        failWithoutLens(reading, view.name);
    setAliceVisionLens(reading, lens, spelledNumbers(file, "version"));
    if (const Json &pose = inside(entryOf(poses, "poseId", view.pose), {"pose", "transform"}); pose.is_object()) {
        const Json &shown = entryOf(list, "viewId", view.id);
        const std::string alone = wordOf(shown, "isPoseIndependant");
        if (memberOf(shown, "rigId") && (alone == "false" || alone == "0"))
            reading.fail(tr("the pose of %1 is that of its rig; poses of rigs are not read", view.name));
        camera.pose = glm::transpose(*matrixByRows(neededNumbers(reading, pose, "rotation", 9)));
        camera.center = neededVector(reading, pose, "center");
    }
    return true;
}

// Source: OpenSfM, doc/source/geometry.rst: normalized coordinates count from the image's middle, and
// the larger side is 1; opensfm/io.py: rotation is an angle-axis from world to camera.
bool readOpenSfm(Reading &reading)
{
    const Json file = documentWith(reading.text, {"cameras", "shots"});
    std::vector<std::pair<const Json *, const Json *>> shots; // a reconstruction, and one of its shots
    ForeignCamera &camera = reading.camera;
    for (const Json *reconstruction : elementsOf(file)) {
        const Json &all = inside(*reconstruction, {"shots"});
        for (auto shot = all.begin(); all.is_object() && shot != all.end(); ++shot) {
            camera.images.push_back(shot.key());
            shots.emplace_back(reconstruction, &*shot);
        }
    }
    if (shots.empty())
        return false;
    reading.begin("OpenSfM", PoseDirection::WorldToCamera, EyeAxes::RightDownAhead);
    reading.chooseImage();
    const Json &reconstruction = *shots[camera.image].first, &shot = *shots[camera.image].second;
    const Json &lens = inside(reconstruction, {"cameras", wordOf(shot, "camera").c_str()});
    if (!lens.is_object())
        failWithoutLens(reading, camera.images[camera.image]);
    const auto of = [&lens](const char *key) { return numberOf(lens, key).value_or(0.0); };
    const std::string type = wordOf(lens, "projection_type");
    constexpr std::array kRead{"", "perspective", "simple_radial", "radial", "brown"};
    const bool isRead = std::find(kRead.begin(), kRead.end(), type) != kRead.end();
    setDistortion(reading, type,
                  isRead ? std::optional(std::vector{of("k1"), of("k2"), of("k3"), of("p1"), of("p2")}) : std::nullopt);
    const ImageSize size = lensSize(reading, lens);
    const double side = std::max(size.width, size.height);
    const bool hasTwo = memberOf(lens, "focal_x") != nullptr;
    camera.intrinsics = Intrinsics{side * neededNumber(reading, lens, hasTwo ? "focal_x" : "focal"),
                                   side * neededNumber(reading, lens, hasTwo ? "focal_y" : "focal"),
                                   size.width / 2.0 + side * of("c_x"),
                                   size.height / 2.0 + side * of("c_y"),
                                   0.0,
                                   PixelCentres::AtHalves,
                                   true};
    camera.pose =
        rigid(rotationOf(neededVector(reading, shot, "rotation")), neededVector(reading, shot, "translation"));
    if (memberOf(reconstruction, "reference_lla"))
        camera.assumed.push_back(tr("The world's axes are metres east, north and up of reference_lla; objects in "
                                    "other coordinates do not fit."));
    return true;
}

// Source: nerfstudio, cameras/camera_paths.py; viewer/render_panel.py for its key frames.
bool readCameraPath(Reading &reading)
{
    const Json file = documentWith(reading.text, {"camera_path", "render_height"});
    if (!file.is_object())
        return false;
    ForeignCamera &camera = reading.camera;
    reading.begin("Nerfstudio", PoseDirection::CameraToWorld, EyeAxes::RightUpBack);
    const bool isPath = !inside(file, {"camera_path"}).empty();
    const Json &list = inside(file, {isPath ? "camera_path" : "keyframes"});
    if (!list.is_array() || list.empty())
        reading.fail(tr("there are no cameras"));
    for (std::size_t i = 0; i < list.size(); ++i)
        camera.images.push_back(std::to_string(i));
    reading.chooseImage();
    const Json &one = list[camera.image];
    for (const char *key : {"camera_type", "camera_model"}) {
        if (const std::string type = wordOf(file, key); !type.empty() && type != "perspective")
            setDistortion(reading, type, {});
    }
    camera.size = sizeOf(numberOf(file, "render_width"), numberOf(file, "render_height"));
    camera.pose = matrixByRows(neededNumbers(reading, one, isPath ? "camera_to_world" : "matrix", 16));
    reading.setVerticalAngle(radiansFromDegrees(neededNumber(reading, one, "fov")));
    camera.assumed.push_back(tr("Coordinates are those of Nerfstudio's viewer: its data parser moved and scaled the "
                                "world, as dataparser_transforms.json tells."));
    return true;
}

} // namespace unprojector::cameras
