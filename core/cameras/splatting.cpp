#include "core/base/translation.h"
#include "core/cameras/camera_json.h"
#include "core/cameras/camera_reader.h"
#include "core/pipeline/decomposition.h"

#include <nlohmann/json.hpp>

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

// 3-D Gaussian splatting: its cameras.json, and the printed matrices of its cameras. These are for
// row vectors, so they are written transposed. Eyes are OpenCV's, NDC's y points down, and depths
// are from 0 to 1.

namespace unprojector::cameras {
using namespace geometry;
using base::tr;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char *kProgram = "Gaussian splatting";

/// A list of {img_name, width, height, position, rotation, fx, fy}.
void readList(Reading &reading, const Json &list)
{
    ForeignCamera &camera = reading.camera;
    reading.begin(kProgram, PoseDirection::CameraToWorld, EyeAxes::RightDownAhead);
    for (std::size_t i = 0; i < list.size(); ++i)
        camera.images.push_back(nameOf(list[i], "img_name", i));
    reading.chooseImage();
    const Json &one = list[camera.image];
    const std::vector<double> position = numbersOf(one, "position"), rotation = numbersOf(one, "rotation");
    const auto fx = numberOf(one, "fx"), fy = numberOf(one, "fy");
    camera.size = sizeOf(numberOf(one, "width"), numberOf(one, "height"));
    if (position.size() != 3 || rotation.size() != 9 || !fx || !fy || !camera.size)
        reading.fail(tr("the camera needs position, rotation, fx, fy, width and height; one of them is missing"),
                     lineOfKey(reading.text.text, "id", camera.image));
    camera.pose = matrixByRows(rotation);
    (*camera.pose)[3] = glm::dvec4(position[0], position[1], position[2], 1.0);
    camera.intrinsics =
        Intrinsics{*fx, *fy, camera.size->width / 2.0, camera.size->height / 2.0, 0.0, PixelCentres::AtHalves, true};
}

/// Scales an axis by -1.
glm::dmat4 flipped(bool y, bool z)
{
    glm::dmat4 m(1.0);
    m[1][1] = y ? -1.0 : 1.0;
    m[2][2] = z ? -1.0 : 1.0;
    return m;
}

/// OpenGL's projection from that of splatting: y up, and an eye that looks along -z.
MatrixProjection projectionOf(const glm::dmat4 &clipFromCamera)
{
    return {flipped(true, false) * clipFromCamera * flipped(true, true), NdcDepth::ZeroToOne};
}

/// The matrix without the entries that are only the rounding of single precision.
glm::dmat4 withoutNoise(glm::dmat4 m)
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

void readMatrices(Reading &reading)
{
    const NamedValues &values = reading.values();
    ForeignCamera &camera = reading.camera;
    reading.begin(kProgram, PoseDirection::WorldToCamera, EyeAxes::RightDownAhead);
    camera.size = sizeIn(values);
    camera.nearDistance = values.number({"znear"});
    camera.farDistance = values.number({"zfar"});
    const auto matrix = [&values](const char *name) { return matrixByColumns(values.numbers({name}, 16)); };
    const auto view = matrix("worldviewtransform"), product = matrix("fullprojtransform"),
               lens = matrix("projectionmatrix");
    const auto angleX = values.number({"fovx"}), angleY = values.number({"fovy"});
    camera.pose = view;
    if (view && lens) {
        camera.projection = projectionOf(*lens);
    } else if (view && product) {
        camera.projection = projectionOf(withoutNoise(*product * glm::inverse(*view)));
    } else if (view && angleX && angleY) {
        reading.setVerticalAngle(*angleY, std::tan(*angleX / 2.0) / std::tan(*angleY / 2.0));
    } else if (product) {
        const auto apart = pipeline::decomposed(flipped(true, false) * *product);
        if (!apart)
            reading.failAt("fullprojtransform", tr("full_proj_transform is not a perspective times a view; give "
                                                   "world_view_transform too"));
        camera.pose = apart->eyeFromWorld;
        camera.axes = EyeAxes::RightUpBack;
        camera.projection = MatrixProjection{apart->clipFromEye, NdcDepth::ZeroToOne};
    } else {
        reading.fail(tr("world_view_transform needs 16 numbers, and full_proj_transform, projection_matrix or FoVx and "
                        "FoVy beside it"));
    }
}

} // namespace

bool readSplatting(Reading &reading)
{
    const std::string &text = reading.text.text;
    const auto has = [&text](const char *word) { return text.find(word) != text.npos; };
    if (isJson(text) && has("\"img_name\"") && has("\"position\"") && has("\"rotation\"")) {
        if (const Json json = parsedJson(reading.text); json.is_array() && !json.empty()) {
            readList(reading, json);
            return true;
        }
    }
    if (!(has("world_view_transform") || has("full_proj_transform"))
        || !reading.values().has({"worldviewtransform", "fullprojtransform"}))
        return false;
    readMatrices(reading);
    return true;
}

} // namespace unprojector::cameras
