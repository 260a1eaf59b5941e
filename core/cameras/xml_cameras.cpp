#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/camera_matrices.h"
#include "core/cameras/camera_reader.h"
#include "core/geometry/numbers.h"

#include <nlohmann/json.hpp>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

// XML of other programs.

namespace unprojector::cameras {
using namespace geometry;
using base::tr;
using enum PoseDirection;
using enum EyeAxes;
using enum PixelCentres;
using base::Json;
using glm::dmat3, glm::dmat4, glm::dvec3;

namespace {

/// Fails for an element that has another word than the only one that is read.
void refuseOther(const Node &element, std::string_view keys, std::string_view only)
{
    for (const std::string_view key : split(keys, ' ')) {
        const std::string word = element.word(key);
        const auto number = element.number(key), read = base::doubleFromWord(only);
        if (!word.empty() && word != only && !(read && number == read))
            element.fail(tr("%1 %2 is not read", key, word));
    }
}

/// Fails for a distortion other than 0, unless the user says that the image is undistorted.
void refuseDistortion(const Reading &reading, const Node &lens, std::string_view keys, const std::string &name)
{
    for (const std::string_view key : split(keys, ' ')) {
        const Numbers numbers = lens.numbers(key);
        if (!areZero(numbers) && !reading.choices.isUndistorted)
            reading.fail(
                tr("the distortion of %1 is not read. Undistort the images first, then give --undistorted", name));
    }
}

// Source: nerfstudio, metashape_utils.py, for the transforms: from the camera to the chunk, and the chunk's
// or its component's, s R x + t.
Cameras metashapeCameras(Reading &reading, const Node &file)
{
    const Node chunk = file["document/chunk"], cameras = chunk["cameras"];
    if (!chunk)
        return {};
    auto sensors = chunk.index("sensors/sensor", "id"), components = chunk.index("components/component", "id");
    Cameras posed;
    std::vector<Node> groups = cameras.list("group");
    groups.insert(groups.begin(), cameras);
    for (const Node &group : groups) {
        for (const Node &one : group.list("camera")) {
            if (!one.word("transform").empty())
                posed.push_back({one.word("label"), one.word("id"), one, sensors[one.word("sensor_id")],
                                 components[one.word("component_id")]});
        }
    }
    if (posed.empty())
        reading.fail(tr("no camera has a transform: give the cameras of aligned photographs"));
    return posed;
}

/// Source: Metashape's user manual, Camera models: u = w/2 + cx + x' (f + B1) + y' B2, v = h/2 + cy + y' f;
/// P1 goes with r^2 + 2x^2, which is OpenCV's p2 (nerfstudio, issue 3714).
void readMetashape(Reading &reading)
{
    ForeignCamera &camera = reading.camera;
    auto calibrations = reading.lens.index("calibration", "class");
    const Node &sensor = reading.lens, adjusted = calibrations["adjusted"],
               lens = adjusted ? adjusted : sensor["calibration"];
    const auto of = [&lens](const char *key) { return lens.number(key, 0.0); };
    const std::string type = (lens ? lens : sensor).word("type"); // a sphere has no calibration
    if (of("k4") != 0.0 || of("p3") != 0.0 || of("p4") != 0.0)
        setDistortion(reading, type + " (k4, p3, p4)", {});
    else if (type != "frame" && !type.empty())
        setDistortion(reading, type, {});
    else
        setDistortion(reading, type, std::vector{of("k1"), of("k2"), of("k3"), of("p2"), of("p1")});
    if (!lens)
        failWithoutLens(reading);
    reading.setSize(lens["resolution"] ? lens : sensor, "resolution/width resolution/height");
    const ImageSize size = camera.size ? *camera.size : reading.neededSize();
    const double f = lens.needed("f");
    camera.intrinsics = Intrinsics{
        f + of("b1"), f, size.width / 2.0 + of("cx"), size.height / 2.0 + of("cy"), of("b2"), AtHalves, true};
    const Node placed = reading.own["transform"] ? reading.own["transform"] : reading.file["document/chunk/transform"];
    if (!placed)
        return;
    const dmat3 turn(*matrixByRows(placed.needed("rotation", 9)));
    const dvec3 centre = placed.number("scale", 1.0) * (turn * dvec3((*camera.pose)[3]));
    camera.pose = rigid(turn * dmat3(*camera.pose), centre + placed.vector("translation"));
    reading.say(tr("The chunk's transform is applied. Where it has a geographic reference, the world is geocentric; "
                   "objects exported in other coordinates do not fit."));
}

void readMeshLab(Reading &reading)
{
    const Node &one = reading.lens;
    refuseOther(one, "BinaryData CameraType", "0"); // base64; orthographic and others
    refuseDistortion(reading, one, "LensDistortion", "MeshLab");
    const Numbers viewport = one.needed("ViewportPx", 2), centre = one.needed("CenterPx", 2),
                  pixel = one.needed("PixelSizeMm", 2), t = one.needed("TranslationVector", 4);
    const double focal = one.needed("FocalMm");
    reading.camera.size = sizeOf(viewport[0], viewport[1]);
    reading.camera.intrinsics =
        Intrinsics{focal / pixel[0], focal / pixel[1], centre[0], viewport[1] - centre[1], 0.0, AtHalves, true};
    reading.camera.center = -vectorOf(t);
}

void readRealityCapture(Reading &reading)
{
    const Node &one = reading.lens;
    refuseOther(one, "Skew", "0");
    refuseOther(one, "AspectRatio", "1");
    refuseDistortion(reading, one, "DistortionCoeficients", "RealityCapture (" + one.word("DistortionModel") + ')');
    const double focal = one.needed("FocalLength35mm");
    const ImageSize size = reading.neededSize();
    const double side = std::max(size.width, size.height), f = focal / 36.0 * side;
    reading.setCentred(size, f, f, side * one.number("PrincipalPointU", 0.0),
                       side * one.number("PrincipalPointV", 0.0));
}

/// The pose of an SDF element in the one around it: x y z, then roll, pitch and yaw about fixed axes.
dmat4 sdfPose(const Node &element)
{
    const Node pose = element["pose"];
    refuseOther(pose, "relative_to frame", "");
    refuseOther(pose, "rotation_format", "euler_rpy");
    const Numbers p = element.needed("pose", 6);
    const double unit = pose.isTrue("degrees") ? kRadiansPerDegree : 1.0;
    return rigid(about(2, unit * p[5]) * about(1, unit * p[4]) * about(0, unit * p[3]), vectorOf(p));
}

// Source: SDFormat, camera.sdf and pose.sdf, in metres and radians; gz-math, Quaternion::SetFromEuler; sensors
// look along x, with z up.
void readGazebo(Reading &reading)
{
    ForeignCamera &camera = reading.camera;
    const Node &one = reading.lens;
    const Trail &trail = reading.around;
    if (const std::string type = one.word("lens/type"); !type.empty() && type != "gnomonical")
        setDistortion(reading, type, {});
    refuseDistortion(reading, one["distortion"], "k1 k2 k3 p1 p2", "Gazebo");
    for (const Node &step : trail) {
        if (!step.word("pose").empty())
            camera.pose = camera.pose.value_or(dmat4(1.0)) * sdfPose(step);
    }
    if (camera.pose && trail.front().tag() != "sdf" && trail.front().tag() != "world")
        reading.say(tr("The pose is that of this part of a file, without what stands around it."));
    if (!(camera.nearDistance > 0.0 && camera.farDistance > camera.nearDistance))
        camera.nearDistance = camera.farDistance = {};
    reading.setHorizontalAngle(one.needed("horizontal_fov"));
    const Node k = one["lens/intrinsics"];
    if (!k)
        return;
    reading.setLens(k, "fx fy cx cy", AtHalves);
    camera.intrinsics->skew = k.number("s", 0.0);
    reading.say(tr("Pixel centres are assumed at halves; --pixel-centers integer says otherwise."));
}

/// The place of an MJCF element in the one around it.
/// Source: MuJoCo, user_objects.cc, ResolveOrientation; user_util.cc, mjuu_z2quat
dmat4 mjcfPose(const Node &element, const Node &compiler)
{
    const auto numbers = [&](const char *key, std::size_t count) {
        return element.has(key) ? element.needed(key, count) : Numbers();
    };
    const double unit = compiler.word("angle") == "radian" ? 1.0 : kRadiansPerDegree;
    const std::string given = compiler.word("eulerseq"), order = given.empty() ? "xyz" : given;
    dmat3 turn(1.0);
    if (const auto q = numbers("quat", 4); !q.empty())
        turn = rotationOf(q[0], q[1], q[2], q[3]).value_or(turn);
    if (const auto a = numbers("axisangle", 4); !a.empty())
        turn = rotationOf(unit * a[3] * glm::normalize(vectorOf(a)));
    const auto euler = numbers("euler", 3);
    for (std::size_t i = 0; i < euler.size() && i < order.size(); ++i) {
        const bool isFixed = order[i] < 'a'; // an upper-case letter
        const dmat3 step = about(std::clamp((order[i] | 0x20) - 'x', 0, 2), unit * euler[i]);
        turn = isFixed ? step * turn : turn * step;
    }
    if (const auto a = numbers("xyaxes", 6); !a.empty()) {
        const dvec3 x = glm::normalize(vectorOf(a)), z = glm::normalize(glm::cross(x, vectorOf(a, 3)));
        turn = dmat3(x, glm::cross(z, x), z);
    }
    if (const auto a = numbers("zaxis", 3); !a.empty()) { // the smallest rotation that takes z there
        const dvec3 z = glm::normalize(vectorOf(a)), axis(-z.y, z.x, 0.0);
        const double sine = glm::length(axis);
        turn = rotationOf(std::atan2(sine, z.z) * (sine < 1e-10 ? dvec3(1.0, 0.0, 0.0) : axis / sine));
    }
    const auto p = numbers("pos", 3);
    return rigid(turn, p.empty() ? dvec3(0.0) : vectorOf(p));
}

// Source: MuJoCo's XML reference, body/camera, compiler, visual/map, statistic: a camera looks along -z, with y up.
void readMjcf(Reading &reading)
{
    ForeignCamera &camera = reading.camera;
    const Trail &trail = reading.around;
    const Node model = reading.file["mujoco"], defaults = model["default/camera"], compiler = model["compiler"];
    Json whole = defaults.json().is_object() ? defaults.json() : Json::object();
    whole.update(trail.back().json());
    const Node one(reading, whole);
    if (const std::string mode = one.word("mode"); mode.starts_with("targetbody"))
        reading.fail(tr("%1 %2 is not read", "mode", mode));
    camera.pose = dmat4(1.0);
    bool isOnBody = trail.front().tag() == "camera", hasClass = false;
    for (const Node &step : trail) {
        const bool isLast = &step == &trail.back();
        if (isLast || step.tag() == "body" || step.tag() == "frame")
            camera.pose = *camera.pose * mjcfPose(isLast ? one : step, compiler);
        isOnBody = isOnBody || step.tag() == "body";
        hasClass = hasClass || step.has(isLast ? "class" : "childclass");
    }
    if (isOnBody)
        reading.say(tr("The camera may be on a body: its pose is that with all joints at 0. cam_xpos and cam_xmat tell "
                       "another."));
    if (hasClass)
        reading.say(tr("Defaults of classes are not read; cam_fovy, cam_xpos and cam_xmat have them."));
    refuseOther(one, "sensorsize", "");
    refuseOther(one, "orthographic", "false");
    refuseOther(one, "projection", "perspective");
    if (const Numbers sides = one.numbers("resolution"); sides.size() == 2)
        camera.size = sizeOf(sides[0], sides[1]);
    // The planes are given as shares of the model's extent.
    if (const double extent = model.number("statistic/extent", 0.0); extent > 0.0) {
        camera.nearDistance = extent * model.number("visual/map/znear", 0.01);
        camera.farDistance = extent * model.number("visual/map/zfar", 50.0);
    }
    if (!one.has("fovy"))
        reading.say(tr("fovy is 45 degrees, MuJoCo's default."));
    reading.setDegrees(one.has("fovy") ? one.needed("fovy") : 45.0);
}

/// The cameras of a model; those of its defaults are none.
Cameras mjcfCameras(Reading &reading, const Node &text)
{
    Cameras cameras = listed({.list = "camera", .name = "name"}, Format::Xml, text);
    std::erase_if(cameras, [](const Found &one) {
        return std::any_of(one.around.begin(), one.around.end(),
                           [](const Node &step) { return step.tag() == "default"; });
    });
    if (cameras.empty())
        reading.fail(tr("there are no cameras"));
    return cameras;
}

/// The value of a property of a Mitsuba object: fov_axis, or fovAxis as before version 2. A value "$x" is
/// that of the scene's default x.
std::string propertyOf(const Node &file, const Node &object, const char *name)
{
    for (const char *tag : {"float", "integer", "string"}) {
        for (const Node &property : object.list(tag)) {
            if (plain(property.word("name")) != plain(name))
                continue;
            const std::string value = property.word("value");
            return value.starts_with('$') ? file.index("scene/default", "name")[value.substr(1)].word("value") : value;
        }
    }
    return {};
}

/// "value" of three numbers or of one for all, or x, y and z.
dvec3 mitsubaVector(const Node &element, double otherwise)
{
    const Numbers v = element.numbers("value");
    if (v.size() == 3)
        return vectorOf(v);
    if (v.size() == 1)
        return dvec3(v[0]);
    return {element.number("x", otherwise), element.number("y", otherwise), element.number("z", otherwise)};
}

/// A step of a transform: "translate", "rotate" about an axis, or "scale".
dmat4 stepOf(std::string_view tag, const dvec3 &vector, double degrees)
{
    if (tag == "rotate")
        return dmat4(rotationOf(radiansFromDegrees(degrees) * glm::normalize(vector)));
    return tag == "scale" ? glm::scale(dmat4(1.0), vector) : glm::translate(dmat4(1.0), vector);
}

/// Source: Mitsuba 3, core/transform.h: look_at has the columns left, up, ahead
dmat4 mitsubaStep(Reading &reading, const Node &step)
{
    const std::string tag = step.tag();
    if (tag == "matrix")
        return *matrixByRows(step.needed("value", step.numbers("value").size() == 9 ? 9 : 16));
    if (tag != "lookat" && tag != "look_at")
        return stepOf(tag, mitsubaVector(step, tag == "scale" ? 1.0 : 0.0),
                      tag == "rotate" ? step.needed("angle") : 0.0);
    const dvec3 origin = step.vector("origin");
    reading.setLooking(origin, origin - step.vector("target"), step.vector("up"));
    dmat4 m = *reading.camera.pose;
    m[0] = -m[0];
    m[2] = -m[2];
    return m;
}

/// The elements inside one that have any of these tags, in the text's order.
Trail inOrder(const Node &element, std::string_view tags)
{
    Trail steps;
    for (const std::string_view tag : split(tags, ' ')) {
        for (const Node &step : element.list(tag))
            steps.push_back(step);
    }
    std::sort(steps.begin(), steps.end(), [](const Node &a, const Node &b) { return a.number("@") < b.number("@"); });
    return steps;
}

/// The steps of a transform, one after the other, with the columns right, up, back.
dmat4 mitsubaPose(Reading &reading, const Node &transform)
{
    dmat4 pose(1.0);
    for (const Node &step : inOrder(transform, "lookat look_at matrix translate rotate scale"))
        pose = mitsubaStep(reading, step) * pose;
    pose[0] = -pose[0];
    pose[2] = -pose[2];
    return pose;
}

// Source: Mitsuba 3, sensors/perspective.cpp (x left, y up, z ahead) and render/sensor.cpp, parse_fov.
void readMitsuba(Reading &reading)
{
    ForeignCamera &camera = reading.camera;
    const Node &one = reading.lens, film = one["film"];
    if (const std::string type = one.word("type"); type != "perspective" && type != "thinlens")
        reading.fail(tr("%1 %2 is not read", "sensor", type));
    const auto property = [&](const Node &object, const char *name) { return propertyOf(reading.file, object, name); };
    const auto number = [&](const Node &object, const char *name) {
        return base::doubleFromWord(property(object, name));
    };
    if (const std::string crop = property(film, "crop_width"); !crop.empty())
        reading.fail(tr("%1 %2 is not read", "crop_width", crop));
    camera.size = sizeOf(number(film, "width"), number(film, "height"));
    camera.nearDistance = number(one, "near_clip");
    camera.farDistance = number(one, "far_clip");
    camera.pose = mitsubaPose(reading, one["transform"]);
    const ImageSize size = reading.neededSize();
    const double aspect = double(size.width) / size.height;
    std::string axis = property(one, "fov_axis");
    double half = radiansFromDegrees(number(one, "fov").value_or(0.0)) / 2.0;
    if (half == 0.0) { // a focal length, with the diagonal of 35 mm film
        std::string focal = property(one, "focal_length");
        if (focal.ends_with("mm"))
            focal.resize(focal.size() - 2);
        const auto length = base::doubleFromWord(focal);
        if (!length)
            reading.fail(tr("%1 is missing", "fov"));
        half = std::atan(std::hypot(36.0, 24.0) / (2.0 * *length));
        axis = "diagonal";
    }
    if (axis == "diagonal")
        half = std::atan(std::tan(half) / std::hypot(1.0, 1.0 / aspect));
    if (axis == "y" || (axis == "smaller" && aspect > 1.0) || (axis == "larger" && aspect <= 1.0))
        reading.setVerticalAngle(2.0 * half);
    else
        reading.setHorizontalAngle(2.0 * half);
    camera.intrinsics->cx -= size.width * number(one, "principal_point_offset_x").value_or(0.0);
    camera.intrinsics->cy -= size.height * number(one, "principal_point_offset_y").value_or(0.0);
}

/// The cameras of nodes. The names and ids of the lens and of the nodes around it choose one, too.
Cameras colladaCameras(Reading &reading, const Node &text)
{
    auto lenses = text.index("COLLADA/library_cameras/camera", "id");
    const std::string &choice = reading.choices.image;
    Cameras cameras = listed({.list = "instance_camera", .name = "name|id"}, Format::Xml, text);
    for (Found &one : cameras) {
        const std::string url = one.lens.word("url");
        one.pose = {};
        one.lens = lenses[url.starts_with('#') ? url.substr(1) : url];
        one.around.push_back(one.lens);
        for (const Node &part : one.around) {
            if (part.word("name") == choice || part.word("id") == choice)
                one.id = choice;
        }
    }
    return cameras;
}

/// A step of a node's transform.
dmat4 colladaStep(Reading &reading, const Node &step)
{
    const std::string tag = step.tag();
    const Numbers n = step.needed("", tag == "matrix" ? 16 : tag == "lookat" ? 9 : tag == "rotate" ? 4 : 3);
    if (tag == "matrix")
        return *matrixByRows(n);
    if (tag == "lookat") {
        reading.setLooking(vectorOf(n), vectorOf(n) - vectorOf(n, 3), vectorOf(n, 6));
        return *reading.camera.pose;
    }
    return stepOf(tag, vectorOf(n), n.back());
}

void readCollada(Reading &reading)
{
    dmat4 pose(1.0);
    for (const Node &node : reading.around) {
        if (node.tag() == "library_nodes")
            reading.fail(tr("the camera %1 is in library_nodes, which other nodes place; give a scene with the camera "
                            "in its own node",
                            reading.name));
        refuseOther(node, "skew", "");
        for (const Node &step : inOrder(node, "lookat matrix rotate scale translate"))
            pose = pose * colladaStep(reading, step);
    }
    reading.camera.pose = pose;
    const Node optics = reading.lens["optics/technique_common"], one = optics["perspective"],
               asset = reading.file["COLLADA/asset"];
    if (!one)
        reading.lens.fail(tr("an orthographic camera of %1 is not read; give its matrices", "COLLADA"));
    refuseOther(reading.lens["extra/technique"], "shiftx shifty", "0"); // Blender's
    reading.setPlanes(one, "znear zfar");
    const ImageSize size = reading.neededSize();
    const double shape = double(size.width) / size.height;
    const auto half = [&](const char *key) { return std::tan(radiansFromDegrees(one.needed(key)) / 2.0); };
    const bool hasY = one.has("yfov");
    double aspect = hasY && one.has("xfov") ? half("xfov") / half("yfov") : one.number("aspect_ratio", shape);
    if (std::abs(aspect / shape - 1.0) < 1e-3) // it has few digits
        aspect = shape;
    reading.setVerticalAngle(2.0 * std::atan(hasY ? half("yfov") : half("xfov") / aspect), aspect);
    const std::string up = asset.word("up_axis"), unit = asset["unit"].word("meter");
    reading.say(tr("Coordinates are the file's own, %1 with units of %2 m. Programs that turn or scale it have others.",
                   up.empty() ? "Y_UP" : up, unit.empty() ? "1" : unit));
}

constexpr Form kForms[]{
    {"Metashape", "<chunk <sensor", {CameraToWorld}, metashapeCameras, readMetashape, {.pose = "transform"}},
    // Source: vcglib, wrap/qt/shot_qt.h (the translation is negated) and vcg/math/shot.h, camera.h: rows of the
    // rotation are the camera's axes, and pixels count from the lower left corner.
    {"MeshLab",
     "<VCGCamera",
     {WorldToCamera, RightUpBack},
     nullptr,
     readMeshLab,
     {.list = "VCGCamera", .name = "label", .pose = "RotationMatrix"}},
    // Source: RealityCapture Support, XMP Camera Math: R by rows, from world to camera, and the position; lengths
    // in shares of the image's larger side, of which 35 mm film has 36 mm. What the coefficients count in is open.
    {"RealityCapture",
     "FocalLength35mm capturingreality",
     {},
     nullptr,
     readRealityCapture,
     {.list = "Description", .having = "FocalLength35mm", .pose = "Rotation", .count = 9, .centre = "Position"}},
    {"Gazebo",
     "<camera <horizontal_fov",
     {CameraToWorld, AheadLeftUp},
     nullptr,
     readGazebo,
     {.list = "camera",
      .name = "name",
      .having = "horizontal_fov",
      .size = "image/width image/height",
      .planes = "clip/near clip/far"}},
    {"MuJoCo", "<mujoco", kOpenGl, mjcfCameras, readMjcf, {.list = "camera", .name = "name"}},
    {"MuJoCo",
     "<camera",
     kOpenGl,
     nullptr,
     readMjcf,
     {.list = "camera", .name = "name", .having = "pos|quat|euler|xyaxes|zaxis|axisangle|fovy"}},
    {"Mitsuba", "<sensor <film", kOpenGl, nullptr, readMitsuba, {.list = "sensor", .name = "id"}},
    // Source: COLLADA 1.5.0, camera, perspective (degrees) and node: steps apply to column vectors, the last one
    // first; numbers by rows; a camera looks along -z, with y up.
    {"COLLADA", "<COLLADA <instance_camera", kOpenGl, colladaCameras, readCollada}};

} // namespace

std::span<const Form> xmlForms()
{
    return kForms;
}

} // namespace unprojector::cameras
