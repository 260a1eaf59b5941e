#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/cameras/camera_reader.h"
#include "core/geometry/numbers.h"
#include "core/geometry/projection.h"

#include <algorithm>
#include <cmath>
#include <string_view>

// Blender's camera, as its Python console prints it.

namespace unprojector::cameras {
using namespace geometry;
using base::tr;

namespace {

/// Returns whether any type is this one: the object's own type, CAMERA, may stand before its camera's.
bool hasType(const NamedValues &values, std::string_view type)
{
    const std::vector<NamedValue> &all = values.all();
    return std::any_of(all.begin(), all.end(),
                       [type](const NamedValue &value) { return value.isNamed("type") && value.word == type; });
}

void readPose(Reading &reading)
{
    const NamedValues &values = reading.values();
    ForeignCamera &camera = reading.camera;
    const std::vector<double> matrix = values.numbers({"matrixworld", "worldmatrix"}, 1);
    const std::vector<double> &unnamed = values.all().front().numbers;
    if (!matrix.empty() || unnamed.size() == 16) {
        camera.pose = matrixByRows(matrix.empty() ? unnamed : matrix);
        if (matrix.size() == 9 || !camera.pose)
            reading.failAt("matrixworld", tr("%1 needs %2 numbers; it has %3", "matrix_world", 16, matrix.size()));
        return;
    }
    const std::vector<double> angles = values.numbers({"rotationeuler"}, 3), at = values.numbers({"location"}, 3);
    if (angles.size() != 3 || at.size() != 3)
        reading.failAt("rotationeuler",
                       tr("the camera's matrix_world is missing; give it, or location and rotation_euler"));
    for (const char *order : {"XZY", "YXZ", "YZX", "ZXY", "ZYX"}) {
        if (reading.text.text.find(order) != std::string::npos)
            reading.failAt("rotationeuler", tr("Euler angles in the order %1 are not read; give matrix_world", order));
    }
    // About x, then y, then z.
    camera.pose = rigid(about(2, angles[2]) * about(1, angles[1]) * about(0, angles[0]), {at[0], at[1], at[2]});
    camera.assumed.push_back(tr("%1 and %2 count as the camera's pose in the world, as for a camera without parent. "
                                "Give %3 if it has one.",
                                "location", "rotation_euler", "matrix_world"));
}

/// In pixels of width.
std::optional<double> focalLength(Reading &reading, const std::string &fit, bool isVertical, double side)
{
    const NamedValues &values = reading.values();
    if (const auto lens = values.number({"lens"})) {
        constexpr double kWidth = 36.0, kHeight = 24.0; // of a new camera's sensor, mm
        const bool isByHeight = fit == "VERTICAL";
        const auto given = values.number({isByHeight ? "sensorheight" : "sensorwidth"});
        if (!given)
            reading.camera.assumed.push_back(tr(isByHeight
                                                    ? "The sensor is assumed to be 24 mm high, because sensor_height "
                                                      "is missing. Add it to say otherwise."
                                                    : "The sensor is assumed to be 36 mm wide, because sensor_width "
                                                      "is missing. Add it to say otherwise."));
        return *lens * side / given.value_or(isByHeight ? kHeight : kWidth);
    }
    const auto half = [](double radians) { return 2.0 * std::tan(radians / 2.0); };
    if (const auto angle = values.number({"angle"}); angle && *angle > 0.0 && *angle < kPi)
        return side / half(*angle);
    if (const auto angle = values.number({"anglex"}); angle && !isVertical && *angle > 0.0 && *angle < kPi)
        return reading.neededSize().width / half(*angle);
    return std::nullopt;
}

/// The lens, as Blender computes its view plane: the sensor's side that fits the image's.
void readLens(Reading &reading)
{
    const NamedValues &values = reading.values();
    ForeignCamera &camera = reading.camera;
    const ImageSize size = reading.neededSize();
    const auto number = [&values](const char *name, double otherwise) {
        return values.number({name}).value_or(otherwise);
    };
    const double aspectX = number("pixelaspectx", 1.0), aspectY = number("pixelaspecty", 1.0);
    const NamedValue *given = values.find({"sensorfit"});
    const std::string fit = given ? given->word : "AUTO";
    const double width = size.width, height = size.height, tall = aspectY / aspectX;
    const bool isVertical = fit == "VERTICAL" || (fit != "HORIZONTAL" && width * aspectX < height * aspectY);
    const double side = isVertical ? tall * height : width; // Blender's "view factor", in pixels
    const double shiftX = number("shiftx", 0.0) * side, shiftY = number("shifty", 0.0) * side / tall;
    if (hasType(values, "PANO"))
        reading.failAt("type", tr("a panoramic camera has no projection matrix; only PERSP and ORTHO are read"));
    if (hasType(values, "ORTHO")) {
        const auto scale = values.number({"orthoscale"});
        if (!scale || !camera.nearDistance || !camera.farDistance)
            reading.failAt("type", tr("an orthographic camera needs ortho_scale, clip_start and clip_end"));
        const double pixel = *scale / side;
        reading.setProjection(Ortho{pixel * (shiftX - width / 2.0), pixel * (shiftX + width / 2.0),
                                    pixel * tall * (shiftY - height / 2.0), pixel * tall * (shiftY + height / 2.0),
                                    *camera.nearDistance, *camera.farDistance},
                              values.find({"type"})->line);
        return;
    }
    if (const auto lens = values.number({"lens"}); lens && !(*lens > 0.0))
        reading.failAt("lens", tr("%1 is %2; it must be greater than 0", "lens", base::shortestText(*lens)));
    const std::optional<double> focal = focalLength(reading, fit, isVertical, side);
    if (!focal)
        reading.failAt("lens", tr("the focal length is missing; give lens in millimetres or angle in radians"));
    camera.intrinsics = Intrinsics{
        *focal, *focal / tall, width / 2.0 - shiftX, height / 2.0 + shiftY, 0.0, PixelCentres::AtHalves, true};
}

} // namespace

bool readBlender(Reading &reading)
{
    const NamedValues &values = reading.values();
    const std::string &text = reading.text.text;
    const bool hasPose = values.has({"matrixworld", "rotationeuler"}) || text.find("<Matrix 4x4") != text.npos
                         || text.find("Matrix(((") != text.npos;
    if (!hasPose || !values.has({"lens", "angle", "anglex", "orthoscale", "sensorwidth", "shiftx"}))
        return false;
    ForeignCamera &camera = reading.camera;
    reading.begin("Blender", PoseDirection::CameraToWorld, EyeAxes::RightUpBack);
    camera.nearDistance = values.number({"clipstart"});
    camera.farDistance = values.number({"clipend"});
    readPose(reading);
    // The product of whole numbers is exact: 720 * 70 / 100 is 504, but 720 * 0.7 is less.
    const double percent = values.number({"resolutionpercentage"}).value_or(100.0);
    const auto scaled = [percent](std::optional<double> pixels) {
        return pixels ? std::optional(std::floor(*pixels * percent / 100.0)) : std::nullopt;
    };
    camera.size = sizeOf(scaled(values.number({"resolutionx"})), scaled(values.number({"resolutiony"})));
    if (!camera.size)
        camera.size = sizeIn(values);
    readLens(reading);
    return true;
}

} // namespace unprojector::cameras
