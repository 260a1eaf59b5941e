#include "core/base/expression.h"
#include "core/base/number_text.h"
#include "core/base/source_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/camera_matrices.h"
#include "core/cameras/camera_reader.h"
#include "core/geometry/numbers.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

// Cameras of scene languages: an eye with a target or a rotation, and an angle.

namespace unprojector::cameras {
using namespace geometry;
using base::tr;
using enum PoseDirection;
using enum EyeAxes;
using base::isListed, base::SourceCall;
using glm::dmat3, glm::dmat4, glm::dvec3;
using std::string_view;

namespace {

[[noreturn]] void failValue(const Node &node, string_view name, string_view value)
{
    node.fail(tr("%1 is %2, and only numbers are read; write them", name, base::quoted(value)), name);
}

/// Fails for a text with one of the words.
void refuseWords(const Reading &reading, string_view text, string_view name, string_view words)
{
    for (const string_view word : split(words, ' ')) {
        if (text.find(word) != text.npos)
            reading.fail(word.find("rtho") == 1
                             ? tr("an orthographic camera of %1 is not read; give its matrices", reading.camera.program)
                             : tr("%1 %2 is not read", name, word));
    }
}

void sayUsual(Reading &reading, string_view name, const Numbers &usual)
{
    std::string text;
    for (const double number : usual)
        text += (text.empty() ? "" : " ") + base::shortestText(number);
    reading.say(tr("%1 is missing: it counts as %2, as in a new camera of %3.", name, text, reading.camera.program));
}

/// The numbers of a name. Fails for variables and what the text computes.
/// @param usual  those of a new camera of the program, which count with a sentence; empty: needed
Numbers numbersOf(Reading &reading, const Node &node, string_view name, std::size_t count, const Numbers &usual = {})
{
    const std::vector<NamedValue> &all = node.values().all();
    const auto isIt = [&](const NamedValue &value) { return value.isNamed(plain(name)); };
    const auto found = std::ranges::find_if(all, isIt);
    if (found == all.end()) {
        if (usual.empty())
            node.fail(tr("%1 is missing", name));
        sayUsual(reading, name, usual);
        return usual;
    }
    string_view value = node.text().substr(found->at + found->written.size());
    value.remove_prefix(std::min(value.find_first_not_of(" =:'\""), value.size()));
    value = value.substr(0, value.find_first_of(",\n", value.find_first_of("0123456789,\n")));
    const string_view call = value.substr(0, value.find('(')), function = call.substr(call.find_last_of(" .") + 1);
    const bool isPlain = call == value || call.empty() || isListed("array asarray radians deg2rad", function);
    if (!isPlain || found->numbers.size() != count || !found->arithmetic.empty()
        || std::ranges::count_if(all, isIt) > 1)
        failValue(node, name, value);
    return found->numbers;
}

/// Sets the lens of an angle: across "x", upright "y", of the "smaller" or "larger" side, or the "diagonal".
void setAngle(Reading &reading, double radians, string_view side)
{
    const ImageSize size = reading.neededSize();
    const double aspect = double(size.width) / size.height;
    if (side == "diagonal")
        radians = 2.0 * std::atan(std::tan(radians / 2.0) / std::hypot(1.0, 1.0 / aspect));
    if (side == "y" || (side == "smaller" && aspect > 1.0) || (side == "larger" && aspect <= 1.0))
        reading.setVerticalAngle(radians);
    else
        reading.setHorizontalAngle(radians);
}

void look(Reading &reading, const Numbers &eye, const Numbers &target, const Numbers &up)
{
    const dvec3 ahead = vectorOf(target) - vectorOf(eye);
    reading.setLooking(vectorOf(eye), reading.camera.axes == RightUpAhead ? ahead : -ahead, vectorOf(up));
}

/// The same for three names.
void lookBy(Reading &reading, string_view eye, string_view target, string_view up, const Numbers &usualUp)
{
    const Node &one = reading.lens;
    look(reading, numbersOf(reading, one, eye, 3), numbersOf(reading, one, target, 3),
         numbersOf(reading, one, up, 3, usualUp));
}

void sayLeftHanded(Reading &reading)
{
    reading.camera.rightHandedFromWorld[2][2] = -1.0;
    reading.say(tr("%1's world is left-handed. The scene has its z negated: the point (x, y, z) of %1 is (x, y, -z) "
                   "here.",
                   reading.camera.program));
}

Node nodeAt(const Reading &reading, string_view part)
{
    return Node(reading, std::make_shared<NamedValues>(part), part);
}

void add(Cameras &cameras, const Reading &reading, string_view part, string_view name = {}, const Node &own = {})
{
    cameras.push_back(
        {name.empty() ? std::to_string(cameras.size()) : std::string(name), {}, {}, nodeAt(reading, part), own});
}

/// The parts "camera {…}" of a text, and "<Viewpoint …>".
Cameras blocks(Reading &reading, const Node &)
{
    constexpr const char *kNames = "camera PerspectiveCamera OrthographicCamera Viewpoint OrthoViewpoint";
    Cameras found;
    const std::string text = base::withoutComments(reading.text.text);
    for (std::size_t at = 0, length = 0; at < text.size(); at += length) {
        const string_view name = base::namesAt(text, at);
        length = std::max<std::size_t>(name.size(), 1);
        if (!isListed(kNames, name))
            continue;
        const std::size_t open = base::behindBlanks(text, at + length);
        const bool isElement = at > 0 && text[at - 1] == '<' && name.ends_with("Viewpoint");
        const std::size_t end = isElement ? text.find('>', at) : base::closingBracket(text, open);
        const bool isBlock = open < text.size() && text[open] == '{' && text.find_first_of(":;", at) >= end;
        if (end != text.npos && (isElement || isBlock))
            add(found, reading, string_view(reading.text.text).substr(at, end - at - (text[end - 1] == '/')));
    }
    return found;
}

/// The calls of add_camera, each with the call that sets the pose of its result.
Cameras addedCameras(Reading &reading, const Node &)
{
    const string_view text = reading.text.text;
    const std::string bare = base::withoutComments(text);
    const std::vector<SourceCall> calls = base::sourceCalls(bare);
    std::map<string_view, string_view> poses;
    for (const SourceCall &call : calls) {
        if (isListed("set_pose set_local_pose", call.name))
            poses[split(call.object, '.')[0]] = text.substr(call.at, call.end - call.at);
    }
    Cameras cameras;
    for (const SourceCall &call : calls) {
        const auto pose = call.variable.empty() ? poses.end() : poses.find(call.variable);
        if (!call.isAssignment && isListed("add_camera add_mounted_camera", call.name))
            add(cameras, reading, text.substr(call.at, call.end - call.at - 1), call.variable,
                pose == poses.end() ? Node() : nodeAt(reading, pose->second));
    }
    return cameras;
}

// Source: Genesis, engine/scene.py, add_camera, and vis/camera.py: fov is upright, in degrees; z is up
void readGenesis(Reading &reading)
{
    const Node &call = reading.lens;
    refuseWords(reading, call.word("model"), "model", "fisheye orthographic");
    if (reading.own || call.has("transform"))
        reading.fail(tr("set_pose or transform moves the camera; write pos and lookat into add_camera instead"));
    lookBy(reading, "pos", "lookat", "up", {0.0, 0.0, 1.0});
    setAngle(reading, radiansFromDegrees(numbersOf(reading, call, "fov", 1, {30.0})[0]), "y");
}

// Source: SAPIEN, wrapper/scene.py (fovy in radians), and its documentation: a Pose has p, then q as w, x, y, z
void readSapienScene(Reading &reading)
{
    const string_view call = (reading.own ? reading.own : reading.lens).text();
    const std::size_t at = call.find("Pose("), end = base::closingBracket(call, std::min(at, call.size() - 4) + 4);
    if (at == call.npos || end == call.npos)
        reading.lens.fail(tr("the camera's pose is missing; give %1", "set_local_pose(Pose(p, q))"));
    const Node pose = nodeAt(reading, call.substr(at, end - at));
    const NamedValue &first = pose.values().all()[0];
    Numbers n = first.numbers;
    if (pose.has("p") && pose.has("q")) {
        n = numbersOf(reading, pose, "p", 3);
        const Numbers q = numbersOf(reading, pose, "q", 4);
        n.insert(n.end(), q.begin(), q.end());
    }
    const auto turn = n.size() == 7 ? rotationOf(n[3], n[4], n[5], n[6]) : std::nullopt;
    if (!turn || !first.arithmetic.empty())
        failValue(pose, "Pose", pose.text().substr(5));
    reading.camera.pose = rigid(*turn, vectorOf(n));
    if (!reading.own)
        sayNoParent(reading, "pose");
    setAngle(reading, numbersOf(reading, reading.lens, "fovy", 1)[0], "y");
}

/// The variables of cameras' blueprints.
Cameras carlaCameras(Reading &reading, const Node &)
{
    Cameras cameras;
    const std::string bare = base::withoutComments(reading.text.text);
    for (const SourceCall &call : base::sourceCalls(bare)) {
        if (call.isAssignment && call.arguments[0].find("sensor.camera.") != bare.npos)
            add(cameras, reading, string_view(reading.text.text).substr(call.at, call.end - call.at), call.written);
    }
    return cameras;
}

// Source: CARLA's documentation, Sensors reference (fov is across, in degrees) and Python API, carla.Rotation (pitch,
// yaw and roll as Unreal's)
void readCarla(Reading &reading)
{
    const string_view text = reading.text.text;
    const std::string bare = base::withoutComments(text);
    const auto unquoted = [](string_view value) { return value.size() < 2 ? "" : value.substr(1, value.size() - 2); };
    std::map<string_view, std::optional<double>> set{{"image_size_x", {}}, {"image_size_y", {}}, {"fov", {}}};
    Node pose;
    std::size_t count = 0;
    for (const SourceCall &call : base::sourceCalls(bare)) {
        if (call.name == "Transform" && ++count > 0)
            pose = nodeAt(reading, text.substr(call.at, call.end - call.at));
        if (call.name != "set_attribute" || call.object != reading.name || call.arguments.size() != 2)
            continue;
        refuseWords(reading, call.arguments[0], "CARLA", "lens_k lens_circle_multiplier");
        const auto found = set.find(unquoted(call.arguments[0]));
        if (found != set.end() && !(found->second = base::doubleFromWord(unquoted(call.arguments[1]))))
            failValue(reading.lens, found->first, call.arguments[1]);
    }
    refuseWords(reading, reading.lens.text(), "sensor.camera", "wide_angle fisheye");
    if (count != 1)
        reading.fail(tr("%1 is there %2 times; give the part of the text that has the camera's", "Transform", count));
    const std::string inside = base::withoutComments(pose.text());
    std::ptrdiff_t unnamed = 1; // arguments, without those that are calls
    for (const SourceCall &call : base::sourceCalls(inside))
        unnamed += call.isAssignment ? -1 : std::ptrdiff_t(call.arguments.size()) - 1;
    if (unnamed != 0)
        pose.fail(tr("write the place into Transform as Location(x=1, y=2, z=3), with the names of its numbers"));
    const auto number = [&](const char *name) { return pose.has(name) ? numbersOf(reading, pose, name, 1)[0] : 0.0; };
    const auto turn = [&](int axis, const char *name) { return about(axis, radiansFromDegrees(number(name))); };
    reading.camera.pose = rigid(turn(2, "yaw") * glm::transpose(turn(1, "pitch")) * glm::transpose(turn(0, "roll")),
                                {number("x"), number("y"), number("z")});
    reading.camera.rightHandedFromWorld[1][1] = -1.0;
    reading.say(
        tr("CARLA's world is left-handed, and in metres. The scene has its y negated: the point (x, y, z) of CARLA is "
           "(x, -y, z) here."));
    if (bare.find("attach_to") != bare.npos)
        sayNoParent(reading, "Transform");
    const auto attribute = [&](const char *name, double usual) {
        if (!set[name])
            sayUsual(reading, name, {usual});
        return set[name].value_or(usual);
    };
    reading.camera.size = sizeOf(attribute("image_size_x", 800.0), attribute("image_size_y", 600.0));
    setAngle(reading, radiansFromDegrees(attribute("fov", 90.0)), "x");
}

/// The Python dicts that begin with the type of a sensor.
Cameras mitsubaSensors(Reading &reading, const Node &)
{
    Cameras cameras;
    const string_view text = reading.text.text;
    for (std::size_t at = text.find('{'); at != text.npos; at = text.find('{', at + 1)) {
        const std::size_t quote = std::min(base::behindBlanks(text, at + 1), text.size() - 1);
        if (!text.substr(quote + 1).starts_with("type"))
            continue;
        const string_view part = text.substr(at, base::closingBracket(text, at) - at);
        const Words words = split(part.substr(0, part.find('\n', quote - at)), text[quote]);
        if (words.size() > 4 && isListed("perspective thinlens orthographic", words[3]))
            add(cameras, reading, part);
    }
    return cameras;
}

// Source: Mitsuba 3, documentation of the plugin perspective: fov in degrees, across unless fov_axis says otherwise
void readMitsubaDict(Reading &reading)
{
    const Node &one = reading.lens;
    const string_view text = one.text();
    refuseWords(reading, text, "Mitsuba", "orthographic crop_width principal_point_offset focal_length");
    const string_view world = text.substr(std::min(text.find("to_world"), text.size())),
                      made = world.substr(0, world.find("look_at("));
    const std::size_t open = std::min(made.size() + 7, world.size()), end = base::closingBracket(world, open);
    if (end == text.npos || made.find_first_of("[{,@*") != text.npos
        || world.find_first_of(".@*", end) < world.find_first_of(",\n", end))
        failValue(one, "to_world", base::trimmed(split(world, '\n')[0]));
    lookBy(reading, "origin", "target", "up", {});
    const std::string axis = one.has("fov_axis") ? one.word("fov_axis") : "x";
    if (!isListed("x y smaller larger diagonal", axis))
        failValue(one, "fov_axis", axis);
    setAngle(reading, radiansFromDegrees(numbersOf(reading, one, "fov", 1)[0]), axis);
}

/// The transform of directives of PBRT, which multiply it from the right.
dmat4 transformOf(Reading &reading, string_view directives)
{
    dmat4 pose(1.0);
    const NamedValues steps(directives);
    for (const NamedValue &step : steps.all()) {
        const Numbers &n = step.numbers;
        const auto is = [&](string_view name, std::size_t count) { return step.written == name && n.size() == count; };
        dmat4 m(1.0);
        if (is("LookAt", 9)) {
            look(reading, n, {n[3], n[4], n[5]}, {n[6], n[7], n[8]});
            m = glm::inverse(*reading.camera.pose);
        } else if (is("Translate", 3)) {
            m = glm::translate(m, vectorOf(n));
        } else if (is("Scale", 3)) {
            m = glm::scale(m, vectorOf(n));
        } else if (is("Rotate", 4)) {
            m = glm::rotate(m, radiansFromDegrees(n[0]), vectorOf(n, 1));
        } else if (is("Transform", 16) || is("ConcatTransform", 16)) {
            m = *matrixByColumns(n);
        } else {
            refuseWords(reading, step.written, "Camera", "LookAt Translate Scale Rotate Transform");
        }
        pose = step.written == "Transform" ? m : pose * m;
    }
    return pose;
}

// Source: pbrt's file formats, Transformations and Cameras: the transform before Camera takes the world to the camera,
// which has x right, y up, z ahead; fov is that of the image's shorter side; matrices are by columns
void readPbrt(Reading &reading)
{
    const std::string all = base::withoutComments(reading.text.text);
    const string_view text = string_view(all).substr(0, all.find("WorldBegin"));
    const std::size_t at = text.find("Camera \"");
    const auto parameter = [&](string_view name) -> std::optional<double> {
        const std::size_t found = text.find(' ' + std::string(name) + '"');
        string_view value = found == text.npos ? "" : text.substr(found + name.size() + 2);
        value.remove_prefix(std::min(value.find_first_not_of(" \t\r\n["), value.size()));
        return base::doubleFromWord(value.substr(0, value.find_first_of(" \t\r\n]")));
    };
    refuseWords(reading, text, "Camera",
                "orthographic spherical realistic environment screenwindow frameaspectratio halffov "
                "cropwindow pixelbounds Identity ActiveTransform CoordSysTransform TransformEnd AttributeEnd");
    reading.camera.pose = transformOf(reading, text.substr(0, at));
    if (glm::determinant(dmat3(*reading.camera.pose)) > 0.0)
        sayLeftHanded(reading);
    reading.camera.size = sizeOf(parameter("xresolution"), parameter("yresolution"));
    if (!parameter("fov"))
        sayUsual(reading, "fov", {90.0});
    setAngle(reading, radiansFromDegrees(parameter("fov").value_or(90.0)), "smaller");
}

// Source: POV-Ray's documentation, Camera, and parser/parse.cpp: angle is across, in degrees; the picture is as wide as
// right is long, and as high as up
void readPovRay(Reading &reading)
{
    const Node &one = reading.lens;
    const std::string text = base::withoutComments(one.text());
    refuseWords(reading, text, "camera",
                "orthographic fisheye ultra_wide_angle omnimax panoramic cylinder spherical "
                "mesh_camera user_defined rotate translate scale matrix transform direction");
    for (const char *name : {"location", "look_at", "sky", "angle"}) {
        if (text.find(name) != text.npos && !one.has(name))
            failValue(one, name, base::trimmed(string_view(text).substr(text.find(name))));
    }
    const ImageSize size = reading.neededSize();
    const std::map<string_view, std::string> known{{"x", "1"},
                                                   {"y", "1"},
                                                   {"image_width", std::to_string(size.width)},
                                                   {"image_height", std::to_string(size.height)}};
    const auto length = [&](string_view name, double usual) {
        const std::size_t at = text.find(name);
        if (at == text.npos) {
            sayUsual(reading, name, {usual});
            return usual;
        }
        const string_view value = base::trimmed(split(string_view(text).substr(at + name.size()), '\n')[0]);
        const auto number = base::sourceNumber(value, [&](string_view variable) {
            const auto found = known.find(variable);
            return found == known.end() ? std::nullopt : std::optional<string_view>(found->second);
        });
        if (!number)
            failValue(one, name, value);
        return number->value;
    };
    const double right = length("right", 1.33), half = std::abs(right) / 2.0, aspect = 2.0 * half / length("up", 1.0);
    reading.camera.axes = right > 0.0 ? RightUpAhead : RightUpBack;
    if (right > 0.0)
        sayLeftHanded(reading);
    lookBy(reading, "location", "look_at", "sky", {0.0, 1.0, 0.0});
    const Numbers angle = numbersOf(reading, one, "angle", 1, {degreesFromRadians(2.0 * std::atan(half))});
    reading.setVerticalAngle(2.0 * std::atan(std::tan(radiansFromDegrees(angle[0]) / 2.0) / aspect), aspect);
}

// Source: Coin, nodes/SoPerspectiveCamera.cpp and SoCamera.cpp; ISO/IEC 19775-1 (X3D), 23.4.6 Viewpoint: the angle, in
// radians, is that of the picture's shorter side; orientation is an axis and an angle
void readViewpoint(Reading &reading)
{
    const Node &one = reading.lens;
    const string_view text = one.text(), all = reading.text.text;
    const bool isX3d = reading.camera.program == "X3D";
    refuseWords(reading, text.substr(0, 5), "", "Ortho");
    refuseWords(reading, text, "viewportMapping", "CROP_VIEWPORT LEAVE_ALONE");
    for (const char *name : {"Transform", "Translation", "Rotation", "Scale"}) {
        if (all.substr(0, std::size_t(text.data() - all.data())).find(name) != all.npos)
            reading.fail(tr("%1 stands before the camera and may move it; give the camera alone, with its place in the "
                            "world",
                            name));
    }
    const Numbers at = numbersOf(reading, one, "position", 3, {0.0, 0.0, isX3d ? 10.0 : 1.0}),
                  turn = numbersOf(reading, one, "orientation", 4, {0.0, 0.0, 1.0, 0.0});
    const dmat3 axes = turn[3] == 0.0 ? dmat3(1.0) : rotationOf(turn[3] * glm::normalize(vectorOf(turn)));
    reading.camera.pose = rigid(axes, vectorOf(at));
    setAngle(reading, numbersOf(reading, one, isX3d ? "fieldOfView" : "heightAngle", 1, {kPi / 4.0})[0], "smaller");
}

constexpr Form kForms[]{
    {"Genesis", "add_camera( lookat", kOpenGl, addedCameras, readGenesis, {.size = "res", .planes = "near far"}},
    {"SAPIEN",
     "add_camera(|add_mounted_camera( fovy",
     {CameraToWorld, AheadLeftUp},
     addedCameras,
     readSapienScene,
     {.size = "width height", .planes = "near far"}},
    {"CARLA", "sensor.camera. Transform(", {CameraToWorld, AheadRightUp}, carlaCameras, readCarla},
    {"Mitsuba",
     "to_world perspective|thinlens|orthographic type",
     kOpenGl,
     mitsubaSensors,
     readMitsubaDict,
     {.size = "width height", .planes = "near_clip far_clip"}},
    {"PBRT",
     "LookAt|Transform|Rotate|Translate Camera",
     {WorldToCamera, RightUpAhead},
     [](Reading &reading, const Node &text) {
         return onlyIf(reading.text.text.find("Camera \"") != std::string::npos, text);
     },
     readPbrt},
    {"POV-Ray", "camera look_at|location", {CameraToWorld, RightUpAhead}, blocks, readPovRay},
    {"Coin",
     "PerspectiveCamera|OrthographicCamera position|orientation",
     kOpenGl,
     blocks,
     readViewpoint,
     {.planes = "nearDistance farDistance"}},
    {"X3D", "Viewpoint position|orientation|fieldOfView", kOpenGl, blocks, readViewpoint}};

} // namespace

std::span<const Form> sceneForms()
{
    return kForms;
}

} // namespace unprojector::cameras
