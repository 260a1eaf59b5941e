#include "core/base/number_text.h"
#include "core/base/source_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/camera_matrices.h"
#include "core/cameras/camera_reader.h"
#include "core/geometry/numbers.h"
#include "core/geometry/projection.h"

#include <nlohmann/json.hpp>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

// JSON of reconstructions, captures, data sets and scenes.

namespace unprojector::cameras {
using namespace geometry;
using base::marked, base::tr;
using enum PoseDirection;
using enum EyeAxes;
using enum PixelCentres;
using base::Json;
using glm::dmat3, glm::dmat4, glm::dvec3;

namespace {

/// The size of the lens in the file, which its numbers count in.
ImageSize lensSize(Reading &reading, const Node &lens)
{
    reading.setSize(lens, "width height");
    return reading.camera.size ? *reading.camera.size : reading.neededSize();
}

/// Leaves out views without a pose where the file has poses.
Cameras posed(Reading &reading, Cameras views, bool hasPoses)
{
    if (hasPoses)
        std::erase_if(views, [](const Found &view) { return !view.pose; });
    if (views.empty())
        reading.fail(tr("there are no cameras"));
    return views;
}

Cameras openMvgViews(Reading &reading, const Node &file)
{
    auto poses = file.index("extrinsics", "key"), lenses = file.index("intrinsics", "key");
    Cameras views;
    for (const Node &entry : file.list("views")) {
        const Node view = entry["value/ptr_wrapper/data"];
        views.push_back({view.word("filename"), view.word("id_view"), poses[view.word("id_pose")]["value"],
                         lenses[view.word("id_intrinsic")]["value"]});
    }
    return posed(reading, std::move(views), !file.list("extrinsics").empty());
}

void readOpenMvgLens(Reading &reading)
{
    const Node lens = reading.lens["ptr_wrapper/data"],
               base = lens.has("value0") ? lens["value0"] : lens; // of a parent
    // A later lens of the same class has no name, so the coefficients' key tells the model.
    std::optional<Numbers> coefficients;
    if (base.has("focal_length") && !lens.has("fisheye"))
        coefficients = lens.numbers("disto_t2|disto_k3|disto_k1");
    const std::string name = reading.lens.word("polymorphic_name");
    setDistortion(reading, name.empty() ? "fisheye" : name, coefficients);
    lensSize(reading, base);
    const double focal = base.needed("focal_length");
    const Numbers centre = base.needed("principal_point", 2);
    reading.camera.intrinsics = Intrinsics{focal, focal, centre[0], centre[1]};
}

Cameras aliceVisionViews(Reading &reading, const Node &file)
{
    auto poses = file.index("poses", "poseId"), lenses = file.index("intrinsics", "intrinsicId");
    Cameras views;
    for (const Node &view : file.list("views")) {
        const std::string id = view.word("viewId"), pose = view.word("poseId");
        views.push_back(
            {view.word("path"), id, poses[pose.empty() ? id : pose], lenses[view.word("intrinsicId")], view});
    }
    return posed(reading, std::move(views), !file.list("poses").empty());
}

// Source: AliceVision, sfmDataIO/jsonIO.cpp: versions, units and what the principal point counts from.
void readAliceVisionLens(Reading &reading)
{
    const Node &lens = reading.lens;
    const Numbers pixels = lens.numbers("pxFocalLength"), centre = lens.needed("principalPoint", 2),
                  v = reading.file.numbers("version");
    const double version = v.size() == 3 ? 1e4 * v[0] + 1e2 * v[1] + v[2] : pixels.empty() ? 10205 : 0;
    const ImageSize size = lensSize(reading, lens);
    const glm::dvec2 origin = version < 10201 ? glm::dvec2(0.0) : glm::dvec2(size.width, size.height) / 2.0;
    Intrinsics k{0.0, 0.0, origin.x + centre[0], origin.y + centre[1]};
    if (pixels.empty()) {
        const double ratio = lens.number("pixelRatio", 1.0);
        k.fx = lens.needed("focalLength") / lens.number("sensorWidth", 36.0) * size.width; // its own default
        k.fy = version < 10205 ? k.fx / ratio : k.fx * ratio;
        if (ratio != 1.0)
            reading.say(tr("The pixel ratio is %1: fy is assumed %2 and fx %3.", base::shortestText(ratio),
                           base::significantText(k.fy, 6), base::significantText(k.fx, 6)));
    } else {
        k.fx = pixels.front();
        k.fy = pixels.back();
    }
    reading.camera.intrinsics = k;
    // Later versions name the distortion apart from the projection, and keep 3DE's as an undistortion.
    const std::string type = lens.word("type"), later = lens.word("distortionType");
    const std::string &model = later.empty() || later == "none" ? type : later;
    const Numbers c = lens.numbers("distortionParams");
    const bool isBrown = base::isListed("pinhole radial1 radial3 radialk1 radialk3 brown", model) || areZero(c);
    const bool isRead = isBrown && !type.starts_with("fisheye") && !type.starts_with("equi")
                        && areZero(lens.numbers("undistortionParams"));
    setDistortion(reading, model, isRead ? std::optional(c) : std::nullopt);
    if (reading.pose && reading.own.has("rigId") && base::isListed("false 0", reading.own.word("isPoseIndependant")))
        reading.fail(tr("the pose of %1 is that of its rig; poses of rigs are not read", reading.name));
}

Cameras openSfmShots(Reading &, const Node &file)
{
    Cameras shots;
    for (const Node &part : file.elements()) {
        auto lenses = part.index("cameras", "");
        for (const Node &shot : part.list("shots"))
            shots.push_back({shot.key(), {}, shot, lenses[shot.word("camera")], part});
    }
    return shots;
}

// Source: OpenSfM, doc/source/geometry.rst: normalized coordinates count from the image's middle, and
// the larger side is 1; opensfm/io.py: rotation is an angle-axis from world to camera.
void readOpenSfmLens(Reading &reading)
{
    const auto of = [&](const char *key) { return reading.lens.number(key, 0.0); };
    const std::string type = reading.lens.word("projection_type");
    const bool isRead = type.empty() || base::isListed("perspective simple_radial radial brown", type);
    setDistortion(reading, type,
                  isRead ? std::optional(std::vector{of("k1"), of("k2"), of("k3"), of("p1"), of("p2")}) : std::nullopt);
    const ImageSize size = lensSize(reading, reading.lens);
    const double side = std::max(size.width, size.height);
    const bool hasTwo = reading.lens.has("focal_x");
    reading.setCentred(size, side * reading.lens.needed(hasTwo ? "focal_x" : "focal"),
                       side * reading.lens.needed(hasTwo ? "focal_y" : "focal"), side * of("c_x"), side * of("c_y"));
    if (reading.own.has("reference_lla"))
        reading.say(tr("The world's axes are metres east, north and up of reference_lla; objects in other coordinates "
                       "do not fit."));
}

void readPathLens(Reading &reading)
{
    for (const char *key : {"camera_type", "camera_model"}) {
        if (const std::string type = reading.file.word(key); !type.empty() && type != "perspective")
            setDistortion(reading, type, {});
    }
    reading.setSize(reading.file, "render_width render_height");
    reading.setDegrees(reading.lens.needed("fov"));
}

// Source: record3d, issues 27, 33 and 36: qx qy qz qw x y z, camera to world, OpenGL's axes; K by columns
Cameras recordedFrames(Reading &, const Node &file)
{
    Cameras frames;
    for (const Node &pose : file.list("poses"))
        frames.push_back({pose.key(), {}, pose, file});
    return !frames.empty() && frames[0].pose.json().size() == 7 ? frames : Cameras();
}

void readRecordedLens(Reading &reading)
{
    const std::size_t frame = reading.camera.image;
    const Numbers own = reading.file.numbers("perFrameIntrinsicCoeffs"); // fx fy cx cy
    if (own.size() != 4 * reading.camera.images.size())
        return;
    const double *k = own.data() + 4 * frame;
    reading.camera.intrinsics = Intrinsics{k[0], k[1], k[2], k[3], 0.0, AtHalves};
}

/// Adds the cameras of an object and its children, each with its matrices up the parents.
void addThreeCameras(const Node &object, const dmat4 &parent, Cameras &found)
{
    if (base::isListed("PerspectiveCamera OrthographicCamera", object.word("type"))) {
        const std::string id = object.word("uuid");
        found.push_back({object.has("name") ? object.word("name") : id, id, object, object, {}, parent});
    }
    const auto own = matrixByColumns(object.numbers("matrix"));
    for (const Node &child : object.json().is_object() ? object.list("children") : std::vector<Node>())
        addThreeCameras(child, own ? parent * *own : parent, found);
}

// Source: three.js, Object3D.toJSON, cameras/PerspectiveCamera.js and OrthographicCamera.js; its editor's
// files have the scene and the camera apart.
Cameras threeCameras(Reading &, const Node &file)
{
    Cameras found;
    for (const Node &root : {file, file["object"], file["scene/object"], file["camera/object"]})
        addThreeCameras(root, dmat4(1.0), found);
    return found;
}

void readThreeLens(Reading &reading)
{
    const Node &lens = reading.lens;
    if (lens.number("filmOffset", 0.0) != 0.0 || lens.isTrue("view/enabled"))
        reading.fail(tr("a camera with filmOffset or setViewOffset is not read; give its projectionMatrix and "
                        "matrixWorldInverse"));
    const double zoom = lens.number("zoom", 1.0);
    if (lens.word("type") == "PerspectiveCamera") {
        reading.setVerticalAngle(2.0 * std::atan(std::tan(radiansFromDegrees(lens.needed("fov")) / 2.0) / zoom),
                                 lens.number("aspect"));
        return;
    }
    const Numbers box = lens.needed("left right bottom top near far", 6);
    const double x = (box[0] + box[1]) / 2.0, y = (box[2] + box[3]) / 2.0, dx = (box[1] - box[0]) / (2.0 * zoom),
                 dy = (box[3] - box[2]) / (2.0 * zoom);
    reading.camera.nearDistance = reading.camera.farDistance = {};
    reading.setProjection(Ortho{x - dx, x + dx, y - dy, y + dy, box[4], box[5]}, 0);
}

bool hasOnly(const Node &object, std::string_view keys)
{
    const Json &json = object.json();
    return std::all_of(json.items().begin(), json.items().end(),
                       [&](const auto &item) { return base::isListed(keys, item.key()); });
}

/// Returns whether an object is an image's record of BOP. Other programs have cam_K, too.
bool isBopRecord(const Node &record)
{
    return record.has("cam_K")
           && hasOnly(record, "cam_K cam_R_w2c cam_t_w2c depth_scale view_level width height elev azimuth mode");
}

// Source: bop_toolkit, docs/bop_datasets_format.md: numbers by rows, OpenCV's axes, millimetres.
Cameras bopImages(Reading &, const Node &file)
{
    if (isBopRecord(file)) // without its id
        return onlyIf(true, file);
    Cameras images;
    for (const Node &record : file.list("")) {
        const std::string id = record.key();
        images.push_back({std::string(id.size() < 6 ? 6 - id.size() : 0, '0') + id, id, record, record}); // 000048.png
        if (!isBopRecord(record))
            return {};
    }
    return file.json().is_object() ? images : Cameras();
}

/// BOP's camera.json. Depth cameras of other programs have more keys.
Cameras bopLens(Reading &, const Node &file)
{
    const bool isIt = file.json().size() == 7 && hasOnly(file, "cx cy depth_scale fx fy height width");
    return onlyIf(isIt, file);
}

constexpr const char *kWholeCentres =
    marked("Pixel centres are assumed at whole numbers; --pixel-centers half says otherwise.");

constexpr Form kBopLens{"BOP",   "depth_scale fx",
                        {},      bopLens,
                        nullptr, {.isLax = true, .size = "width height", .lens = "fx fy cx cy", .note = kWholeCentres},
                        nullptr, Format::Json};

void readBop(Reading &reading)
{
    for (const NamedText &other : reading.all) {
        Reading beside(other, reading.choices);
        Json json;
        if (&other == &reading.text || !openDocument(beside, kBopLens, json) || bopLens(beside, beside.file).empty())
            continue;
        const Numbers sides = beside.file.needed("width height", 2);
        if (!reading.camera.size)
            reading.camera.size = sizeOf(sides[0], sides[1]);
        reading.camera.files.push_back(other.name);
    }
    if (reading.pose.has("cam_R_w2c")) {
        reading.setPose(reading.pose, "cam_R_w2c", 9, "cam_t_w2c");
        reading.say(tr("Lengths are in millimetres, as BOP writes cam_t_w2c."));
    }
}

Cameras bopObjects(Reading &reading, const Node &)
{
    reading.fail(tr("scene_gt.json has the poses of objects and no camera; give scene_camera.json"));
}

Cameras nerfFrames(Reading &reading, const Node &file)
{
    if (!file.has("frames") && !file.has("transform_matrix")) {
        if (file.has("fl_x|camera_angle_x"))
            reading.fail(tr("there are no poses; give the frames, each with its transform_matrix"));
        return {};
    }
    if (!file.has("frames"))
        return onlyIf(true, file);
    Cameras frames;
    for (const Node &frame : file.list("frames"))
        frames.push_back({frame.has("file_path") ? frame.word("file_path") : frame.key(), {}, frame, frame});
    if (frames.empty())
        file.fail(tr("there are no frames"), "frames");
    return frames;
}

/// transforms.json of NeRF, Instant-NGP and Nerfstudio: a frame's own members, else the file's.
void readNerf(Reading &reading)
{
    ForeignCamera &camera = reading.camera;
    Json all = Json::object();
    for (const Node *part : {&reading.file, &reading.pose}) {
        for (auto item = part->json().begin(); item != part->json().end(); ++item) {
            if (item.key() != "frames")
                all[item.key()] = *item;
        }
    }
    const Node one(reading, all);
    const auto fail = [&reading](const char *key, std::string reason) {
        (reading.pose.has(key) ? reading.pose : reading.file).fail(std::move(reason), key);
    };
    const std::string model = one.word("camera_model");
    if (!model.empty() && !base::isListed("OPENCV PINHOLE SIMPLE_PINHOLE perspective SIMPLE_RADIAL RADIAL", model)
        && !reading.choices.isUndistorted)
        fail("camera_model", tr("the camera model %1 is not read: it is no pinhole with the distortion of Brown and "
                                "Conrady. Undistort the images first, then give --undistorted",
                                model));
    for (const char *key : {"is_fisheye", "k4", "k5", "k6"}) {
        if (one.isTrue(key) && !reading.choices.isUndistorted)
            fail(key, tr("%1 is of a distortion that is not read; undistort the images first, then give --undistorted",
                         key));
    }
    reading.setSize(one, "w h");
    for (const char *key : {"w", "h"}) {
        if (const Json &side = one[key].json();
            !side.is_null() && !reading.choices.size && !(base::isJsonNumber(side) && sizeOf(one.number(key), 1.0)))
            fail(key, tr("%1 is %2; it must be a whole number from 1 to 1000000", key, base::compactJson(side)));
    }
    const auto fx = one.number("fl_x|fl_y"), fy = one.number("fl_y|fl_x"), angleX = one.number("camera_angle_x"),
               angleY = one.number("camera_angle_y"), cx = one.number("cx"), cy = one.number("cy");
    if (fx) {
        camera.intrinsics = Intrinsics{*fx, *fy, 0.0, 0.0, 0.0, AtHalves};
        constexpr double kSame = 0.01;
        const double byAngle = angleX && reading.size() ? reading.size()->width / (2.0 * std::tan(*angleX / 2.0)) : *fx;
        if (std::abs(byAngle / *fx - 1.0) > kSame)
            reading.say(tr("fl_x is %1, but camera_angle_x gives %2: fl_x is taken. Remove the wrong one.",
                           base::significantText(*fx, 6), base::significantText(byAngle, 6)));
    } else if (angleX) {
        reading.setHorizontalAngle(*angleX);
        if (angleY)
            camera.intrinsics->fy = reading.neededSize().height / (2.0 * std::tan(*angleY / 2.0));
    } else if (angleY) {
        reading.setVerticalAngle(*angleY);
    } else {
        fail("frames", tr("there is neither fl_x nor camera_angle_x; give one of them"));
    }
    if (cx.has_value() != cy.has_value())
        fail(cx ? "cx" : "cy", tr("%1 is given without %2; give both", cx ? "cx" : "cy", cx ? "cy" : "cx"));
    camera.intrinsics->cx = cx ? *cx : reading.neededSize().width / 2.0;
    camera.intrinsics->cy = cy ? *cy : reading.neededSize().height / 2.0;
    camera.intrinsics->isCentreComputed = !cx;
    reading.say(tr(cx ? "Pixel centres are read at halves, as COLMAP writes cx and cy; --pixel-centers integer says "
                        "otherwise."
                      : "The principal point is assumed in the image's centre, because cx and cy are missing. Write "
                        "them into the file to say otherwise."));
    const auto of = [&one](const char *key) { return one.number(key, 0.0); };
    setDistortion(reading, model, Numbers{of("k1"), of("k2"), of("k3"), of("p1"), of("p2")});
    std::string names;
    for (const char *key : {"scale", "offset", "aabb_scale", "aabb", "applied_transform", "applied_scale"}) {
        if (reading.file.has(key))
            names += (names.empty() ? "" : ", ") + std::string(key);
    }
    if (!names.empty())
        reading.say(tr("%1: not applied. Coordinates are those of transform_matrix.", names));
}

/// Returns whether a file has only Open3D's keys; other programs have intrinsic_matrix, too.
bool isPlain(const Node &file)
{
    const Json &json = file.json();
    return json.is_object() && (json.contains("intrinsic_matrix") || json.contains("intrinsic"))
           && std::ranges::all_of(json.items(), [](const auto &item) {
                  return base::isListed(
                      "class_name version_major version_minor intrinsic extrinsic intrinsic_matrix width height",
                      item.key());
              });
}

/// PinholeCameraParameters, PinholeCameraTrajectory, PinholeCameraIntrinsic, and ViewTrajectory, which
/// its viewer copies to the clipboard. The name of the class is missing where someone copied the middle
/// of a file.
Cameras open3dCameras(Reading &, const Node &file)
{
    const std::string kind = file.word("class_name");
    if (!base::isListed("PinholeCameraParameters PinholeCameraTrajectory PinholeCameraIntrinsic ViewTrajectory", kind)
        && !(kind.empty() && isPlain(file)))
        return {};
    const char *key = kind == "ViewTrajectory" ? "trajectory" : "parameters";
    Cameras cameras;
    for (const Node &one : file.list(key))
        cameras.push_back({one.key(), {}, one, one});
    if (cameras.empty() && file.has(key))
        file.fail(tr("there are no cameras"), key);
    return cameras.empty() ? onlyIf(true, file) : cameras;
}

/// The camera of Open3D's viewer, as its ViewControl computes it.
void readOpen3dView(Reading &reading, const Node &view)
{
    ForeignCamera &camera = reading.camera;
    const dvec3 lowest = view.vector("boundingbox_min"), extents = view.vector("boundingbox_max") - lowest,
                front = view.vector("front"), centre = view.vector("lookat"), up = view.vector("up");
    const auto degrees = view.number("field_of_view"), zoom = view.number("zoom");
    if (!degrees || !zoom)
        view.fail(tr("field_of_view and zoom need a number each"), "zoom");
    const std::string noDistance = tr("the bounding box, zoom and field_of_view give no distance; all must be above 0");
    const double extent = std::max({extents.x, extents.y, extents.z}), half = *zoom * extent;
    const double distance = half / std::tan(radiansFromDegrees(*degrees) / 2.0);
    if (!(extent > 0.0) || !(distance > 0.0))
        view.fail(noDistance, "zoom");
    camera.pose = looking(centre + distance * front / glm::length(front), front, up);
    if (!camera.pose)
        view.fail(tr("front and up are parallel or 0; they give no axes"), "front");
    camera.direction = CameraToWorld;
    camera.axes = RightUpBack;
    const double nearDistance = distance - 3.0 * extent, farDistance = distance + 3.0 * extent;
    camera.farDistance = farDistance;
    camera.nearDistance = std::max(0.01 * extent, nearDistance);
    constexpr double kOrthographic = 5.0; // this angle stands for a parallel projection
    if (*degrees != kOrthographic)
        reading.setDegrees(*degrees);
    else if (reading.neededSize(); !(farDistance > nearDistance) || !(half > 0.0))
        view.fail(noDistance, "zoom");
    else
        reading.setFlat(2.0 * half, nearDistance, farDistance);
}

void readOpen3d(Reading &reading)
{
    if (reading.file.word("class_name") == "ViewTrajectory")
        return readOpen3dView(reading, reading.lens);
    const bool isLens = reading.lens.has("intrinsic_matrix");
    const Node lens = isLens ? reading.lens : reading.lens["intrinsic"];
    if (!lens)
        reading.lens.fail(tr("there is no intrinsic; give the focal length there"), "extrinsic");
    reading.setLens(lens, "intrinsic_matrix", AtIntegers);
    reading.setSize(lens, "width height");
    if (isLens)
        return;
    reading.setPose(reading.pose, "extrinsic", 16, {}, true);
}

/// The node's own transform: its matrix, or translation, rotation and scale.
std::optional<dmat4> transformOf(const Node &node)
{
    if (node.has("matrix"))
        return matrixByColumns(node.numbers("matrix"));
    const auto numbers = [&](const char *key, Numbers otherwise) {
        return node.has(key) ? node.numbers(key) : std::move(otherwise);
    };
    const Numbers t = numbers("translation", {0, 0, 0}), q = numbers("rotation", {0, 0, 0, 1}),
                  s = numbers("scale", {1, 1, 1});
    if (t.size() != 3 || q.size() != 4 || s.size() != 3)
        return std::nullopt;
    const auto rotation = rotationOf(q[3], q[0], q[1], q[2]);
    if (!rotation)
        return std::nullopt;
    dmat4 m = rigid(*rotation, vectorOf(t));
    for (int i = 0; i < 3; ++i)
        m[i] *= s[std::size_t(i)];
    return m;
}

/// The parent of each node of glTF; null without one.
std::vector<const Node *> parentsOf(const std::vector<Node> &nodes)
{
    std::vector<const Node *> parents(nodes.size());
    for (const Node &node : nodes) {
        for (const double child : node.numbers("children")) {
            if (child >= 0.0 && child < double(nodes.size()))
                parents[std::size_t(child)] = &node;
        }
    }
    return parents;
}

/// The cameras of nodes. The names of the lens and of the nodes around it choose one, too.
Cameras gltfCameras(Reading &reading, const Node &file)
{
    if (!file["nodes"].json().is_array() || !file["cameras"].json().is_array())
        return {};
    const std::vector<Node> lenses = file.list("cameras"), nodes = file.list("nodes");
    const std::vector<const Node *> parents = parentsOf(nodes);
    const std::string &choice = reading.choices.image;
    Cameras cameras;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Node &node = nodes[i];
        const auto index = base::integerFromWord(node.word("camera"));
        if (!index || *index < 0 || std::size_t(*index) >= lenses.size())
            continue;
        const Node &lens = lenses[std::size_t(*index)];
        bool isChosen = lens.word("name") == choice;
        int level = 256; // a node may be its own parent
        for (const Node *up = parents[i]; up && --level > 0; up = parents[std::stoul(up->key())])
            isChosen = isChosen || up->word("name") == choice;
        cameras.push_back({node.has("name") ? node.word("name") : node.key(), isChosen ? choice : "", node, lens});
    }
    return cameras;
}

void readGltf(Reading &reading)
{
    const std::vector<Node> nodes = reading.file.list("nodes");
    const std::vector<const Node *> parents = parentsOf(nodes);
    const auto nameOf = [](const Node &node) { return node.has("name") ? node.word("name") : node.key(); };
    dmat4 pose(1.0);
    std::size_t steps = 0;
    for (const Node *node = &reading.pose; node; node = parents[std::stoul(node->key())]) {
        const std::optional<dmat4> own = transformOf(*node);
        if (!own)
            node->fail(tr("the transform of the node %1 is incomplete; it needs 16 numbers of a matrix, or "
                          "translation, rotation and scale",
                          nameOf(*node)));
        pose = *own * pose;
        if (++steps > nodes.size())
            node->fail(tr("the node %1 is its own parent", nameOf(reading.pose)));
    }
    reading.camera.pose = pose;
    if (const Node lens = reading.lens["perspective"]) {
        const auto angle = lens.number("yfov");
        if (!angle)
            lens.fail(tr("the camera has no yfov"));
        reading.setPlanes(lens, "znear zfar");
        reading.setVerticalAngle(*angle, lens.number("aspectRatio"));
        return;
    }
    const Numbers box = reading.lens["orthographic"].numbers("xmag ymag znear zfar", 4);
    if (box.size() != 4)
        reading.lens.fail(
            tr("the camera needs perspective with yfov, or orthographic with xmag, ymag, znear and zfar"));
    reading.setProjection(Ortho{-box[0], box[0], -box[1], box[1], box[2], box[3]}, 0);
}

void readSplatting(Reading &reading)
{
    if (reading.pose.numbers("position").size() != 3 || reading.pose.numbers("rotation").size() != 9
        || reading.pose.numbers("fx fy").size() != 2 || !reading.camera.size)
        reading.pose.fail(tr("the camera needs position, rotation, fx, fy, width and height; one of them is missing"));
    reading.setPose(reading.pose, "rotation", 9, "position");
    reading.setCentred(*reading.camera.size, reading.lens.needed("fx"), reading.lens.needed("fy"));
}

// Source: karfly/human36m-camera-parameters, README.md: intrinsics by camera, extrinsics by subject and camera
Cameras humanCameras(Reading &, const Node &file)
{
    Cameras cameras;
    const std::vector<Node> subjects = file.list("extrinsics");
    auto lenses = file.index("intrinsics", "");
    for (const Node &subject : subjects) {
        for (const Node &one : subject.list(""))
            cameras.push_back({subject.key() + ' ' + one.key(), subjects.size() == 1 ? one.key() : std::string(), one,
                               lenses[one.key()]});
    }
    return cameras;
}

// Source: fSpy's importer for Blender, fspy_blender/addon.py: half the longer side is 1, y is up
void readFspyLens(Reading &reading)
{
    const ImageSize size = reading.neededSize();
    const double half = std::max(size.width, size.height) / 2.0, f = reading.lens.needed("relativeFocalLength");
    reading.setCentred(size, f * half, f * half, reading.lens.number("principalPoint/x", 0.0) * half,
                       -reading.lens.number("principalPoint/y", 0.0) * half);
}

void readDopePose(Reading &reading)
{
    const Node look = reading.pose["camera_look_at"];
    const dvec3 eye = look.vector("eye");
    reading.setLooking(eye, eye - look.vector("at"), look.vector("up"));
}

void readLgsvl(Reading &reading)
{
    const Numbers turn = reading.pose.needed("transform/yaw transform/pitch transform/roll", 3);
    const auto about = [&](int axis, std::size_t i) { return cameras::about(axis, radiansFromDegrees(turn[i])); };
    reading.camera.pose =
        rigid(about(1, 0) * about(0, 1) * about(2, 2), reading.pose.vector("transform/x transform/y transform/z"));
    sayNoParent(reading, "transform");
    sayUnity(reading);
    if (reading.lens.isTrue("params/Distorted") && !reading.choices.isUndistorted)
        reading.fail(unknownDistortionText("DistortionParameters"));
    reading.setDegrees(reading.lens.needed("params/FieldOfView"));
}

/// Source: Apple, ARCamera: x right, y up, -z ahead; the principal point from the corner of the image
constexpr const char *kArKit = marked("Pixel centres are read at halves: ARKit counts the principal point from the "
                                      "image's corner. --pixel-centers integer says otherwise.");

constexpr Form kForms[]{
    // Source: OpenMVG, cameras/Camera_Pinhole*_io.hpp, Camera_undistort_image.hpp (pixel centres at whole
    // numbers), and the documentation of its poses: R from world to camera, and the centre C.
    {"OpenMVG",
     "sfm_data_version views",
     {},
     openMvgViews,
     readOpenMvgLens,
     {.pose = "rotation", .count = 9, .centre = "center"}},

    // Source: AliceVision, sfmDataIO/jsonIO.cpp: saveMatrix writes Eigen's order, by columns;
    // image/undistort.cpp has pixel centres at whole numbers.
    {"AliceVision",
     "views intrinsics intrinsicId",
     {},
     aliceVisionViews,
     readAliceVisionLens,
     {.pose = "pose/transform/rotation", .count = 9, .isByColumns = true, .centre = "pose/transform/center"}},
    {"OpenSfM",
     "cameras shots",
     {},
     openSfmShots,
     readOpenSfmLens,
     {.pose = "rotation", .count = 3, .at = "translation"}},
    {"OpenSfM",
     "projection_type focal|focal_x width", // camera_models.json
     {},
     [](Reading &, const Node &file) {
         Cameras lenses;
         for (const auto &[name, lens] : file.index("", ""))
             lenses.push_back({name, {}, {}, lens, lens});
         return lenses;
     },
     readOpenSfmLens},
    // Source: nerfstudio, cameras/camera_paths.py; viewer/render_panel.py for its key frames.
    {"Nerfstudio",
     "camera_path render_height",
     kOpenGl,
     nullptr,
     readPathLens,
     {.list = "camera_path|keyframes",
      .pose = "camera_to_world|matrix",
      .note = marked("Coordinates are those of Nerfstudio's viewer: its data parser moved and scaled the "
                     "world, as dataparser_transforms.json tells.")}},
    {"BOP",
     "cam_K",
     {},
     bopImages,
     readBop,
     {.isLax = true, .size = "width height", .lens = "cam_K", .note = kWholeCentres}},
    kBopLens,
    {"BOP", "cam_R_m2c", {}, bopObjects},

    // Source: nuscenes-devkit, docs/schema_nuscenes.md
    {"nuScenes",
     "sensor_token camera_intrinsic translation rotation",
     {CameraToWorld},
     nullptr,
     [](Reading &reading) { reading.say(tr("The world is the vehicle's frame, in metres; ego_pose is not applied.")); },
     {.list = "*",
      .name = "token",
      .id = "sensor_token",
      .having = "camera_intrinsic", // of a lidar or radar it is empty
      .lens = "camera_intrinsic",
      .pose = "rotation",
      .count = 4,
      .at = "translation",
      .note = kWholeCentres}},

    // Source: polyform, README.md: t_ij by rows, ARKit's axes
    {"Polycam",
     "t_00 t_23 fx",
     kOpenGl,
     nullptr,
     nullptr,
     {.centres = AtHalves,
      .size = "width height",
      .lens = "fx fy cx cy",
      .pose = "t_00 t_01 t_02 t_03 t_10 t_11 t_12 t_13 t_20 t_21 t_22 t_23",
      .count = 12,
      .note = kArKit}},

    // A frame of 3D Scanner App. Its programs on GitHub reshape both matrices by rows.
    {"ARKit",
     "cameraPoseARFrame intrinsics",
     kOpenGl,
     nullptr,
     nullptr,
     {.centres = AtHalves, .lens = "intrinsics", .pose = "cameraPoseARFrame", .note = kArKit}},
    {"Record3D",
     "poses K w h",
     kOpenGl,
     recordedFrames,
     readRecordedLens,
     {.isLax = true, .centres = AtHalves, .size = "w h", .lens = "K", .pose = "", .count = 7, .note = kArKit}},
    {"three.js",
     "type matrix PerspectiveCamera|OrthographicCamera",
     kOpenGl,
     threeCameras,
     readThreeLens,
     {.planes = "near far", .pose = "matrix", .isByColumns = true}},
    {"Human3.6M",
     "intrinsics extrinsics calibration_matrix",
     {},
     humanCameras,
     nullptr,
     {.lens = "calibration_matrix", .pose = "R", .count = 9, .at = "t", .distortion = "distortion"}},
    {"fSpy",
     "cameraTransform relativeFocalLength imageWidth",
     kOpenGl,
     nullptr,
     readFspyLens,
     {.list = "cameraParameters|*",
      .having = "cameraTransform",
      .size = "imageWidth imageHeight",
      .pose = "cameraTransform/rows"}},

    // Source: NVISII, as Deep_Object_Pose, data_generation, writes it: the rows of camera_view_matrix are
    // columns, so eye, at and up count
    {"NVISII",
     "camera_data camera_look_at intrinsics",
     kOpenGl,
     nullptr,
     readDopePose,
     {.centres = AtHalves,
      .list = "camera_data",
      .having = "camera_look_at",
      .size = "width height",
      .lens = "intrinsics/fx intrinsics/fy intrinsics/cx intrinsics/cy"}},

    // Source: lgsvl/simulator, Assets/Scripts/Sensors, CameraSensorBase.cs: FieldOfView is that of Unity's camera
    {"LGSVL",
     "FieldOfView transform pitch",
     {CameraToWorld, RightUpAhead},
     nullptr,
     readLgsvl,
     {.list = "sensors|*",
      .name = "name",
      .having = "params/FieldOfView",
      .size = "params/Width params/Height",
      .planes = "params/MinDistance params/MaxDistance"}},
    // Source: pymvg, camera_model.py: Q is the rotation, R rectifies
    {"PyMVG",
     "__pymvg_file_version__ camera_system",
     {},
     nullptr,
     nullptr,
     {.list = "camera_system",
      .name = "name",
      .size = "width height",
      .lens = "K",
      .pose = "Q",
      .count = 9,
      .at = "translation",
      .distortion = "D",
      .note = kWholeCentres}},
    {"NeRF",
     "transform_matrix|fl_x|camera_angle_x",
     kOpenGl,
     nerfFrames,
     readNerf,
     {.mayBePart = true, .pose = "transform_matrix"}},
    {"Open3D", "class_name|intrinsic_matrix", {}, open3dCameras, readOpen3d},
    {"glTF", "cameras asset", kOpenGl, gltfCameras, readGltf},
    {"Gaussian splatting",
     "img_name position rotation",
     {CameraToWorld},
     nullptr,
     readSplatting,
     {.list = "*", .name = "img_name", .size = "width height"}}};

} // namespace

std::span<const Form> jsonForms()
{
    return kForms;
}

} // namespace unprojector::cameras
