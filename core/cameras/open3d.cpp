#include "core/base/translation.h"
#include "core/cameras/camera_json.h"
#include "core/cameras/camera_reader.h"
#include "core/geometry/numbers.h"
#include "core/geometry/projection.h"

#include <nlohmann/json.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

// Open3D's JSON: PinholeCameraParameters, PinholeCameraTrajectory, PinholeCameraIntrinsic, and
// ViewTrajectory, which its viewer copies to the clipboard.

namespace unprojector::cameras {
using namespace geometry;
using base::tr;
using Json = nlohmann::ordered_json;

namespace {

constexpr std::array kKinds{"PinholeCameraParameters", "PinholeCameraTrajectory", "PinholeCameraIntrinsic",
                            "ViewTrajectory"};

/// Fails in the line of a key of the chosen camera.
[[noreturn]] void failAtKey(const Reading &reading, const char *key, std::string reason)
{
    reading.fail(std::move(reason), lineOfKey(reading.text.text, key, reading.camera.image));
}

void readPinhole(Reading &reading, const Json &parameters, const std::string &kind)
{
    ForeignCamera &camera = reading.camera;
    const bool isLensAlone = kind == "PinholeCameraIntrinsic";
    const Json *lens = isLensAlone ? &parameters : memberOf(parameters, "intrinsic");
    if (lens == nullptr)
        failAtKey(reading, "extrinsic", tr("there is no intrinsic; give the focal length there"));
    const std::vector<double> k = neededNumbers(reading, *lens, "intrinsic_matrix", 9); // by columns
    camera.intrinsics = Intrinsics{k[0], k[4], k[6], k[7], k[3], PixelCentres::AtIntegers};
    camera.size = sizeOf(numberOf(*lens, "width"), numberOf(*lens, "height"));
    if (!isLensAlone)
        camera.pose = matrixByColumns(neededNumbers(reading, parameters, "extrinsic", 16));
}

/// The camera of Open3D's viewer, as its ViewControl computes it.
void readView(Reading &reading, const Json &view)
{
    ForeignCamera &camera = reading.camera;
    const auto point = [&](const char *key) { return neededVector(reading, view, key); };
    const glm::dvec3 lowest = point("boundingbox_min"), extents = point("boundingbox_max") - lowest,
                     front = point("front"), center = point("lookat"), up = point("up");
    const auto degrees = numberOf(view, "field_of_view"), zoom = numberOf(view, "zoom");
    if (!degrees || !zoom)
        failAtKey(reading, "zoom", tr("field_of_view and zoom need a number each"));
    const std::string noDistance = tr("the bounding box, zoom and field_of_view give no distance; all must be above 0");
    const double extent = std::max({extents.x, extents.y, extents.z}), half = *zoom * extent;
    const double distance = half / std::tan(radiansFromDegrees(*degrees) / 2.0);
    if (!(extent > 0.0) || !(distance > 0.0))
        failAtKey(reading, "zoom", noDistance);
    camera.pose = looking(center + distance * front / glm::length(front), front, up);
    if (!camera.pose)
        failAtKey(reading, "front", tr("front and up are parallel or 0; they give no axes"));
    camera.direction = PoseDirection::CameraToWorld;
    camera.axes = EyeAxes::RightUpBack;
    const double nearDistance = distance - 3.0 * extent, farDistance = distance + 3.0 * extent;
    camera.farDistance = farDistance;
    camera.nearDistance = std::max(0.01 * extent, nearDistance);
    constexpr double kOrthographic = 5.0; // this angle stands for a parallel projection
    if (*degrees != kOrthographic) {
        reading.setVerticalAngle(radiansFromDegrees(*degrees));
        return;
    }
    const ImageSize size = reading.neededSize();
    const double aspect = double(size.width) / size.height;
    const Ortho box{-aspect * half, aspect * half, -half, half, nearDistance, farDistance};
    if (!check(Projection(box)))
        failAtKey(reading, "zoom", noDistance);
    reading.setProjection(box, 0);
}

} // namespace

bool readOpen3d(Reading &reading)
{
    const std::string &text = reading.text.text;
    const auto has = [&text](const char *word) { return text.find(word) != text.npos; };
    const auto hasKind = [&text](const char *kind) { return text.find('"' + std::string(kind) + '"') != text.npos; };
    // The name of the class is missing where someone copied the middle of a file.
    const bool isNamed = has("\"class_name\"") && std::any_of(kKinds.begin(), kKinds.end(), hasKind);
    if (!isJson(text) || !(isNamed || has("\"intrinsic_matrix\"")))
        return false;
    const Json file = parsedJson(reading.text);
    const Json *name = memberOf(file, "class_name");
    std::string kind = name && name->is_string() ? name->get<std::string>() : "PinholeCameraParameters";
    if (!name && memberOf(file, "intrinsic_matrix"))
        kind = "PinholeCameraIntrinsic";
    if (std::find(kKinds.begin(), kKinds.end(), kind) == kKinds.end())
        return false;
    reading.begin("Open3D", PoseDirection::WorldToCamera, EyeAxes::RightDownAhead);
    const bool isView = kind == "ViewTrajectory";
    const char *key = isView ? "trajectory" : "parameters";
    const Json *list = memberOf(file, key), *one = &file;
    if (list) {
        if (!list->is_array() || list->empty())
            failAtKey(reading, key, tr("there are no cameras"));
        for (std::size_t i = 0; i < list->size(); ++i)
            reading.camera.images.push_back(std::to_string(i));
        reading.chooseImage();
        one = &(*list)[reading.camera.image];
    }
    isView ? readView(reading, *one) : readPinhole(reading, *one, kind);
    return true;
}

} // namespace unprojector::cameras
