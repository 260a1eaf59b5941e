#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/camera_matrices.h"
#include "core/cameras/camera_reader.h"
#include "core/cameras/xml.h"
#include "core/geometry/numbers.h"

#include <nlohmann/json.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

// XML of other programs, one function a program.

namespace unprojector::cameras {
using namespace geometry;
using base::tr;
using Json = nlohmann::ordered_json;

namespace {

/// Chooses one of the elements; its name is the attribute of the element or of the nearest around it.
const XmlPath &chosen(Reading &reading, const std::vector<XmlPath> &paths, const char *name)
{
    for (const XmlPath &path : paths) {
        const auto named = std::find_if(path.rbegin(), path.rend(),
                                        [&](const XmlStep &step) { return memberOf(*step.element, name) != nullptr; });
        reading.camera.images.push_back(named == path.rend() ? std::to_string(reading.camera.images.size())
                                                             : xmlText(*named->element, name));
    }
    if (paths.empty())
        reading.fail(tr("there are no cameras"));
    reading.chooseImage();
    return paths[reading.camera.image];
}

bool anyIsNot0(const std::vector<double> &numbers)
{
    return std::any_of(numbers.begin(), numbers.end(), [](double number) { return number != 0.0; });
}

/// Fails for a distortion, unless the user says that the image is undistorted.
void refuseDistortion(Reading &reading, const std::string &name)
{
    if (!reading.choices.isUndistorted)
        reading.fail(tr("the distortion of %1 is not read. Undistort the images first, then give --undistorted", name));
}

double neededXmlNumber(const Reading &reading, const Json &element, const char *key)
{
    return neededXml(reading, element, key, 1)[0];
}

} // namespace

namespace {

/// Source: Metashape's user manual, Camera models: u = w/2 + cx + x' (f + B1) + y' B2, v = h/2 + cy + y' f;
/// P1 goes with r^2 + 2x^2, which is OpenCV's p2 (nerfstudio, issue 3714).
void setMetashapeLens(Reading &reading, const Json &sensor)
{
    ForeignCamera &camera = reading.camera;
    const Json &adjusted = entryOf(children(sensor, "calibration"), "class", "adjusted"),
               &lens = adjusted.is_object() ? adjusted : child(sensor, {"calibration"});
    const auto of = [&lens](const char *key) { return xmlNumber(lens, key, 0.0); };
    const std::string type = xmlText(lens.is_object() ? lens : sensor, "type"); // a sphere has no calibration
    if (anyIsNot0({of("k4"), of("p3"), of("p4")}))
        setDistortion(reading, type + " (k4, p3, p4)", {});
    else if (type != "frame" && !type.empty())
        setDistortion(reading, type, {});
    else
        setDistortion(reading, type, std::vector{of("k1"), of("k2"), of("k3"), of("p2"), of("p1")});
    if (!lens.is_object())
        reading.fail(tr("%1 has no intrinsics in the file; give a file that has them", camera.images[camera.image]));
    const Json &own = child(lens, {"resolution"}), &resolution = own.is_object() ? own : child(sensor, {"resolution"});
    camera.size = sizeOf(spelledNumber(resolution, "width"), spelledNumber(resolution, "height"));
    const ImageSize size = camera.size ? *camera.size : reading.neededSize();
    const double f = neededXmlNumber(reading, lens, "f");
    camera.intrinsics =
        Intrinsics{f + of("b1"),           f,   size.width / 2.0 + of("cx"), size.height / 2.0 + of("cy"), of("b2"),
                   PixelCentres::AtHalves, true};
}

} // namespace

// Source: nerfstudio, metashape_utils.py, for the transforms: from the camera to the chunk, and the chunk's
// or its component's, s R x + t.
bool readMetashape(Reading &reading)
{
    const Json file = xmlWith(reading.text, {"<chunk", "<sensor"});
    const Json &chunk = child(file, {"document", "chunk"}), &list = child(chunk, {"cameras"});
    if (!chunk.is_object())
        return false;
    ForeignCamera &camera = reading.camera;
    reading.begin("Metashape", PoseDirection::CameraToWorld, EyeAxes::RightDownAhead);
    std::vector<const Json *> groups{&list}, posed;
    for (const Json &group : children(list, "group"))
        groups.push_back(&group);
    std::vector<std::string> ids;
    for (const Json *group : groups) {
        for (const Json &one : children(*group, "camera")) {
            if (xmlText(one, "transform").empty())
                continue;
            posed.push_back(&one);
            camera.images.push_back(xmlText(one, "label"));
            ids.push_back(xmlText(one, "id"));
        }
    }
    if (posed.empty())
        reading.fail(tr("no camera has a transform: give the cameras of aligned photographs"));
    reading.chooseImage(ids);
    const Json &one = *posed[camera.image];
    const auto entry = [&](const char *parts, const char *part, const char *id) -> const Json & {
        return entryOf(children(child(chunk, {parts}), part), "id", xmlText(one, id));
    };
    setMetashapeLens(reading, entry("sensors", "sensor", "sensor_id"));
    camera.pose = matrixByRows(neededXml(reading, one, "transform", 16));
    const Json &own = child(entry("components", "component", "component_id"), {"transform"}),
               &placed = own.is_object() ? own : child(chunk, {"transform"});
    if (placed.is_object()) {
        const glm::dmat3 turn(*matrixByRows(neededXml(reading, placed, "rotation", 9)));
        const glm::dvec3 centre = xmlNumber(placed, "scale", 1.0) * (turn * glm::dvec3((*camera.pose)[3]));
        camera.pose = rigid(turn * glm::dmat3(*camera.pose), centre + neededXmlVector(reading, placed, "translation"));
        camera.assumed.push_back(tr("The chunk's transform is applied. Where it has a geographic reference, the world "
                                    "is geocentric; objects exported in other coordinates do not fit."));
    }
    return true;
}

// Source: vcglib, wrap/qt/shot_qt.h (the translation is negated) and vcg/math/shot.h, camera.h: rows of the
// rotation are the camera's axes, and pixels count from the lower left corner.
bool readMeshLab(Reading &reading)
{
    const Json file = xmlWith(reading.text, {"<VCGCamera"});
    const std::vector<XmlPath> paths = pathsTo(file, "VCGCamera");
    if (paths.empty())
        return false;
    ForeignCamera &camera = reading.camera;
    reading.begin("MeshLab", PoseDirection::WorldToCamera, EyeAxes::RightUpBack);
    const Json &one = *chosen(reading, paths, "label").back().element;
    for (const char *key : {"BinaryData", "CameraType"}) { // base64; orthographic and others
        if (xmlNumber(one, key, 0.0) != 0.0)
            reading.fail(tr("%1 %2 is not read", key, xmlText(one, key)));
    }
    if (anyIsNot0(xmlNumbers(one, "LensDistortion")))
        refuseDistortion(reading, "MeshLab");
    const auto pair = [&](const char *key) { return neededXml(reading, one, key, 2); };
    const std::vector<double> viewport = pair("ViewportPx"), centre = pair("CenterPx"), pixel = pair("PixelSizeMm");
    const double focal = neededXmlNumber(reading, one, "FocalMm");
    camera.size = sizeOf(viewport[0], viewport[1]);
    camera.intrinsics = Intrinsics{
        focal / pixel[0], focal / pixel[1], centre[0], viewport[1] - centre[1], 0.0, PixelCentres::AtHalves, true};
    const std::vector<double> t = neededXml(reading, one, "TranslationVector", 4);
    camera.pose = matrixByRows(neededXml(reading, one, "RotationMatrix", 16));
    camera.center = -glm::dvec3(t[0], t[1], t[2]);
    return true;
}

// Source: RealityCapture Support, XMP Camera Math: R by rows, from world to camera, and the position; lengths
// in shares of the image's larger side, of which 35 mm film has 36 mm. What the coefficients count in is open.
bool readRealityCapture(Reading &reading)
{
    const Json file = xmlWith(reading.text, {"FocalLength35mm", "capturingreality"});
    const std::vector<XmlPath> paths = pathsTo(file, "Description");
    if (paths.empty())
        return false;
    ForeignCamera &camera = reading.camera;
    reading.begin("RealityCapture", PoseDirection::WorldToCamera, EyeAxes::RightDownAhead);
    const Json &one = *paths.front().back().element;
    for (const auto &[key, only] : {std::pair("Skew", 0.0), std::pair("AspectRatio", 1.0)}) {
        if (xmlNumber(one, key, only) != only)
            reading.fail(tr("%1 %2 is not read", key, xmlText(one, key)));
    }
    if (anyIsNot0(xmlNumbers(one, "DistortionCoeficients")))
        refuseDistortion(reading, "RealityCapture (" + xmlText(one, "DistortionModel") + ')');
    const double focal = neededXmlNumber(reading, one, "FocalLength35mm");
    camera.pose = matrixByRows(neededXml(reading, one, "Rotation", 9));
    camera.center = neededXmlVector(reading, one, "Position");
    const ImageSize size = reading.neededSize();
    const double side = std::max(size.width, size.height), f = focal / 36.0 * side;
    camera.intrinsics = Intrinsics{f,
                                   f,
                                   size.width / 2.0 + side * xmlNumber(one, "PrincipalPointU", 0.0),
                                   size.height / 2.0 + side * xmlNumber(one, "PrincipalPointV", 0.0),
                                   0.0,
                                   PixelCentres::AtHalves,
                                   true};
    return true;
}

namespace {

/// The pose of an SDF element in the one around it: x y z, then roll, pitch and yaw about fixed axes.
glm::dmat4 sdfPose(const Reading &reading, const Json &element)
{
    const Json &pose = child(element, {"pose"});
    for (const char *key : {"relative_to", "frame", "rotation_format"}) {
        const std::string word = xmlText(pose, key);
        if (!word.empty() && word != "euler_rpy")
            reading.fail(tr("%1 %2 is not read", key, word));
    }
    const std::vector<double> p = neededXml(reading, element, "pose", 6);
    const double unit = xmlText(pose, "degrees") == "true" ? kRadiansPerDegree : 1.0;
    return rigid(about(2, unit * p[5]) * about(1, unit * p[4]) * about(0, unit * p[3]), {p[0], p[1], p[2]});
}

} // namespace

// Source: SDFormat, camera.sdf and pose.sdf, in metres and radians; gz-math, Quaternion::SetFromEuler; sensors
// look along x, with z up.
bool readGazebo(Reading &reading)
{
    const Json file = xmlWith(reading.text, {"<camera", "<horizontal_fov"});
    std::vector<XmlPath> paths = pathsTo(file, "camera");
    std::erase_if(paths, [](const XmlPath &path) { return xmlText(*path.back().element, "horizontal_fov").empty(); });
    if (paths.empty())
        return false;
    ForeignCamera &camera = reading.camera;
    reading.begin("Gazebo", PoseDirection::CameraToWorld, EyeAxes::AheadLeftUp);
    const XmlPath &path = chosen(reading, paths, "name");
    const Json &one = *path.back().element, &image = child(one, {"image"}), &clip = child(one, {"clip"}),
               &lens = child(one, {"lens"}), &k = child(lens, {"intrinsics"}), &distortion = child(one, {"distortion"});
    if (const std::string type = xmlText(lens, "type"); !type.empty() && type != "gnomonical")
        setDistortion(reading, type, {});
    for (const char *key : {"k1", "k2", "k3", "p1", "p2"}) {
        if (xmlNumber(distortion, key, 0.0) != 0.0)
            refuseDistortion(reading, "Gazebo");
    }
    camera.size = sizeOf(xmlNumber(image, "width", 0.0), xmlNumber(image, "height", 0.0));
    for (const XmlStep &step : path) {
        if (!xmlText(*step.element, "pose").empty())
            camera.pose = camera.pose.value_or(glm::dmat4(1.0)) * sdfPose(reading, *step.element);
    }
    if (camera.pose && path.front().tag != "sdf" && path.front().tag != "world")
        camera.assumed.push_back(tr("The pose is that of this part of a file, without what stands around it."));
    if (const double n = xmlNumber(clip, "near", 0.0), f = xmlNumber(clip, "far", 0.0); n > 0.0 && f > n) {
        camera.nearDistance = n;
        camera.farDistance = f;
    }
    reading.setHorizontalAngle(neededXmlNumber(reading, one, "horizontal_fov"));
    if (!k.is_object())
        return true;
    const auto number = [&](const char *key) { return neededXmlNumber(reading, k, key); };
    camera.intrinsics = Intrinsics{number("fx"), number("fy"),           number("cx"),
                                   number("cy"), xmlNumber(k, "s", 0.0), PixelCentres::AtHalves};
    camera.assumed.push_back(tr("Pixel centres are assumed at halves; --pixel-centers integer says otherwise."));
    return true;
}

namespace {

/// The place of an MJCF element in the one around it.
/// Source: MuJoCo, user_objects.cc, ResolveOrientation; user_util.cc, mjuu_z2quat
glm::dmat4 mjcfPose(const Reading &reading, const Json &element, const Json &compiler)
{
    const auto numbers = [&](const char *key, std::size_t count) {
        return memberOf(element, key) ? neededXml(reading, element, key, count) : std::vector<double>();
    };
    const double unit = xmlText(compiler, "angle") == "radian" ? 1.0 : kRadiansPerDegree;
    const std::string given = xmlText(compiler, "eulerseq"), order = given.empty() ? "xyz" : given;
    glm::dmat3 turn(1.0);
    if (const auto q = numbers("quat", 4); !q.empty())
        turn = rotationOf(q[0], q[1], q[2], q[3]).value_or(turn);
    if (const auto a = numbers("axisangle", 4); !a.empty())
        turn = rotationOf(unit * a[3] * glm::normalize(glm::dvec3(a[0], a[1], a[2])));
    const auto euler = numbers("euler", 3);
    for (std::size_t i = 0; i < euler.size() && i < order.size(); ++i) {
        const bool isFixed = order[i] < 'a'; // an upper-case letter
        const glm::dmat3 step = about(std::clamp((order[i] | 0x20) - 'x', 0, 2), unit * euler[i]);
        turn = isFixed ? step * turn : turn * step;
    }
    if (const auto a = numbers("xyaxes", 6); !a.empty()) {
        const glm::dvec3 x = glm::normalize(glm::dvec3(a[0], a[1], a[2])),
                         z = glm::normalize(glm::cross(x, glm::dvec3(a[3], a[4], a[5])));
        turn = glm::dmat3(x, glm::cross(z, x), z);
    }
    if (const auto a = numbers("zaxis", 3); !a.empty()) { // the smallest rotation that takes z there
        const glm::dvec3 z = glm::normalize(glm::dvec3(a[0], a[1], a[2])), axis(-z.y, z.x, 0.0);
        const double sine = glm::length(axis);
        turn = rotationOf(std::atan2(sine, z.z) * (sine < 1e-10 ? glm::dvec3(1.0, 0.0, 0.0) : axis / sine));
    }
    const auto p = numbers("pos", 3);
    return rigid(turn, p.empty() ? glm::dvec3(0.0) : glm::dvec3(p[0], p[1], p[2]));
}

/// Source: MuJoCo's XML reference, body/camera, visual/map, statistic
void setMjcfLens(Reading &reading, const Json &one, const Json &model)
{
    ForeignCamera &camera = reading.camera;
    for (const char *key : {"sensorsize", "orthographic", "projection"}) {
        if (const std::string word = xmlText(one, key); !word.empty() && word != "false" && word != "perspective")
            reading.fail(tr("%1 %2 is not read", key, word));
    }
    if (const std::vector<double> resolution = xmlNumbers(one, "resolution"); resolution.size() == 2)
        camera.size = sizeOf(resolution[0], resolution[1]);
    // The planes are given as shares of the model's extent.
    if (const double extent = xmlNumber(child(model, {"statistic"}), "extent", 0.0); extent > 0.0) {
        const Json &map = child(model, {"visual", "map"});
        camera.nearDistance = extent * xmlNumber(map, "znear", 0.01);
        camera.farDistance = extent * xmlNumber(map, "zfar", 50.0);
    }
    const bool hasAngle = memberOf(one, "fovy") != nullptr;
    if (!hasAngle)
        camera.assumed.push_back(tr("fovy is 45 degrees, MuJoCo's default."));
    reading.setVerticalAngle(radiansFromDegrees(hasAngle ? neededXmlNumber(reading, one, "fovy") : 45.0));
}

} // namespace

// Source: MuJoCo's XML reference, body/camera, compiler: a camera looks along -z, with y up.
bool readMjcf(Reading &reading)
{
    const bool isModel = reading.text.text.find("<mujoco") != std::string::npos;
    const Json file = xmlWith(reading.text, {isModel ? "<mujoco" : "<camera "});
    std::vector<XmlPath> paths = pathsTo(file, "camera");
    std::erase_if(paths, [&](const XmlPath &path) {
        constexpr std::array kOwn{"pos", "quat", "euler", "xyaxes", "zaxis", "axisangle", "fovy"};
        const bool isOther = std::none_of(kOwn.begin(), kOwn.end(),
                                          [&](const char *key) { return !xmlText(*path.back().element, key).empty(); });
        return (isOther && !isModel)
               || std::any_of(path.begin(), path.end(), [](const XmlStep &step) { return step.tag == "default"; });
    });
    if (!file.is_object() || (paths.empty() && !isModel))
        return false;
    ForeignCamera &camera = reading.camera;
    reading.begin("MuJoCo", PoseDirection::CameraToWorld, EyeAxes::RightUpBack);
    const XmlPath &path = chosen(reading, paths, "name");
    const Json &model = child(file, {"mujoco"}), &defaults = child(model, {"default", "camera"}),
               &compiler = child(model, {"compiler"});
    Json one = defaults.is_object() ? defaults : Json::object();
    one.update(*path.back().element);
    if (const std::string mode = xmlText(one, "mode"); mode.starts_with("targetbody"))
        reading.fail(tr("%1 %2 is not read", "mode", mode));
    camera.pose = glm::dmat4(1.0);
    bool isOnBody = path.front().tag == "camera", hasClass = false;
    for (const XmlStep &step : path) {
        const bool isLast = step.element == path.back().element;
        if (isLast || step.tag == "body" || step.tag == "frame")
            camera.pose = *camera.pose * mjcfPose(reading, isLast ? one : *step.element, compiler);
        isOnBody = isOnBody || step.tag == "body";
        hasClass = hasClass || memberOf(*step.element, isLast ? "class" : "childclass");
    }
    if (isOnBody)
        camera.assumed.push_back(tr("The camera may be on a body: its pose is that with all joints at 0. cam_xpos and "
                                    "cam_xmat tell another."));
    if (hasClass)
        camera.assumed.push_back(tr("Defaults of classes are not read; cam_fovy, cam_xpos and cam_xmat have them."));
    setMjcfLens(reading, one, model);
    return true;
}

namespace {

/// The value of a property of a Mitsuba object: fov_axis, or fovAxis as before version 2. A value "$x" is
/// that of the scene's default x.
std::string propertyOf(const Json &file, const Json &object, const std::string &name)
{
    const auto plain = [](std::string word) {
        std::erase(word, '_');
        return base::lowerCase(word);
    };
    for (const char *tag : {"float", "integer", "string"}) {
        for (const Json &property : children(object, tag)) {
            if (plain(xmlText(property, "name")) != plain(name))
                continue;
            const std::string value = xmlText(property, "value");
            return !value.starts_with('$')
                       ? value
                       : xmlText(entryOf(children(child(file, {"scene"}), "default"), "name", value.substr(1)),
                                 "value");
        }
    }
    return {};
}

/// "value" of three numbers or of one for all, or x, y and z.
glm::dvec3 mitsubaVector(const Json &element, double otherwise)
{
    const std::vector<double> v = xmlNumbers(element, "value");
    if (v.size() == 3)
        return {v[0], v[1], v[2]};
    if (v.size() == 1)
        return glm::dvec3(v[0]);
    return {xmlNumber(element, "x", otherwise), xmlNumber(element, "y", otherwise), xmlNumber(element, "z", otherwise)};
}

/// Source: Mitsuba 3, core/transform.h: look_at has the columns left, up, ahead
glm::dmat4 mitsubaStep(const Reading &reading, std::string_view tag, const Json &step)
{
    glm::dmat4 m(1.0);
    if (tag == "lookat" || tag == "look_at") {
        const auto point = [&](const char *key) { return neededXmlVector(reading, step, key); };
        const auto right = looking(point("origin"), point("origin") - point("target"), point("up"));
        if (!right)
            reading.fail(tr("forward and up are parallel or 0; they give no axes"));
        m = *right;
        m[0] = -m[0];
        m[2] = -m[2];
    } else if (tag == "matrix") {
        m = *matrixByRows(neededXml(reading, step, "value", xmlNumbers(step, "value").size() == 9 ? 9 : 16));
    } else if (tag == "translate") {
        m[3] = glm::dvec4(mitsubaVector(step, 0.0), 1.0);
    } else if (tag == "rotate") {
        const double angle = radiansFromDegrees(neededXmlNumber(reading, step, "angle"));
        m = glm::dmat4(rotationOf(angle * glm::normalize(mitsubaVector(step, 0.0))));
    } else { // scale
        const glm::dvec3 factor = mitsubaVector(step, 1.0);
        for (int i = 0; i < 3; ++i)
            m[i] *= factor[i];
    }
    return m;
}

/// The steps of a transform, one after the other, with the columns right, up, back.
glm::dmat4 mitsubaPose(const Reading &reading, const Json &transform)
{
    std::vector<XmlPath> steps;
    for (const char *tag : {"lookat", "look_at", "matrix", "translate", "rotate", "scale"}) {
        for (const XmlPath &path : pathsTo(transform, tag))
            steps.push_back(path);
    }
    std::sort(steps.begin(), steps.end(), [](const XmlPath &a, const XmlPath &b) {
        return inside(*a[0].element, {"@"}) < inside(*b[0].element, {"@"});
    });
    glm::dmat4 pose(1.0);
    for (const XmlPath &step : steps)
        pose = mitsubaStep(reading, step[0].tag, *step[0].element) * pose;
    pose[0] = -pose[0];
    pose[2] = -pose[2];
    return pose;
}

} // namespace

// Source: Mitsuba 3, sensors/perspective.cpp (x left, y up, z ahead) and render/sensor.cpp, parse_fov.
bool readMitsuba(Reading &reading)
{
    const Json file = xmlWith(reading.text, {"<sensor", "<film"});
    const std::vector<XmlPath> paths = pathsTo(file, "sensor");
    if (paths.empty())
        return false;
    ForeignCamera &camera = reading.camera;
    reading.begin("Mitsuba", PoseDirection::CameraToWorld, EyeAxes::RightUpBack);
    const Json &one = *chosen(reading, paths, "id").back().element, &film = child(one, {"film"});
    if (const std::string type = xmlText(one, "type"); type != "perspective" && type != "thinlens")
        reading.fail(tr("%1 %2 is not read", "sensor", type));
    const auto property = [&](const Json &object, const char *name) { return propertyOf(file, object, name); };
    const auto number = [&](const Json &object, const char *name) {
        return base::doubleFromWord(property(object, name));
    };
    if (const std::string crop = property(film, "crop_width"); !crop.empty())
        reading.fail(tr("%1 %2 is not read", "crop_width", crop));
    camera.size = sizeOf(number(film, "width"), number(film, "height"));
    camera.nearDistance = number(one, "near_clip");
    camera.farDistance = number(one, "far_clip");

    camera.pose = mitsubaPose(reading, child(one, {"transform"}));
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
    return true;
}

} // namespace unprojector::cameras
