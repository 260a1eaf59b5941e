#include "core/base/json.h"
#include "core/base/translation.h"
#include "core/cameras/camera_json.h"
#include "core/cameras/camera_reader.h"
#include "core/geometry/numbers.h"
#include "core/geometry/projection.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

// JSON of captures, data sets and scenes, one function a program.

namespace unprojector::cameras {
using namespace geometry;
using base::tr;
using Json = nlohmann::ordered_json;

namespace {

/// The rotation of a quaternion; fails for 0.
glm::dmat3 neededRotation(const Reading &reading, std::size_t line, double w, double x, double y, double z)
{
    const auto rotation = rotationOf(w, x, y, z);
    if (!rotation)
        reading.fail(tr("the image's quaternion is 0; a rotation has the length 1"), line);
    return *rotation;
}

/// K of nine numbers, by rows or by columns: its last row is 0 0 1.
Intrinsics intrinsicsOf(const std::vector<double> &k, PixelCentres centres)
{
    const bool isByColumns = k[2] == 0.0 && k[5] == 0.0;
    return isByColumns ? Intrinsics{k[0], k[4], k[6], k[7], k[3], centres}
                       : Intrinsics{k[0], k[4], k[2], k[5], k[1], centres};
}

void sayWholeCentres(Reading &reading)
{
    reading.camera.assumed.push_back(
        tr("Pixel centres are assumed at whole numbers; --pixel-centers half says otherwise."));
}

/// Begins a camera of ARKit's numbers.
/// Source: Apple, ARCamera: x right, y up, -z ahead; the principal point from the corner of the image
void beginArKit(Reading &reading, const char *program)
{
    reading.begin(program, PoseDirection::CameraToWorld, EyeAxes::RightUpBack);
    reading.camera.assumed.push_back(tr("Pixel centres are read at halves: ARKit counts the principal point from the "
                                        "image's corner. --pixel-centers integer says otherwise."));
}

using Keys = std::span<const std::string_view>;

bool hasOnly(const Json &object, Keys keys)
{
    for (auto item = object.begin(); item != object.end(); ++item) {
        if (std::find(keys.begin(), keys.end(), item.key()) == keys.end())
            return false;
    }
    return true;
}

/// Returns whether an object is an image's record of BOP. Other programs have cam_K, too.
bool isBopRecord(const Json &json)
{
    constexpr std::array<std::string_view, 10> kKeys{"cam_K", "cam_R_w2c", "cam_t_w2c", "depth_scale", "view_level",
                                                     "width", "height",    "elev",      "azimuth",     "mode"};
    return memberOf(json, "cam_K") && hasOnly(json, kKeys);
}

/// Returns whether an object is such a record, or several by their ids.
bool isBops(const Json &json)
{
    return isBopRecord(json)
           || (json.is_object() && !json.empty() && std::all_of(json.begin(), json.end(), isBopRecord));
}

/// Returns whether an object is BOP's camera.json. Depth cameras of other programs have more keys.
bool isBopLens(const Json &json)
{
    constexpr std::array<std::string_view, 7> kKeys{"cx", "cy", "depth_scale", "fx", "fy", "height", "width"};
    return json.is_object() && json.size() == kKeys.size() && hasOnly(json, kKeys);
}

} // namespace

// Source: bop_toolkit, docs/bop_datasets_format.md: numbers by rows, OpenCV's axes, millimetres.
std::optional<ForeignCamera> readBop(std::span<const NamedText> texts, const CameraChoices &choices)
{
    const NamedText *of = nullptr, *ofSize = nullptr, *ofObjects = nullptr;
    Json file, lens;
    for (const NamedText &text : texts) {
        if (Json found = strictDocumentWith(text, {"cam_K"}); isBops(found)) {
            of = &text;
            file = std::move(found);
        } else if (found = strictDocumentWith(text, {"depth_scale", "fx"}); isBopLens(found)) {
            ofSize = &text;
            lens = std::move(found);
        } else if (isJson(text.text) && lineOfKey(text.text, "cam_R_m2c") > 0) {
            ofObjects = &text;
        }
    }
    if (!of && !ofSize && !ofObjects)
        return std::nullopt;
    Reading reading(of ? *of : ofSize ? *ofSize : *ofObjects, choices);
    ForeignCamera &camera = reading.camera;
    reading.begin("BOP", PoseDirection::WorldToCamera, EyeAxes::RightDownAhead);
    if (!of && !ofSize)
        reading.fail(tr("scene_gt.json has the poses of objects and no camera; give scene_camera.json"));
    const auto number = [&](const char *key) { return neededNumber(Reading(*ofSize, choices), lens, key); };
    if (ofSize) {
        camera.size = sizeOf(number("width"), number("height"));
        camera.files.push_back(ofSize->name);
    }
    if (!of)
        camera.intrinsics = Intrinsics{number("fx"), number("fy"), number("cx"), number("cy")};
    if (of) {
        const bool isOne = memberOf(file, "cam_K") != nullptr; // an image's record, without its id
        std::vector<std::string> ids;
        for (auto item = file.begin(); item != file.end() && !isOne; ++item) {
            const std::string &id = ids.emplace_back(item.key());
            camera.images.push_back(std::string(id.size() < 6 ? 6 - id.size() : 0, '0') + id); // 000048.png
        }
        if (!isOne)
            reading.chooseImage(ids);
        const Json &one = isOne ? file : inside(file, {ids[camera.image].c_str()});
        camera.intrinsics = intrinsicsOf(neededNumbers(reading, one, "cam_K", 9), PixelCentres::AtIntegers);
        if (const auto size = sizeOf(numberOf(one, "width"), numberOf(one, "height")))
            camera.size = size;
        camera.files.push_back(of->name);
        if (memberOf(one, "cam_R_w2c")) {
            const auto rotation = matrixByRows(neededNumbers(reading, one, "cam_R_w2c", 9));
            camera.pose = rigid(glm::dmat3(*rotation), neededVector(reading, one, "cam_t_w2c"));
            camera.assumed.push_back(tr("Lengths are in millimetres, as BOP writes cam_t_w2c."));
        }
    }
    sayWholeCentres(reading);
    return std::move(camera);
}

// Source: nuscenes-devkit, docs/schema_nuscenes.md
bool readNuScenes(Reading &reading)
{
    const Json file = documentWith(reading.text, {"sensor_token", "camera_intrinsic", "translation", "rotation"});
    std::vector<const Json *> records;
    std::vector<std::string> sensors;
    ForeignCamera &camera = reading.camera;
    for (const Json *record : elementsOf(file)) {
        if (numbersOf(*record, "camera_intrinsic").size() != 9) // of a lidar or radar it is empty
            continue;
        records.push_back(record);
        camera.images.push_back(wordOf(*record, "token"));
        sensors.push_back(wordOf(*record, "sensor_token"));
    }
    if (records.empty())
        return false;
    reading.begin("nuScenes", PoseDirection::CameraToWorld, EyeAxes::RightDownAhead);
    reading.chooseImage(sensors);
    const Json &one = *records[camera.image];
    camera.intrinsics = intrinsicsOf(numbersOf(one, "camera_intrinsic"), PixelCentres::AtIntegers);
    const std::vector<double> q = neededNumbers(reading, one, "rotation", 4);
    const std::size_t line = lineOfMember(reading.text.text, one, "rotation");
    camera.pose =
        rigid(neededRotation(reading, line, q[0], q[1], q[2], q[3]), neededVector(reading, one, "translation"));
    camera.assumed.push_back(tr("The world is the vehicle's frame, in metres; ego_pose is not applied."));
    sayWholeCentres(reading);
    return true;
}

// Source: polyform, README.md: t_ij by rows, ARKit's axes
bool readPolycam(Reading &reading)
{
    const Json file = documentWith(reading.text, {"t_00", "t_23", "fx"});
    if (!file.is_object() || !memberOf(file, "t_00"))
        return false;
    ForeignCamera &camera = reading.camera;
    beginArKit(reading, "Polycam");
    const auto number = [&](const char *key) { return neededNumber(reading, file, key); };
    std::array<double, 12> pose{};
    for (std::size_t i = 0; i < pose.size(); ++i)
        pose[i] = number(("t_" + std::to_string(i / 4) + std::to_string(i % 4)).c_str());
    camera.pose = matrixByRows(pose);
    camera.size = sizeOf(numberOf(file, "width"), numberOf(file, "height"));
    camera.intrinsics = Intrinsics{number("fx"), number("fy"), number("cx"), number("cy"), 0.0, PixelCentres::AtHalves};
    return true;
}

// A frame of 3D Scanner App. Its programs on GitHub reshape both matrices by rows.
bool readArKit(Reading &reading)
{
    const Json file = documentWith(reading.text, {"cameraPoseARFrame", "intrinsics"});
    if (!file.is_object())
        return false;
    beginArKit(reading, "ARKit");
    reading.camera.pose = matrixByRows(neededNumbers(reading, file, "cameraPoseARFrame", 16));
    reading.camera.intrinsics = intrinsicsOf(neededNumbers(reading, file, "intrinsics", 9), PixelCentres::AtHalves);
    return true;
}

// Source: record3d, issues 27, 33 and 36: qx qy qz qw x y z, camera to world, OpenGL's axes; K by columns
bool readRecord3d(Reading &reading)
{
    const Json file = strictDocumentWith(reading.text, {"poses", "K", "w", "h"});
    const Json &poses = inside(file, {"poses"});
    if (!poses.is_array() || poses.empty() || poses[0].size() != 7)
        return false;
    ForeignCamera &camera = reading.camera;
    beginArKit(reading, "Record3D");
    for (std::size_t i = 0; i < poses.size(); ++i)
        camera.images.push_back(std::to_string(i));
    reading.chooseImage();
    base::Error place;
    base::setPlace(place, reading.text.text, {{"poses"}, {{}, camera.image}});
    const std::vector<double> p = numbersOf(Json{{"poses", poses[camera.image]}}, "poses");
    if (p.size() != 7)
        reading.fail(tr("%1 needs %2 numbers; it has %3", "poses", 7, p.size()), std::size_t(place.line));
    camera.pose = rigid(neededRotation(reading, std::size_t(place.line), p[3], p[0], p[1], p[2]), {p[4], p[5], p[6]});
    camera.size = sizeOf(numberOf(file, "w"), numberOf(file, "h"));
    camera.intrinsics = intrinsicsOf(neededNumbers(reading, file, "K", 9), PixelCentres::AtHalves);
    const std::vector<double> own = numbersOf(file, "perFrameIntrinsicCoeffs"); // fx fy cx cy
    if (own.size() == 4 * poses.size()) {
        const double *k = own.data() + 4 * camera.image;
        camera.intrinsics = Intrinsics{k[0], k[1], k[2], k[3], 0.0, PixelCentres::AtHalves};
    }
    return true;
}

namespace {

struct ThreeCamera {
    const Json *object;
    glm::dmat4 worldFromCamera;
};

/// Adds the cameras of an object and its children, each with its matrices up the parents.
void addThreeCameras(const Json &object, const glm::dmat4 &worldFromParent, std::vector<ThreeCamera> &found)
{
    const auto own = matrixByColumns(numbersOf(object, "matrix"));
    const glm::dmat4 world = own ? worldFromParent * *own : worldFromParent;
    if (const std::string type = wordOf(object, "type"); type == "PerspectiveCamera" || type == "OrthographicCamera")
        found.push_back({&object, world});
    if (const Json &children = inside(object, {"children"}); children.is_array()) {
        for (const Json &child : children)
            addThreeCameras(child, world, found);
    }
}

} // namespace

// Source: three.js, Object3D.toJSON, cameras/PerspectiveCamera.js and OrthographicCamera.js; its editor's
// files have the scene and the camera apart.
bool readThree(Reading &reading)
{
    const bool isFlat = reading.text.text.find("\"OrthographicCamera\"") != std::string::npos;
    const Json file =
        documentWith(reading.text, {"type", "matrix", isFlat ? "OrthographicCamera" : "PerspectiveCamera"});
    std::vector<ThreeCamera> found;
    for (const Json *root :
         {&file, &inside(file, {"object"}), &inside(file, {"scene", "object"}), &inside(file, {"camera", "object"})})
        addThreeCameras(*root, glm::dmat4(1.0), found);
    if (found.empty())
        return false;
    ForeignCamera &camera = reading.camera;
    reading.begin("three.js", PoseDirection::CameraToWorld, EyeAxes::RightUpBack);
    std::vector<std::string> ids;
    for (const ThreeCamera &one : found) {
        ids.push_back(wordOf(*one.object, "uuid"));
        camera.images.push_back(memberOf(*one.object, "name") ? wordOf(*one.object, "name") : ids.back());
    }
    reading.chooseImage(ids);
    const Json &object = *found[camera.image].object;
    const auto number = [&](const char *key) { return neededNumber(reading, object, key); };
    neededNumbers(reading, object, "matrix", 16);
    camera.pose = found[camera.image].worldFromCamera;
    if (numberOf(object, "filmOffset").value_or(0.0) != 0.0 || inside(object, {"view", "enabled"}) == true)
        reading.fail(tr("a camera with filmOffset or setViewOffset is not read; give its projectionMatrix and "
                        "matrixWorldInverse"));
    const double zoom = numberOf(object, "zoom").value_or(1.0);
    if (wordOf(object, "type") == "PerspectiveCamera") {
        camera.nearDistance = numberOf(object, "near");
        camera.farDistance = numberOf(object, "far");
        reading.setVerticalAngle(2.0 * std::atan(std::tan(radiansFromDegrees(number("fov")) / 2.0) / zoom),
                                 numberOf(object, "aspect"));
        return true;
    }
    const double l = number("left"), r = number("right"), b = number("bottom"), t = number("top");
    const double x = (l + r) / 2.0, y = (b + t) / 2.0, dx = (r - l) / (2.0 * zoom), dy = (t - b) / (2.0 * zoom);
    reading.setProjection(Ortho{x - dx, x + dx, y - dy, y + dy, number("near"), number("far")}, 0);
    return true;
}

} // namespace unprojector::cameras
