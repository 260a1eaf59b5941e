#include "core/base/translation.h"
#include "core/cameras/camera_json.h"
#include "core/cameras/camera_reader.h"
#include "core/cameras/reader_parts.h"
#include "core/matrices/decomposition.h"

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

ForeignCamera cameraOf(PoseDirection direction)
{
    ForeignCamera camera;
    camera.program = "Gaussian splatting";
    camera.direction = direction;
    camera.axes = EyeAxes::RightDownAhead;
    camera.isDirectionCertain = camera.areAxesCertain = true;
    return camera;
}

/// A list of {img_name, width, height, position, rotation, fx, fy}.
Result<ForeignCamera, CameraError> readList(const NamedText &text, const Json &list, const CameraChoices &choices)
{
    ForeignCamera camera = cameraOf(PoseDirection::CameraToWorld);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Json *name = memberOf(list[i], "img_name");
        camera.images.push_back(name && name->is_string() ? name->get<std::string>() : std::to_string(i));
    }
    if (auto error = chooseImage(camera, choices, text.name))
        return *error;
    const Json &one = list[camera.image];
    const Json *at = memberOf(one, "position"), *axes = memberOf(one, "rotation");
    const auto position = at ? numbersOf(*at) : std::nullopt, rotation = axes ? numbersOf(*axes) : std::nullopt;
    const auto fx = numberOf(one, "fx"), fy = numberOf(one, "fy");
    camera.size = sizeOf(numberOf(one, "width"), numberOf(one, "height"));
    if (!position || position->size() != 3 || !rotation || rotation->size() != 9 || !fx || !fy || !camera.size)
        return CameraError{text.name, lineOfKey(text.text, "id", camera.image),
                           tr("the camera needs position, rotation, fx, fy, width and height; one of them is missing")};
    camera.pose = matrixByRows(*rotation);
    (*camera.pose)[3] = glm::dvec4((*position)[0], (*position)[1], (*position)[2], 1.0);
    camera.intrinsics =
        Intrinsics{*fx, *fy, camera.size->width / 2.0, camera.size->height / 2.0, 0.0, PixelCentres::AtHalves, true};
    return camera;
}

/// Scales an axis by -1.
glm::dmat4 turned(bool y, bool z)
{
    glm::dmat4 m(1.0);
    m[1][1] = y ? -1.0 : 1.0;
    m[2][2] = z ? -1.0 : 1.0;
    return m;
}

/// OpenGL's projection from that of splatting: y up, and an eye that looks along -z.
MatrixProjection projectionOf(const glm::dmat4 &clipFromCamera)
{
    return {turned(true, false) * clipFromCamera * turned(true, true), NdcDepth::ZeroToOne};
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

Result<ForeignCamera, CameraError> readMatrices(const NamedText &text, const NamedValues &values,
                                                const CameraChoices &choices)
{
    ForeignCamera camera = cameraOf(PoseDirection::WorldToCamera);
    camera.size = sizeIn(values);
    camera.nearDistance = values.number({"znear"});
    camera.farDistance = values.number({"zfar"});
    const auto matrix = [&values](std::initializer_list<std::string_view> names) {
        return matrixByColumns(values.numbers(names, 16));
    };
    const auto view = matrix({"worldviewtransform"}), product = matrix({"fullprojtransform"}),
               lens = matrix({"projectionmatrix"});
    const auto angleX = values.number({"fovx"}), angleY = values.number({"fovy"});
    camera.pose = view;
    if (view && lens) {
        camera.projection = projectionOf(*lens);
    } else if (view && product) {
        camera.projection = projectionOf(withoutNoise(*product * glm::inverse(*view)));
    } else if (view && angleX && angleY) {
        if (auto error = setVerticalAngle(camera, choices, *angleY, std::tan(*angleX / 2.0) / std::tan(*angleY / 2.0),
                                          text.name))
            return *error;
    } else if (product) {
        const auto apart = matrices::decomposed(turned(true, false) * *product);
        if (!apart)
            return CameraError{text.name, values.find({"fullprojtransform"})->line,
                               tr("full_proj_transform is not a perspective times a view; give world_view_transform "
                                  "too")};
        camera.pose = apart->eyeFromWorld;
        camera.axes = EyeAxes::RightUpBack;
        camera.projection = MatrixProjection{apart->clipFromEye, NdcDepth::ZeroToOne};
    } else {
        return CameraError{text.name, 0,
                           tr("world_view_transform needs 16 numbers, and full_proj_transform, projection_matrix or "
                              "FoVx and FoVy beside it")};
    }
    return camera;
}

} // namespace

CameraRead readSplatting(std::span<const NamedText> texts, const CameraChoices &choices)
{
    for (const NamedText &text : texts) {
        const auto has = [&text](const char *word) { return text.text.find(word) != text.text.npos; };
        if (isJson(text.text) && has("\"img_name\"") && has("\"position\"") && has("\"rotation\"")) {
            const auto json = parsedJson(text);
            if (!json)
                return json.error();
            if (json->is_array() && !json->empty())
                return readList(text, *json, choices);
        }
        if (has("world_view_transform") || has("full_proj_transform")) {
            const NamedValues values(text.text);
            if (values.has({"worldviewtransform", "fullprojtransform"}))
                return readMatrices(text, values, choices);
        }
    }
    return std::nullopt;
}

} // namespace unprojector::cameras
