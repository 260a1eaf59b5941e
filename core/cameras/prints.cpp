#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/camera_json.h"
#include "core/cameras/camera_matrices.h"
#include "core/cameras/camera_reader.h"
#include "core/cameras/lens.h"
#include "core/geometry/numbers.h"
#include "core/geometry/projection.h"

#include <nlohmann/json.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

// Cameras as programs print and save them, whose names say less than their program.

namespace unprojector::cameras {
using namespace geometry;
using base::tr;
using Json = nlohmann::ordered_json;

namespace {

/// The parts of a text that begin with a mark, each up to the next end.
std::vector<std::string_view> partsOf(std::string_view text, std::string_view mark, std::string_view end)
{
    std::vector<std::string_view> parts;
    for (std::size_t at = text.find(mark); at != text.npos; at = text.find(mark, at + 1)) {
        const std::size_t next = text.find(end, at + mark.size());
        parts.push_back(text.substr(at, next - at));
    }
    return parts;
}

/// The first text in quotes.
std::string quotedIn(std::string_view text)
{
    const std::size_t begin = text.find('"') + 1;
    return std::string(begin == 0 ? std::string_view() : text.substr(begin, text.find('"', begin) - begin));
}

/// The part of the chosen camera; the whole text if it has no parts.
std::string_view chosenPart(Reading &reading, const std::vector<std::string_view> &parts)
{
    std::vector<std::string> &images = reading.camera.images;
    for (const std::string_view part : parts) {
        std::string name = quotedIn(part.substr(0, part.find('\n')));
        images.push_back(name.empty() ? std::to_string(images.size()) : std::move(name));
    }
    if (parts.empty())
        return reading.text.text;
    reading.chooseImage();
    return parts[reading.camera.image];
}

void sayNoParent(Reading &reading, const char *transform)
{
    reading.camera.assumed.push_back(
        tr("%1 counts as the camera's pose in the world, as for a camera without parent.", transform));
}

glm::dvec3 vectorOf(const std::vector<double> &v, std::size_t from = 0)
{
    return {v[from], v[from + 1], v[from + 2]};
}

void setDistortion(Reading &reading, const std::vector<double> &coefficients)
{
    if (coefficients.empty())
        return;
    const auto lens = distortionOf(coefficients);
    if (!lens && !reading.choices.isUndistorted)
        reading.fail(lens.error());
    if (lens && !lens->isNone())
        reading.camera.distortion = *lens;
}

Intrinsics lensOf(const std::vector<double> &k)
{
    return {k[0], k[4], k[2], k[5], k[1]};
}

/// A lens of this many pixels, with the principal point off the image's centre to the right and down.
void setLens(Reading &reading, double fx, double fy, double right = 0.0, double down = 0.0)
{
    const ImageSize size = reading.neededSize();
    reading.camera.intrinsics =
        Intrinsics{fx, fy, size.width / 2.0 + right, size.height / 2.0 + down, 0.0, PixelCentres::AtHalves, true};
}

void setLooking(Reading &reading, const glm::dvec3 &eye, const glm::dvec3 &at, const glm::dvec3 &up)
{
    reading.camera.pose = looking(eye, eye - at, up);
    if (!reading.camera.pose)
        reading.fail(tr("forward and up are parallel or 0; they give no axes"));
}

/// Sets a box of this height, as wide as the image has it.
void setFlat(Reading &reading, double height, double nearDistance, double farDistance)
{
    const ImageSize size = reading.neededSize();
    const double y = height / 2.0, x = y * size.width / size.height;
    reading.setProjection(Ortho{-x, x, -y, y, reading.choices.nearDistance.value_or(nearDistance),
                                reading.choices.farDistance.value_or(farDistance)},
                          0);
}

} // namespace

// Source: COLMAP, src/colmap/geometry/rigid3.cc and src/colmap/scene/camera.cc, operator<<. The text is
// read as the lines of cameras.txt and images.txt.
bool readPycolmap(Reading &reading)
{
    const std::string &text = reading.text.text;
    if (text.find("Rigid3d(") == text.npos || text.find("params") == text.npos)
        return false;
    const NamedValues &values = reading.values();
    const std::vector<double> p = values.numbers({"params"}, 3);
    const auto size = sizeIn(values);
    const std::vector<std::string_view> poses = partsOf(text, "Rigid3d(", "Rigid3d(");
    if (p.empty() || !size)
        return false;
    const NamedValues pose(chosenPart(reading, poses));
    const std::vector<double> q = pose.numbers({"rotationxyzw"}, 4), t = pose.numbers({"translation"}, 3);
    if (q.size() != 4 || t.size() != 3)
        return false;
    const std::vector<std::string> images = reading.camera.images, said = reading.camera.assumed;
    const std::size_t image = reading.camera.image;
    const NamedValue *given = values.find({"model"});
    std::string model = given ? given->word : std::string();
    model.erase(0, model.rfind('.') + 1); // CameraModelId.PINHOLE
    const bool isUnknown = model.empty() || model == "Camera";
    if (isUnknown) { // older versions print no model
        const bool hasOneFocal = 2.0 * p[1] == size->width && 2.0 * p[2] == size->height;
        model = p.size() == 3   ? "SIMPLE_PINHOLE"
                : p.size() == 8 ? "OPENCV"
                : p.size() == 5 ? "RADIAL"
                : hasOneFocal   ? "SIMPLE_RADIAL"
                                : "PINHOLE";
    }
    std::string lines = "1 " + model + ' ' + std::to_string(size->width) + ' ' + std::to_string(size->height);
    const auto add = [&lines](std::initializer_list<double> numbers) {
        for (const double number : numbers)
            base::appendNumber(lines += ' ', number);
    };
    for (const double number : p)
        add({number});
    lines += "\n1";
    add({q[3], q[0], q[1], q[2], t[0], t[1], t[2], 1.0});
    const NamedText named{reading.text.name, lines + " image\n"};
    CameraChoices choices = reading.choices;
    choices.image.clear();
    auto camera = readColmap({&named, 1}, choices);
    if (!camera)
        reading.fail(tr("the camera model %1 is not known", model));
    reading.camera = *std::move(camera);
    reading.camera.images = images;
    reading.camera.image = image;
    reading.camera.assumed.insert(reading.camera.assumed.begin(), said.begin(), said.end());
    if (text.find("cam_from_world") == text.npos && text.find("world_from_cam") != text.npos)
        reading.camera.direction = PoseDirection::CameraToWorld;
    if (isUnknown)
        reading.camera.assumed.push_back(tr("The camera model is taken as %1, because the text names none.", model));
    return true;
}

// Sources: VTK, Rendering/Core/vtkCamera.h: the angle is vertical, 30 degrees if not set; the parallel scale
// is half the height. ParaView's views and PyVista's camera_position have the same numbers.
bool readVtk(Reading &reading)
{
    const std::string &text = reading.text.text;
    const auto has = [&text](const char *word) { return text.find(word) != text.npos; };
    if (!has("camera_position") && !has("cpos") && !has("ocal_point") && !has("ocalPoint") && !has("ocal Point"))
        return false;
    ForeignCamera &camera = reading.camera;
    std::vector<std::string_view> views = partsOf(text, "CreateView(", "CreateView(");
    std::erase_if(views, [](std::string_view view) { return view.find("CameraFocalPoint") == view.npos; });
    const NamedValues values(chosenPart(reading, views));
    const std::vector<double> all = values.numbers({"cameraposition", "cpos"}, 9),
                              at = values.numbers({"camerafocalpoint", "focalpoint"}, 3),
                              eye = values.numbers({"cameraposition", "position"}, 3),
                              up = values.numbers({"cameraviewup", "viewup", "up"}, 3);
    const bool isList = all.size() == 9, isNamed = at.size() == 3 && eye.size() == 3 && up.size() == 3;
    if (!isList && !isNamed)
        return false;
    reading.begin("VTK", PoseDirection::CameraToWorld, EyeAxes::RightUpBack);
    const glm::dvec3 from = vectorOf(isList ? all : eye), to = isList ? vectorOf(all, 3) : vectorOf(at);
    setLooking(reading, from, to, isList ? vectorOf(all, 6) : vectorOf(up));
    for (const char *name : {"viewsize", "windowsize"}) {
        if (const std::vector<double> n = values.numbers({name}, 2); n.size() == 2 && !camera.size)
            camera.size = sizeOf(n[0], n[1]);
    }
    const std::vector<double> range = values.numbers({"clippingrange", "cameraclippingrange"}, 2);
    if (range.size() == 2) {
        camera.nearDistance = range[0];
        camera.farDistance = range[1];
    }
    const auto scale = values.number({"cameraparallelscale", "parallelscale"});
    const NamedValue *parallel = values.find({"cameraparallelprojection", "parallelprojection"});
    if (scale && parallel && (values.isTrue(parallel->words.back()) || parallel->word == "On")) {
        // VTK sets the range to what is drawn.
        if (!camera.farDistance)
            camera.assumed.push_back(tr("Near 0 and far, twice the distance to the focal point, are assumed; --near "
                                        "and --far say otherwise."));
        setFlat(reading, 2.0 * *scale, camera.nearDistance.value_or(0.0),
                camera.farDistance.value_or(2.0 * glm::length(to - from)));
        return true;
    }
    constexpr double kUsualAngle = 30.0;
    const auto degrees = values.number({"cameraviewangle", "viewangle"});
    if (!degrees)
        camera.assumed.push_back(tr("The vertical field of view is assumed to be %1 degrees, as in a new camera of %2.",
                                    base::shortestText(kUsualAngle), "VTK"));
    reading.setVerticalAngle(radiansFromDegrees(degrees.value_or(kUsualAngle)));
    return true;
}

// Source: Bouguet, Camera Calibration Toolbox for Matlab, "Description of the calibration parameters":
// pixels count from 0, the skew is alpha_c fc(1)
bool readBouguet(Reading &reading)
{
    const std::string &text = reading.text.text;
    if (text.find("omc_") == text.npos || text.find("Tc_") == text.npos)
        return false;
    const NamedValues &values = reading.values();
    ForeignCamera &camera = reading.camera;
    const std::vector<double> f = values.numbers({"fc"}, 2), c = values.numbers({"cc"}, 2);
    if (f.size() != 2 || c.size() != 2)
        return false;
    reading.begin("Bouguet's toolbox", PoseDirection::WorldToCamera, EyeAxes::RightDownAhead);
    std::vector<const NamedValue *> turns;
    for (const NamedValue &value : values.all()) {
        if (value.written.starts_with("omc_") && value.written.find("error") == value.written.npos
            && value.numbers.size() == 3) {
            turns.push_back(&value);
            camera.images.push_back(value.written);
        }
    }
    if (turns.empty())
        return false;
    reading.chooseImage();
    const std::string number = turns[camera.image]->written.substr(4);
    const std::vector<double> t = values.numbers({"tc" + number}, 3);
    if (t.size() != 3)
        reading.fail(tr("%1 needs %2 numbers; it has %3", "Tc_" + number, 3, t.size()));
    camera.pose = rigid(rotationOf(vectorOf(turns[camera.image]->numbers)), vectorOf(t));
    camera.size = sizeOf(values.number({"nx"}), values.number({"ny"}));
    camera.intrinsics = Intrinsics{f[0], f[1], c[0], c[1], values.number({"alphac"}).value_or(0.0) * f[0]};
    setDistortion(reading, values.numbers({"kc"}, 4));
    return true;
}

// Source: aniposelib, cameras.py, Camera.get_dict: OpenCV's rotation vector and distortion
bool readAnipose(Reading &reading)
{
    const std::string_view text = reading.text.text;
    if (text.find("distortions") == text.npos || text.find("[cam") == text.npos)
        return false;
    ForeignCamera &camera = reading.camera;
    std::vector<NamedValues> sections;
    std::vector<std::string> ids;
    for (const std::string_view part : partsOf(text, "[cam", "\n[cam")) {
        const std::size_t end = std::min(part.find(']'), part.size());
        const NamedValues &section = sections.emplace_back(part.substr(end));
        ids.emplace_back(part.substr(1, end - 1));
        const NamedValue *name = section.find({"name"});
        camera.images.push_back(name && !name->word.empty() ? name->word : ids.back());
    }
    const auto isWhole = [](const NamedValues &section) {
        return section.numbers({"matrix"}, 9).size() == 9 && section.numbers({"rotation"}, 3).size() == 3
               && section.numbers({"translation"}, 3).size() == 3;
    };
    if (sections.empty() || !std::all_of(sections.begin(), sections.end(), isWhole))
        return false;
    reading.begin("Anipose", PoseDirection::WorldToCamera, EyeAxes::RightDownAhead);
    reading.chooseImage(ids);
    const NamedValues &one = sections[camera.image];
    if (one.isTrue("fisheye") && !reading.choices.isUndistorted)
        reading.fail(unknownDistortionText("fisheye"));
    camera.size = sizeIn(one);
    camera.intrinsics = lensOf(one.numbers({"matrix"}, 9));
    camera.pose = rigid(rotationOf(vectorOf(one.numbers({"rotation"}, 3))), vectorOf(one.numbers({"translation"}, 3)));
    if (!one.isTrue("fisheye"))
        setDistortion(reading, one.numbers({"distortions"}, 4));
    return true;
}

// Source: karfly/human36m-camera-parameters, README.md: intrinsics by camera, extrinsics by subject and camera
bool readHuman36m(Reading &reading)
{
    const Json file = documentWith(reading.text, {"intrinsics", "extrinsics", "calibration_matrix"});
    ForeignCamera &camera = reading.camera;
    std::vector<std::pair<std::string, std::string>> keys;
    std::vector<std::string> ids;
    const Json &subjects = inside(file, {"extrinsics"});
    for (auto subject = subjects.begin(); subject != subjects.end(); ++subject) {
        for (auto one = subject->begin(); one != subject->end(); ++one) {
            keys.emplace_back(subject.key(), one.key());
            camera.images.push_back(subject.key() + ' ' + one.key());
            ids.push_back(subjects.size() == 1 ? one.key() : std::string());
        }
    }
    if (keys.empty())
        return false;
    reading.begin("Human3.6M", PoseDirection::WorldToCamera, EyeAxes::RightDownAhead);
    reading.chooseImage(ids);
    const auto &[subject, id] = keys[camera.image];
    const Json &lens = inside(file, {"intrinsics", id.c_str()});
    const Json &pose = inside(subjects, {subject.c_str(), id.c_str()});
    camera.intrinsics = lensOf(neededNumbers(reading, lens, "calibration_matrix", 9));
    camera.pose =
        rigid(glm::dmat3(*matrixByRows(neededNumbers(reading, pose, "R", 9))), neededVector(reading, pose, "t"));
    setDistortion(reading, numbersOf(lens, "distortion"));
    return true;
}

namespace {

/// The pose of USD's xformOps: a transform for row vectors; or translate with rotateXYZ, which turns about x
/// first, or with orient, w x y z.
std::optional<glm::dmat4> usdPose(const NamedValues &values)
{
    const std::vector<double> matrix = values.numbers({"transform"}, 16), at = values.numbers({"translate"}, 3),
                              angles = values.numbers({"rotatexyz"}, 3), q = values.numbers({"orient"}, 4);
    if (matrix.size() == 16)
        return matrixByColumns(matrix);
    if (at.size() != 3)
        return std::nullopt;
    if (q.size() == 4) {
        const auto rotation = rotationOf(q[0], q[1], q[2], q[3]);
        return rotation ? std::optional(rigid(*rotation, vectorOf(at))) : std::nullopt;
    }
    const bool isTurned = std::any_of(values.all().begin(), values.all().end(),
                                      [](const NamedValue &value) { return value.words.back().starts_with("rotate"); });
    if (isTurned && angles.size() != 3)
        return std::nullopt; // another order of the axes
    const auto turn = [&](int axis) {
        return about(axis, isTurned ? radiansFromDegrees(angles[std::size_t(axis)]) : 0.0);
    };
    return rigid(turn(2) * turn(1) * turn(0), vectorOf(at));
}

} // namespace

// Source: OpenUSD, UsdGeomCamera: the aperture and the focal length have one unit; matrices are for row vectors
bool readUsd(Reading &reading)
{
    const std::string &text = reading.text.text;
    if (text.find("horizontalAperture") == text.npos || text.find("xformOp:") == text.npos)
        return false;
    ForeignCamera &camera = reading.camera;
    const NamedValues values(chosenPart(reading, partsOf(text, "def Camera", "def ")));
    const auto aperture = values.number({"horizontalaperture"}), focal = values.number({"focallength"});
    if (!aperture || !focal)
        return false;
    reading.begin("USD", PoseDirection::CameraToWorld, EyeAxes::RightUpBack);
    camera.pose = usdPose(values);
    if (!camera.pose)
        reading.failAt("focallength",
                       tr("the camera's pose is missing; give %1", "xformOp:transform, or translate and rotateXYZ"));
    if (const std::vector<double> range = values.numbers({"clippingrange"}, 2); range.size() == 2) {
        camera.nearDistance = range[0];
        camera.farDistance = range[1];
    }
    if (const NamedValue *kind = values.find({"projection"}); kind && kind->word == "orthographic")
        reading.failAt("projection", tr("an orthographic camera of %1 is not read; give its matrices", "USD"));
    const double pixels = reading.neededSize().width / *aperture;
    const auto offset = [&](const char *name) { return values.number({name}).value_or(0.0) * pixels; };
    setLens(reading, *focal * pixels, *focal * pixels, -offset("horizontalapertureoffset"),
            offset("verticalapertureoffset"));
    camera.assumed.push_back(tr("Pixels are square: the horizontal aperture counts, not the vertical one."));
    sayNoParent(reading, "xformOp");
    return true;
}

// Source: Godot, class Camera3D: fov is vertical while keep_aspect is 1; core/math/transform_3d.cpp and
// core/variant/variant_parser.cpp: a scene has the basis by rows, a print its axes
bool readGodot(Reading &reading)
{
    const std::string_view text = reading.text.text;
    if (text.find("Transform3D(") == text.npos && text.find("[X: ") == text.npos)
        return false;
    ForeignCamera &camera = reading.camera;
    std::vector<std::string_view> nodes = partsOf(text, "[node", "\n[");
    std::erase_if(
        nodes, [](std::string_view node) { return node.substr(0, node.find('\n')).find("Camera3D\"") == node.npos; });
    const std::string_view node = chosenPart(reading, nodes);
    const NamedValues values(node);
    std::vector<double> m;
    if (const std::size_t at = node.find("Transform3D("); at != node.npos)
        m = NamedValues(node.substr(at + 11, node.find(')', at) - at - 11)).all().front().numbers;
    const std::vector<double> x = values.numbers({"x"}, 3), y = values.numbers({"y"}, 3), z = values.numbers({"z"}, 3),
                              origin = values.numbers({"o"}, 3);
    const bool arePrinted = x.size() == 3 && y.size() == 3 && z.size() == 3 && origin.size() == 3;
    if ((m.size() != 12 && !arePrinted) || (nodes.empty() && !values.has({"fov"})))
        return false;
    reading.begin("Godot", PoseDirection::CameraToWorld, EyeAxes::RightUpBack);
    camera.pose = m.size() == 12 ? rigid(glm::dmat3(*matrixByRows(std::span(m).first(9))), vectorOf(m, 9))
                                 : rigid(glm::dmat3(vectorOf(x), vectorOf(y), vectorOf(z)), vectorOf(origin));
    camera.nearDistance = values.number({"near"}).value_or(0.05);
    camera.farDistance = values.number({"far"}).value_or(4000.0);
    sayNoParent(reading, "Transform3D");
    const double projection = values.number({"projection"}).value_or(0.0);
    const bool isByWidth = values.number({"keepaspect"}).value_or(1.0) == 0.0;
    if (projection == 2.0)
        reading.failAt("projection", tr("a camera with frustum_offset is not read; give its matrices"));
    if (projection == 1.0) {
        const ImageSize size = reading.neededSize();
        const double side = values.number({"size"}).value_or(1.0);
        setFlat(reading, isByWidth ? side * size.height / size.width : side, *camera.nearDistance, *camera.farDistance);
        return true;
    }
    constexpr double kUsualAngle = 75.0;
    const double angle = radiansFromDegrees(values.number({"fov"}).value_or(kUsualAngle));
    isByWidth ? reading.setHorizontalAngle(angle) : reading.setVerticalAngle(angle);
    return true;
}

// Source: fSpy's importer for Blender, fspy_blender/addon.py: half the longer side is 1, y is up
bool readFspy(Reading &reading)
{
    const Json file = documentWith(reading.text, {"cameraTransform", "relativeFocalLength", "imageWidth"});
    const Json &one = memberOf(file, "cameraParameters") ? inside(file, {"cameraParameters"}) : file;
    if (!memberOf(one, "cameraTransform"))
        return false;
    ForeignCamera &camera = reading.camera;
    reading.begin("fSpy", PoseDirection::CameraToWorld, EyeAxes::RightUpBack);
    camera.pose = matrixByRows(neededNumbers(reading, inside(one, {"cameraTransform"}), "rows", 16));
    camera.size = sizeOf(numberOf(one, "imageWidth"), numberOf(one, "imageHeight"));
    const ImageSize size = reading.neededSize();
    const double half = std::max(size.width, size.height) / 2.0, f = neededNumber(reading, one, "relativeFocalLength");
    const Json &point = inside(one, {"principalPoint"});
    setLens(reading, f * half, f * half, numberOf(point, "x").value_or(0.0) * half,
            -numberOf(point, "y").value_or(0.0) * half);
    return true;
}

// Source: NVISII, as Deep_Object_Pose, data_generation, writes it: the rows of camera_view_matrix are columns,
// so eye, at and up count
bool readDope(Reading &reading)
{
    const Json file = documentWith(reading.text, {"camera_data", "camera_look_at", "intrinsics"});
    const Json &one = inside(file, {"camera_data"}), &look = inside(one, {"camera_look_at"}),
               &lens = inside(one, {"intrinsics"});
    if (!look.is_object())
        return false;
    ForeignCamera &camera = reading.camera;
    reading.begin("NVISII", PoseDirection::CameraToWorld, EyeAxes::RightUpBack);
    setLooking(reading, neededVector(reading, look, "eye"), neededVector(reading, look, "at"),
               neededVector(reading, look, "up"));
    camera.size = sizeOf(numberOf(one, "width"), numberOf(one, "height"));
    const auto number = [&](const char *key) { return neededNumber(reading, lens, key); };
    camera.intrinsics = Intrinsics{number("fx"), number("fy"), number("cx"), number("cy"), 0.0, PixelCentres::AtHalves};
    return true;
}

// Source: lgsvl/simulator, Assets/Scripts/Sensors, CameraSensorBase.cs: FieldOfView is that of Unity's camera
bool readLgsvl(Reading &reading)
{
    const Json file = documentWith(reading.text, {"FieldOfView", "transform", "pitch"});
    ForeignCamera &camera = reading.camera;
    std::vector<const Json *> sensors;
    for (const Json *sensor : elementsOf(inside(file, {"sensors"}).is_array() ? inside(file, {"sensors"}) : file)) {
        if (numberOf(inside(*sensor, {"params"}), "FieldOfView") && memberOf(*sensor, "transform")) {
            sensors.push_back(sensor);
            camera.images.push_back(nameOf(*sensor, "name", camera.images.size()));
        }
    }
    if (sensors.empty())
        return false;
    reading.begin("LGSVL", PoseDirection::CameraToWorld, EyeAxes::RightUpAhead);
    reading.chooseImage();
    const Json &one = *sensors[camera.image], &params = inside(one, {"params"}), &pose = inside(one, {"transform"});
    const auto angle = [&](const char *key) { return radiansFromDegrees(neededNumber(reading, pose, key)); };
    const auto at = [&](const char *key) { return neededNumber(reading, pose, key); };
    camera.rightHandedFromWorld[2][2] = -1.0;
    camera.pose =
        rigid(about(1, angle("yaw")) * about(0, angle("pitch")) * about(2, angle("roll")), {at("x"), at("y"), at("z")});
    camera.size = sizeOf(numberOf(params, "Width"), numberOf(params, "Height"));
    camera.nearDistance = numberOf(params, "MinDistance");
    camera.farDistance = numberOf(params, "MaxDistance");
    sayNoParent(reading, "transform");
    camera.assumed.push_back(tr("Unity's world is left-handed. The scene has its z negated: the point (x, y, z) of "
                                "Unity is (x, y, -z) here."));
    if (inside(params, {"Distorted"}) == true && !reading.choices.isUndistorted)
        reading.fail(unknownDistortionText("DistortionParameters"));
    reading.setVerticalAngle(radiansFromDegrees(neededNumber(reading, params, "FieldOfView")));
    return true;
}

} // namespace unprojector::cameras
