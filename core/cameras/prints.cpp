#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/camera_matrices.h"
#include "core/cameras/camera_reader.h"
#include "core/geometry/numbers.h"
#include "core/geometry/projection.h"
#include "core/pipeline/decomposition.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

// Cameras as programs print and save them, whose names say less than their program.

namespace unprojector::cameras {
using namespace geometry;
using base::tr;
using enum PoseDirection;
using enum EyeAxes;
using enum PixelCentres;
using glm::dmat3, glm::dmat4, glm::dvec3;

namespace {

bool hasWord(const Reading &reading, std::string_view word)
{
    return reading.text.text.find(word) != std::string::npos;
}

void setMatrix(Reading &reading, const dmat4 &projection)
{
    reading.camera.projection = MatrixProjection{projection, NdcDepth::MinusOneToOne};
}

// Sources: VTK, Rendering/Core/vtkCamera.h: the angle is vertical, 30 degrees if not set; the parallel scale
// is half the height. ParaView's views and PyVista's camera_position have the same numbers.
constexpr Keys kVtkNames = "cameraposition|position camerafocalpoint|focalpoint cameraviewup|viewup|up";

Numbers vtkNumbers(const Node &view)
{
    Numbers all = view.numbers("cameraposition|cpos", 9);
    for (const std::string_view key : all.size() == 9 ? Words() : split(kVtkNames, ' ')) {
        const Numbers one = view.numbers(key, 3);
        all.insert(all.end(), one.begin(), one.end());
    }
    return all.size() == 9 ? all : Numbers();
}

void readVtk(Reading &reading)
{
    ForeignCamera &camera = reading.camera;
    const Node &view = reading.lens;
    const Numbers n = vtkNumbers(view);
    if (n.empty())
        reading.fail(tr("the camera's position is missing; give its x, y and z"));
    // Calls that move the camera, or change the picture, behind its place.
    const std::string_view all = reading.text.text;
    const std::string_view rest = all.substr(std::min(all.rfind("osition"), all.size()));
    for (const std::string_view call :
         {"Azimuth(", "Elevation(", "Roll(", "Pitch(", "Yaw(", "Dolly(", "Zoom(", "zoom(", "ResetCamera(", ".azimuth",
          ".elevation", ".roll", ".zoom", "ParallelProjectionOn", "HorizontalViewAngle", "SetWindowCenter",
          "WindowCenter=", "ViewShear"}) {
        if (rest.find(call) != rest.npos)
            reading.fail(tr("%1 %2 is not read", "VTK", call.substr(0, call.find_first_of("(="))));
    }
    const dvec3 eye = vectorOf(n), back = eye - vectorOf(n, 3);
    reading.setLooking(eye, back, vectorOf(n, 6));
    reading.setSize(view, "viewsize|windowsize|size");
    reading.setPlanes(view, "clippingrange|cameraclippingrange");
    const auto scale = view.number("cameraparallelscale|parallelscale");
    const Keys parallel = "cameraparallelprojection|parallelprojection";
    if (scale && (view.isTrue(parallel) || view.word(parallel) == "On")) {
        // VTK sets the range to what is drawn.
        if (!camera.farDistance)
            reading.say(tr("Near 0 and far, twice the distance to the focal point, are assumed; --near and --far say "
                           "otherwise."));
        reading.setFlat(2.0 * *scale, reading.choices.nearDistance.value_or(camera.nearDistance.value_or(0.0)),
                        reading.choices.farDistance.value_or(camera.farDistance.value_or(2.0 * glm::length(back))));
        return;
    }
    constexpr double kUsualAngle = 30.0;
    const auto degrees = view.number("cameraviewangle|viewangle|fov|fieldofview");
    if (!degrees)
        reading.say(tr("The vertical field of view is assumed to be %1 degrees, as in a new camera of %2.",
                       base::shortestText(kUsualAngle), "VTK"));
    reading.setDegrees(degrees.value_or(kUsualAngle));
}

// Source: Bouguet, Camera Calibration Toolbox for Matlab, "Description of the calibration parameters":
// pixels count from 0, the skew is alpha_c fc(1)
Cameras bouguetImages(Reading &, const Node &text)
{
    Cameras images;
    for (const NamedValue &value : text.values().all()) {
        if (value.written.starts_with("omc_") && value.written.find("error") == value.written.npos
            && value.numbers.size() == 3)
            images.push_back({value.written, {}, text, text});
    }
    return text.numbers("fc", 2).size() == 2 && text.numbers("cc", 2).size() == 2 ? images : Cameras();
}

void readBouguet(Reading &reading)
{
    reading.setPose(reading.pose, reading.name, 3, "Tc_" + reading.name.substr(4));
    reading.setLens(reading.lens, "fc cc", AtIntegers);
    reading.camera.intrinsics->skew = reading.lens.number("alpha_c", 0.0) * reading.camera.intrinsics->fx;
}

// Source: aniposelib, cameras.py, Camera.get_dict: OpenCV's rotation vector and distortion
Cameras aniposeCameras(Reading &reading, const Node &text)
{
    Cameras cameras = sections(reading, text, "[cam", "\n[cam");
    for (Found &one : cameras) {
        const Node &own = one.lens;
        const std::string_view part = own.text();
        one.id = part.substr(1, part.find(']') - 1);
        one.name = own.word("name").empty() ? one.id : own.word("name");
        if (own.numbers("matrix", 9).size() != 9 || own.numbers("rotation", 3).size() != 3
            || own.numbers("translation", 3).size() != 3)
            return {};
    }
    return cameras;
}

void readAnipose(Reading &reading)
{
    if (!reading.lens.isTrue("fisheye"))
        setDistortion(reading, reading.lens.numbers("distortions", 4));
    else if (!reading.choices.isUndistorted)
        reading.fail(unknownDistortionText("fisheye"));
}

/// The pose of USD's xformOps: a transform for row vectors; or translate with rotateXYZ, which turns about x
/// first, or with orient, w x y z.
std::optional<dmat4> usdPose(const Node &prim)
{
    const Numbers at = prim.numbers("translate", 3), angles = prim.numbers("rotatexyz", 3),
                  q = prim.numbers("orient", 4);
    if (const auto matrix = prim.numbers("transform", 16); matrix.size() == 16)
        return matrixByColumns(matrix);
    if (at.size() != 3)
        return std::nullopt;
    if (q.size() == 4) {
        const auto rotation = rotationOf(q[0], q[1], q[2], q[3]);
        return rotation ? std::optional(rigid(*rotation, vectorOf(at))) : std::nullopt;
    }
    const auto &all = prim.values().all();
    const bool isTurned = std::any_of(all.begin(), all.end(),
                                      [](const NamedValue &value) { return value.words.back().starts_with("rotate"); });
    if (isTurned && angles.size() != 3)
        return std::nullopt; // another order of the axes
    const auto turn = [&](int axis) {
        return about(axis, isTurned ? radiansFromDegrees(angles[std::size_t(axis)]) : 0.0);
    };
    return rigid(turn(2) * turn(1) * turn(0), vectorOf(at));
}

// Source: OpenUSD, UsdGeomCamera: the aperture and the focal length have one unit; matrices are for row vectors
void readUsd(Reading &reading)
{
    const Node &prim = reading.lens;
    reading.camera.pose = usdPose(prim);
    if (!reading.camera.pose)
        prim.fail(tr("the camera's pose is missing; give %1", "xformOp:transform, or translate and rotateXYZ"),
                  "focallength");
    if (prim.word("projection") == "orthographic")
        prim.fail(tr("an orthographic camera of %1 is not read; give its matrices", "USD"), "projection");
    const ImageSize size = reading.neededSize();
    const double pixels = size.width / prim.needed("horizontalaperture"), focal = prim.needed("focallength") * pixels;
    reading.setCentred(size, focal, focal, -prim.number("horizontalapertureoffset", 0.0) * pixels,
                       prim.number("verticalapertureoffset", 0.0) * pixels);
    reading.say(tr("Pixels are square: the horizontal aperture counts, not the vertical one."));
    sayNoParent(reading, "xformOp");
}

/// The pose of a scene, with the basis by rows, or of a print, which has its axes.
/// Source: Godot, core/math/transform_3d.cpp and core/variant/variant_parser.cpp
std::optional<dmat4> godotPose(const Node &node)
{
    const std::string_view text = node.text();
    Numbers m = node.numbers("transform", 12);
    if (const std::size_t at = text.find("Transform3D("); m.empty() && at != text.npos)
        m = NamedValues(text.substr(at + 11, text.find(')', at) - at - 11)).all().front().numbers;
    if (m.size() == 12 && text.find("Transform3D(") != text.npos)
        return rigid(dmat3(*matrixByRows(std::span(m).first(9))), vectorOf(m, 9));
    const Numbers axes = node.numbers("x y z o", 12);
    return axes.size() == 12
               ? std::optional(rigid(dmat3(vectorOf(axes), vectorOf(axes, 3), vectorOf(axes, 6)), vectorOf(axes, 9)))
               : std::nullopt;
}

Cameras godotNodes(Reading &reading, const Node &text)
{
    Cameras nodes = sections(reading, text, "[node", "\n[", "Camera3D\"");
    std::erase_if(nodes,
                  [&](const Found &one) { return !godotPose(one.pose) || (one.name.empty() && !one.lens.has("fov")); });
    return nodes;
}

// Source: Godot, class Camera3D: fov is vertical while keep_aspect is 1
void readGodot(Reading &reading)
{
    const Node &node = reading.lens;
    ForeignCamera &camera = reading.camera;
    camera.pose = godotPose(reading.pose);
    camera.nearDistance = node.number("near", 0.05);
    camera.farDistance = node.number("far", 4000.0);
    sayNoParent(reading, "Transform3D");
    const double projection = node.number("projection", 0.0);
    const bool isByWidth = node.number("keepaspect", 1.0) == 0.0;
    if (projection == 2.0)
        node.fail(tr("a camera with frustum_offset is not read; give its matrices"), "projection");
    if (projection == 1.0) {
        const ImageSize size = reading.neededSize();
        reading.setFlat(node.number("size", 1.0) * (isByWidth ? double(size.height) / size.width : 1.0),
                        reading.choices.nearDistance.value_or(*camera.nearDistance),
                        reading.choices.farDistance.value_or(*camera.farDistance));
        return;
    }
    const double angle = radiansFromDegrees(node.number("fov", 75.0));
    isByWidth ? reading.setHorizontalAngle(angle) : reading.setVerticalAngle(angle);
}

/// One or all cameras of mjData: cam_xpos, cam_xmat by rows, and mjModel's cam_fovy in degrees.
Cameras mujocoCameras(Reading &, const Node &text)
{
    const Numbers axes = text.numbers("camxmat|xmat", 9), positions = text.numbers("camxpos|xpos", 3),
                  angles = text.numbers("camfovy|fovy");
    const std::size_t count = axes.size() / 9;
    if (!text.has("camxmat|xmat"))
        return {};
    if (count == 0 || axes.size() != 9 * count)
        text.fail(tr("cam_xmat needs 9 numbers a camera; it has %1", axes.size()), "xmat");
    if (positions.size() != 3 * count)
        text.fail(tr("%1 needs %2 numbers; it has %3", "cam_xpos", 3 * count, positions.size()), "xpos");
    if (angles.size() != count)
        text.fail(tr("%1 needs %2 numbers; it has %3", "cam_fovy", count, angles.size()), "fovy");
    Cameras cameras;
    for (std::size_t i = 0; i < count; ++i)
        cameras.push_back({count > 1 ? std::to_string(i) : std::string(), {}, text, text});
    return cameras;
}

void readMujoco(Reading &reading)
{
    ForeignCamera &camera = reading.camera;
    const Node &text = reading.lens;
    const std::size_t i = camera.image;
    const Numbers axes = text.numbers("camxmat|xmat", 9);
    camera.pose = matrixByRows(std::span(axes).subspan(9 * i, 9));
    (*camera.pose)[3] = glm::dvec4(vectorOf(text.numbers("camxpos|xpos", 3), 3 * i), 1.0);
    // The planes are given as shares of the model's extent.
    const auto extent = text.number("extent"), nearShare = text.number("znear"), farShare = text.number("zfar");
    if (extent && nearShare)
        camera.nearDistance = *nearShare * *extent;
    if (extent && farShare)
        camera.farDistance = *farShare * *extent;
    reading.setDegrees(text.numbers("camfovy|fovy")[i]);
}

/// mjvGLCamera: pos, forward, up and the frustum at its near plane.
void readGlCamera(Reading &reading)
{
    const Node &text = reading.lens;
    const Numbers axes = text.numbers("pos forward up", 9),
                  box = text.numbers("frustumbottom frustumtop frustumnear frustumfar", 4);
    if (axes.empty() || box.empty())
        reading.fail(tr("mjvGLCamera needs pos, forward, up, frustum_bottom, frustum_top, frustum_near and "
                        "frustum_far; one of them is missing"));
    reading.setLooking(vectorOf(axes), -vectorOf(axes, 3), vectorOf(axes, 6));
    const double centre = text.number("frustumcenter", 0.0);
    double half = text.number("frustumwidth", 0.0);
    if (half == 0.0) { // the width follows the viewport
        const ImageSize size = reading.neededSize();
        half = 0.5 * size.width / size.height * (box[1] - box[0]);
    }
    const double left = centre - half, right = centre + half;
    if (text.isTrue("orthographic"))
        reading.setProjection(Ortho{left, right, box[0], box[1], box[2], box[3]}, 0);
    else
        reading.setProjection(Frustum{left, right, box[0], box[1], box[2], box[3]}, 0);
}

/// The list of getDebugVisualizerCamera: width, height, view, projection and what follows from them.
Numbers visualizerOf(const Node &text)
{
    for (const NamedValue &value : text.values().all()) {
        const Numbers &n = value.numbers;
        if (n.size() == 52 && n[2 + 15] == 1.0 && n[18 + 11] == -1.0)
            return n;
    }
    return {};
}

constexpr Keys kBulletViews = "computeviewmatrix|computeviewmatrixfromyawpitchroll|viewmatrix|view",
               kBulletProjections =
                   "computeprojectionmatrixfov|computeprojectionmatrix|projectionmatrix|projmatrix|projection";

Cameras bulletCamera(Reading &reading, const Node &text)
{
    const bool isNamed =
        hasWord(reading, "pybullet") || hasWord(reading, "PyBullet") || hasWord(reading, "computeViewMatrix");
    return onlyIf(!visualizerOf(text).empty()
                      || (isNamed && text.numbers(kBulletViews, 16).size() == 16
                          && text.numbers(kBulletProjections, 16).size() == 16),
                  text);
}

void readBullet(Reading &reading)
{
    const Numbers all = visualizerOf(reading.lens);
    if (!all.empty())
        reading.camera.size = sizeOf(all[0], all[1]);
    const auto matrix = [&](std::size_t at, Keys keys) {
        return *matrixByColumns(
            all.empty() ? reading.lens.numbers(keys, 16)
                        : std::vector(all.begin() + std::ptrdiff_t(at), all.begin() + std::ptrdiff_t(at + 16)));
    };
    reading.camera.pose = matrix(2, kBulletViews);
    setMatrix(reading, matrix(18, kBulletProjections));
}

void readSapien(Reading &reading)
{
    const Numbers clip = reading.lens.numbers("projection_matrix|projection", 16);
    if (reading.lens.numbers("intrinsic_cv|intrinsic|K", 9).size() == 9 || clip.size() != 16)
        reading.setLens(reading.lens, "intrinsic_cv|intrinsic|K", AtHalves);
    else
        setMatrix(reading, *matrixByRows(clip));
}

/// A rotation about an axis, counter-clockwise as seen against a right-handed axis.
dmat3 aboutByDegrees(int axis, double degrees)
{
    return about(axis, radiansFromDegrees(degrees));
}

/// Says that a pose in a parent counts as one in the world.
void sayParent(Reading &reading, const char *at, const char *turn, const char *instead)
{
    reading.say(tr("%1 and %2 count as the camera's pose in the world, as for a camera without parent. Give %3 if it "
                   "has one.",
                   at, turn, instead));
}

/// Sixteen numbers by rows, of a name with numbers.
std::optional<dmat4> unityMatrix(const Node &text, const char *name)
{
    const Numbers numbers = text.numbers(name);
    const auto matrix = numbers.size() == 16 ? matrixByRows(numbers) : std::nullopt;
    if (!matrix && !numbers.empty())
        text.fail(tr("%1 needs %2 numbers; it has %3", text.values().find({name})->written, 16, numbers.size()), name);
    return matrix;
}

/// The id in "m_Father: {fileID: 12}" of a document of Unity; empty for 0, which is none.
std::string unityReference(std::string_view document, std::string_view key)
{
    const std::string mark = std::string(key) + ": {fileID: ";
    const std::size_t at = document.find(mark);
    if (at == document.npos)
        return {};
    document.remove_prefix(at + mark.size());
    const std::string_view id = document.substr(0, document.find_first_of(",}"));
    return id == "0" ? std::string() : std::string(id);
}

using UnityDocuments = std::map<std::string, std::string_view>;

/// The documents of a Unity scene: "&12" is the Transform that "--- !u!4 &12" begins, and "of 11" that of the object
/// 11.
UnityDocuments unityDocuments(std::string_view text)
{
    constexpr std::string_view kMark = "--- !u!";
    UnityDocuments documents;
    std::size_t end = 0;
    for (std::size_t at = text.find(kMark); at != text.npos; at = end) {
        end = text.find(kMark, at + 1);
        const std::string_view one = text.substr(at, end - at);
        const Words head = split(base::trimmed(split(one, '\n')[0]), ' ');
        if (head.size() < 3)
            continue;
        documents.emplace(head[2], one);
        if (head[1] == "!u!4")
            documents.emplace("of " + unityReference(one, "GameObject"), one);
    }
    documents.erase("of ");
    return documents;
}

/// The cameras of a Unity scene, each with its own object's name and Transform.
Cameras unityCameras(Reading &reading, const Node &text)
{
    UnityDocuments documents = unityDocuments(reading.text.text);
    Cameras cameras = sections(reading, text, "--- !u!20 &", "\n--- ");
    for (Found &one : cameras) {
        const std::string object = unityReference(one.lens.text(), "GameObject");
        const std::string_view transform = documents["of " + object], own = documents['&' + object];
        one.pose = Node(reading, std::make_shared<NamedValues>(transform), transform);
        if (const std::size_t at = own.find("m_Name: "); at != own.npos)
            one.name = base::trimmed(split(own.substr(at + 8), '\n')[0]);
    }
    std::erase_if(cameras, [](const Found &one) { return !one.lens.has("fieldofview"); }); // a prefab's
    return cameras;
}

void readUnityPose(Reading &reading, const Node &text)
{
    ForeignCamera &camera = reading.camera;
    for (const auto &[name, direction] :
         {std::pair("worldtocameramatrix", WorldToCamera), std::pair("cameratoworldmatrix", CameraToWorld)}) {
        if (camera.pose = unityMatrix(text, name); camera.pose) {
            camera.direction = direction;
            camera.axes = RightUpBack;
            return;
        }
    }
    const std::string_view all = text.text(), place = "m_LocalPosition";
    if (!text.has("position") && all.find(place) != all.rfind(place))
        text.fail(tr("there are several Transforms; give the camera's alone, or the whole scene with its lines ---"),
                  "mlocalposition");
    const Numbers at = text.numbers("position|mlocalposition", 3), q = text.numbers("rotation|mlocalrotation", 4),
                  angles = text.numbers("eulerangles|rotation|mlocaleulerangleshint", 3);
    if (at.size() != 3)
        text.fail(tr("the camera's position is missing; give its x, y and z"), "position");
    const auto rotation =
        q.size() == 4 ? rotationOfXyzw(q)
        : angles.size() == 3
            ? std::optional(aboutByDegrees(1, angles[1]) * aboutByDegrees(0, angles[0]) * aboutByDegrees(2, angles[2]))
            : std::nullopt;
    if (!rotation)
        text.fail(q.size() == 4
                      ? tr("the quaternion is 0 or not finite; give a rotation's, of the length 1")
                      : tr("the camera's rotation is missing; give the quaternion (x, y, z, w) or eulerAngles"),
                  "rotation");
    camera.pose = rigid(*rotation, vectorOf(at));
    if (!text.has("position") || !text.has("rotation|eulerangles"))
        sayParent(reading, "m_LocalPosition", "m_LocalRotation", "position and rotation");
}

void readUnity(Reading &reading)
{
    const Node &text = reading.lens;
    ForeignCamera &camera = reading.camera;
    sayUnity(reading);
    if (!camera.pose)
        readUnityPose(reading, text);
    if (camera.size == ImageSize{1, 1}) // m_NormalizedViewPortRect
        camera.size.reset();
    if (const auto clip = unityMatrix(text, "projectionmatrix")) {
        setMatrix(reading, *clip);
    } else if (text.isTrue("orthographic")) {
        const auto half = text.number("orthographicsize");
        if (!half || !camera.nearDistance || !camera.farDistance)
            text.fail(tr("an orthographic camera needs orthographicSize, nearClipPlane and farClipPlane"),
                      "orthographic");
        reading.setFlat(2.0 * *half, *camera.nearDistance, *camera.farDistance);
    } else {
        const auto degrees = text.number("fieldofview");
        if (!degrees)
            text.fail(tr("the field of view is missing; give fieldOfView or projectionMatrix"), "fieldofview");
        if (text.number("mprojectionmatrixmode") == 2.0)
            text.fail(tr("a physical camera is not read; give its projectionMatrix and worldToCameraMatrix"),
                      "mprojectionmatrixmode");
        reading.setVerticalAngle(radiansFromDegrees(*degrees), text.number("aspect"));
    }
}

/// The camera's Transform with those of its parents. Their scales move it; a camera's axes have none.
void readUnityScene(Reading &reading)
{
    UnityDocuments documents = unityDocuments(reading.text.text);
    dmat3 turn(1.0);
    dvec3 place(0.0);
    Node one = reading.pose;
    for (;;) {
        const Numbers at = one.numbers("mlocalposition", 3), q = one.numbers("mlocalrotation", 4),
                      scale = one.numbers("mlocalscale", 3);
        const auto own = q.size() == 4 ? rotationOfXyzw(q) : std::nullopt;
        if (at.size() != 3 || scale.size() != 3 || !own || !one.text().starts_with("--- !u!4 ")
            || std::min({scale[0], scale[1], scale[2]}) <= 0.0)
            reading.fail(
                tr("the camera %1 or a parent has no Transform in the text, as in a prefab, or a scale not above "
                   "0; give its position, rotation and fieldOfView in the world",
                   reading.name));
        place = vectorOf(at) + *own * (vectorOf(scale) * place);
        turn = *own * turn;
        const std::string parent = unityReference(one.text(), "m_Father");
        if (parent.empty())
            break;
        const std::string_view document = std::exchange(documents['&' + parent], {}); // none is its own parent
        one = Node(reading, std::make_shared<NamedValues>(document), document);
    }
    reading.camera.pose = rigid(turn, place);
    readUnity(reading);
}

/// Three values of one number each that follow one another under these names: "P=-10 Y=45 R=0".
/// @param parent  the name before them; others count where it is missing
/// @param ending  of the first name where others count: "X" leaves x out
std::optional<dvec3> inSequence(const NamedValues &values, Keys names, std::string_view parent,
                                std::string_view ending = {})
{
    const std::vector<NamedValue> &all = values.all();
    const Words three = split(names, ' ');
    std::optional<dvec3> elsewhere;
    for (std::size_t i = 0; i + 3 <= all.size(); ++i) {
        bool isIt = true;
        for (std::size_t k = 0; k < 3; ++k)
            isIt = isIt && all[i + k].isNamed(three[k]) && !all[i + k].numbers.empty();
        if (!isIt)
            continue;
        const dvec3 found(all[i].numbers[0], all[i + 1].numbers[0], all[i + 2].numbers[0]);
        if (all[i].parent.ends_with(parent))
            return found;
        if (!elsewhere && all[i].written.ends_with(ending))
            elsewhere = found;
    }
    return elsewhere;
}

/// Unreal's location, and its pitch, yaw and roll in degrees.
struct UnrealPose {
    dvec3 location, rotation;
};

std::optional<UnrealPose> unrealPose(const Node &text)
{
    // As the console command BugIt writes them.
    if (const Numbers n = text.numbers("bugitgo", 6); n.size() == 6)
        return UnrealPose{vectorOf(n), vectorOf(n, 3)};
    // Other programs write x, y, z and pitch, yaw, roll, too, in worlds of their own.
    const auto location = inSequence(text.values(), "x y z", "location", "X");
    auto rotation = inSequence(text.values(), "p y r", "rotation");
    if (!rotation)
        rotation = inSequence(text.values(), "pitch yaw roll", "rotation");
    if (const auto turned = inSequence(text.values(), "roll pitch yaw", "rotation"); turned && !rotation)
        rotation = dvec3(turned->y, turned->z, turned->x);
    return location && rotation ? std::optional(UnrealPose{*location, *rotation}) : std::nullopt;
}

constexpr Keys kUnrealAngle = "fov|fieldofview|fovangle";

void readUnreal(Reading &reading)
{
    const Node &text = reading.lens;
    const UnrealPose pose = *unrealPose(text);
    reading.camera.rightHandedFromWorld[1][1] = -1.0;
    // FRotator turns about x by roll, about y by pitch, then about z by yaw. Pitch and roll count
    // against the right-hand rule.
    reading.camera.pose = rigid(aboutByDegrees(2, pose.rotation.y) * aboutByDegrees(1, -pose.rotation.x)
                                    * aboutByDegrees(0, -pose.rotation.z),
                                pose.location);
    if (text.has("relativelocation|relativerotation"))
        sayParent(reading, "RelativeLocation", "RelativeRotation", "Location and Rotation");
    reading.say(tr("Unreal's world is left-handed and in centimetres. The scene has its y negated: the point (x, y, z) "
                   "of Unreal is (x, -y, z) here, in centimetres."));
    const auto degrees = text.number(kUnrealAngle);
    if (!degrees)
        reading.say(tr("The horizontal field of view is assumed to be 90 degrees, because FOV is missing. Add FOV=90 "
                       "with the right value to say otherwise."));
    reading.setDegrees(degrees.value_or(90.0), true);
}

/// Returns whether any type is this one: the object's own type, CAMERA, may stand before its camera's.
bool hasType(const Node &text, std::string_view type)
{
    const std::vector<NamedValue> &all = text.values().all();
    return std::any_of(all.begin(), all.end(),
                       [type](const NamedValue &value) { return value.isNamed("type") && value.word == type; });
}

void readBlenderPose(Reading &reading, const Node &text)
{
    ForeignCamera &camera = reading.camera;
    const Numbers matrix = text.numbers("matrixworld|worldmatrix");
    const Numbers &unnamed = text.values().all().front().numbers;
    if (!matrix.empty() || unnamed.size() == 16) {
        camera.pose = matrixByRows(matrix.empty() ? unnamed : matrix);
        if (matrix.size() == 9 || !camera.pose)
            text.fail(tr("%1 needs %2 numbers; it has %3", "matrix_world", 16, matrix.size()), "matrixworld");
        return;
    }
    const Numbers angles = text.numbers("rotationeuler", 3), at = text.numbers("location", 3);
    if (angles.size() != 3 || at.size() != 3)
        text.fail(tr("the camera's matrix_world is missing; give it, or location and rotation_euler"), "rotationeuler");
    for (const char *order : {"XZY", "YXZ", "YZX", "ZXY", "ZYX"}) {
        if (hasWord(reading, order))
            text.fail(tr("Euler angles in the order %1 are not read; give matrix_world", order), "rotationeuler");
    }
    // About x, then y, then z.
    camera.pose = rigid(about(2, angles[2]) * about(1, angles[1]) * about(0, angles[0]), vectorOf(at));
    sayParent(reading, "location", "rotation_euler", "matrix_world");
}

/// In pixels of width.
double blenderFocal(Reading &reading, const Node &text, bool isByHeight, bool isVertical, double side)
{
    const auto half = [](double radians) { return 2.0 * std::tan(radians / 2.0); };
    const auto isAngle = [](const std::optional<double> &angle) { return angle && *angle > 0.0 && *angle < kPi; };
    const auto lens = text.number("lens"), angle = text.number("angle"), across = text.number("anglex"),
               sensor = text.number(isByHeight ? "sensorheight" : "sensorwidth");
    if (lens && !(*lens > 0.0))
        text.fail(tr("%1 is %2; it must be greater than 0", "lens", base::shortestText(*lens)), "lens");
    if (lens && !sensor)
        reading.say(tr(isByHeight ? "The sensor is assumed to be 24 mm high, because sensor_height is missing. Add it "
                                    "to say otherwise."
                                  : "The sensor is assumed to be 36 mm wide, because sensor_width is missing. Add it "
                                    "to say otherwise."));
    if (lens)
        return *lens * side / sensor.value_or(isByHeight ? 24.0 : 36.0);
    if (isAngle(angle))
        return side / half(*angle);
    if (isAngle(across) && !isVertical)
        return reading.neededSize().width / half(*across);
    text.fail(tr("the focal length is missing; give lens in millimetres or angle in radians"), "lens");
}

/// The lens, as Blender computes its view plane: the sensor's side that fits the image's.
void readBlenderLens(Reading &reading, const Node &text)
{
    ForeignCamera &camera = reading.camera;
    const ImageSize size = reading.neededSize();
    const double aspectX = text.number("pixelaspectx", 1.0), aspectY = text.number("pixelaspecty", 1.0);
    const std::string fit = text.word("sensorfit");
    const double width = size.width, height = size.height, tall = aspectY / aspectX;
    const bool isVertical = fit == "VERTICAL" || (fit != "HORIZONTAL" && width * aspectX < height * aspectY);
    const double side = isVertical ? tall * height : width; // Blender's "view factor", in pixels
    const double shiftX = text.number("shiftx", 0.0) * side, shiftY = text.number("shifty", 0.0) * side / tall;
    if (hasType(text, "PANO"))
        text.fail(tr("a panoramic camera has no projection matrix; only PERSP and ORTHO are read"), "type");
    if (hasType(text, "ORTHO")) {
        const auto scale = text.number("orthoscale");
        if (!scale || !camera.nearDistance || !camera.farDistance)
            text.fail(tr("an orthographic camera needs ortho_scale, clip_start and clip_end"), "type");
        const double pixel = *scale / side;
        reading.setProjection(Ortho{pixel * (shiftX - width / 2.0), pixel * (shiftX + width / 2.0),
                                    pixel * tall * (shiftY - height / 2.0), pixel * tall * (shiftY + height / 2.0),
                                    *camera.nearDistance, *camera.farDistance},
                              text.values().find({"type"})->line);
        return;
    }
    const double focal = blenderFocal(reading, text, fit == "VERTICAL", isVertical, side);
    reading.setCentred(size, focal, focal / tall, -shiftX, shiftY);
}

void readBlender(Reading &reading)
{
    readBlenderPose(reading, reading.pose);
    // The product of whole numbers is exact: 720 * 70 / 100 is 504, but 720 * 0.7 is less.
    const double percent = reading.lens.number("resolutionpercentage", 100.0);
    const Numbers sides = reading.lens.numbers("resolutionx resolutiony", 2);
    if (const auto size = sides.empty()
                              ? std::nullopt
                              : sizeOf(std::floor(sides[0] * percent / 100.0), std::floor(sides[1] * percent / 100.0)))
        reading.camera.size = size;
    readBlenderLens(reading, reading.lens);
}

Cameras blenderCamera(Reading &reading, const Node &text)
{
    const bool hasPose =
        text.has("matrixworld|rotationeuler") || hasWord(reading, "<Matrix 4x4") || hasWord(reading, "Matrix(((");
    return onlyIf(hasPose && text.has("lens|angle|anglex|orthoscale|sensorwidth|shiftx"), text);
}

constexpr const char *kPyrenderPose = "camera_pose|camera_transform|pose|matrix|transform";

void readPyrender(Reading &reading)
{
    const auto angle = reading.lens.number("yfov");
    if (!angle)
        reading.fail(tr("yfov has no number; give it in radians"));
    reading.setVerticalAngle(*angle, reading.lens.number("aspectratio"));
}

void readTrimesh(Reading &reading)
{
    const Numbers angles = reading.lens.needed("fov", 2); // across and down, degrees
    const auto half = [&](std::size_t i) { return std::tan(radiansFromDegrees(angles[i]) / 2.0); };
    reading.setVerticalAngle(radiansFromDegrees(angles[1]), half(0) / half(1));
}

/// Scales an axis by -1.
dmat4 flipped(bool y, bool z)
{
    dmat4 m(1.0);
    m[1][1] = y ? -1.0 : 1.0;
    m[2][2] = z ? -1.0 : 1.0;
    return m;
}

/// The matrix without the entries that are only the rounding of single precision.
dmat4 withoutNoise(dmat4 m)
{
    constexpr double kNoise = 1e-7;
    double largest = 0.0;
    for (int i = 0; i < 16; ++i)
        largest = std::max(largest, std::abs(m[i / 4][i % 4]));
    for (int i = 0; i < 16; ++i) {
        if (std::abs(m[i / 4][i % 4]) < kNoise * largest)
            m[i / 4][i % 4] = 0.0;
    }
    return m;
}

/// The printed matrices of 3-D Gaussian splatting. These are for row vectors, so they are written transposed.
/// Eyes are OpenCV's, NDC's y points down, and depths are from 0 to 1.
void readSplatting(Reading &reading)
{
    const Node &text = reading.lens;
    ForeignCamera &camera = reading.camera;
    const auto matrix = [&](const char *name) { return matrixByColumns(text.numbers(name, 16)); };
    const auto view = matrix("worldviewtransform"), product = matrix("fullprojtransform"),
               lens = matrix("projectionmatrix");
    const auto angleX = text.number("fovx"), angleY = text.number("fovy");
    camera.pose = view;
    if (view && (lens || product)) {
        const dmat4 clip = lens ? *lens : withoutNoise(*product * glm::inverse(*view));
        camera.projection = MatrixProjection{flipped(true, false) * clip * flipped(true, true), NdcDepth::ZeroToOne};
    } else if (view && angleX && angleY) {
        reading.setVerticalAngle(*angleY, std::tan(*angleX / 2.0) / std::tan(*angleY / 2.0));
    } else if (product) {
        const auto apart = pipeline::decomposed(flipped(true, false) * *product);
        if (!apart)
            text.fail(tr("full_proj_transform is not a perspective times a view; give world_view_transform too"),
                      "fullprojtransform");
        camera.pose = apart->eyeFromWorld;
        camera.axes = RightUpBack;
        camera.projection = MatrixProjection{apart->clipFromEye, NdcDepth::ZeroToOne};
    } else {
        reading.fail(tr("world_view_transform needs 16 numbers, and full_proj_transform, projection_matrix or FoVx and "
                        "FoVy beside it"));
    }
}

constexpr Form kForms[]{
    {"MuJoCo", "xmat", kOpenGl, mujocoCameras, readMujoco},
    {"MuJoCo", "frustum_near frustum_top", kOpenGl, nullptr, readGlCamera, {.having = "frustumnear frustumtop"}},
    {"PyBullet", "", {WorldToCamera, RightUpBack}, bulletCamera, readBullet},
    {"VTK", "camera_position|cpos|ocal", kOpenGl,
     [](Reading &reading, const Node &text) {
         Cameras views = sections(reading, text, "CreateView(", "CreateView(", "CameraFocalPoint");
         if (std::all_of(views.begin(), views.end(), [](const Found &one) { return vtkNumbers(one.pose).empty(); }))
             views.clear();
         return views;
     },
     readVtk},
    {"USD",
     "horizontalAperture xformOp:",
     kOpenGl,
     [](Reading &reading, const Node &text) {
         Cameras prims = sections(reading, text, "def Camera", "def ");
         std::erase_if(prims,
                       [](const Found &one) { return one.lens.numbers("horizontalaperture focallength").empty(); });
         return prims;
     },
     readUsd,
     {.planes = "clippingrange"}},
    {"Godot", "Transform3D(|[X:", kOpenGl, godotNodes, readGodot},
    {"Blender", "", kOpenGl, blenderCamera, readBlender, {.planes = "clipstart clipend"}},
    {"Unreal",
     "",
     {CameraToWorld, AheadRightUp},
     [](Reading &, const Node &text) {
         return onlyIf(unrealPose(text) && (text.number(kUnrealAngle) || text.has("bugitgo")), text);
     },
     readUnreal},
    // Source: Unity's manual, Format of text serialized files and YAML class ID reference
    {"Unity",
     "!u!20",
     {CameraToWorld, RightUpAhead},
     unityCameras,
     readUnityScene,
     {.planes = "nearclipplane farclipplane"}},
    {"Unity",
     "",
     {CameraToWorld, RightUpAhead},
     nullptr,
     readUnity,
     {.having = "worldtocameramatrix|cameratoworldmatrix projectionmatrix|fieldofview",
      .planes = "nearclipplane farclipplane"}},
    {"Unity",
     "",
     {CameraToWorld, RightUpAhead},
     nullptr,
     readUnity,
     {.having = "position|mlocalposition rotation|eulerangles|mlocalrotation fieldofview|orthographicsize",
      .planes = "nearclipplane farclipplane"}},
    {"trimesh",
     "",
     kOpenGl,
     nullptr,
     readTrimesh,
     {.having = "cameratransform fov", .planes = "znear zfar", .pose = kPyrenderPose}},
    {"pyrender",
     "",
     kOpenGl,
     nullptr,
     readPyrender,
     {.having = "yfov cameratransform|camerapose|pose|matrix|transform",
      .planes = "znear zfar",
      .pose = kPyrenderPose}},
    {"Gaussian splatting",
     "world_view_transform|full_proj_transform",
     {},
     nullptr,
     readSplatting,
     {.having = "worldviewtransform|fullprojtransform", .planes = "znear zfar"}},
    {"SAPIEN",
     "",
     {},
     nullptr,
     readSapien,
     {.having = "extrinsiccv intrinsiccv|intrinsic|k|projectionmatrix|projection", .pose = "extrinsic_cv"}},
    {"SAPIEN",
     "",
     kOpenGl,
     nullptr,
     readSapien,
     {.having = "cam2worldgl intrinsiccv|intrinsic|k|projectionmatrix|projection", .pose = "cam2world_gl"}},
    {"Bouguet's toolbox", "omc_ Tc_", {}, bouguetImages, readBouguet, {.size = "nx ny", .distortion = "kc"}},
    {"Anipose",
     "distortions [cam",
     {},
     aniposeCameras,
     readAnipose,
     {.lens = "matrix", .pose = "rotation", .count = 3, .at = "translation"}}};

} // namespace

std::span<const Form> printForms()
{
    return kForms;
}

} // namespace unprojector::cameras
