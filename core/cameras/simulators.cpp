#include "core/base/translation.h"
#include "core/cameras/camera_reader.h"
#include "core/cameras/reader_parts.h"
#include "core/geometry/error_text.h"
#include "core/geometry/numbers.h"
#include "core/geometry/projection.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <span>
#include <utility>

// MuJoCo, PyBullet and SAPIEN. Their eye axes are OpenGL's, if not named otherwise.

namespace unprojector::cameras {
using namespace geometry;
using base::tr;

namespace {

ForeignCamera cameraOf(const char *program, PoseDirection direction)
{
    ForeignCamera camera;
    camera.program = program;
    camera.direction = direction;
    camera.axes = EyeAxes::RightUpBack;
    camera.isDirectionCertain = camera.areAxesCertain = true;
    return camera;
}

/// One or all cameras of mjData: cam_xpos, cam_xmat by rows, and mjModel's cam_fovy in degrees.
Result<ForeignCamera, CameraError> readData(const NamedText &text, const NamedValues &values,
                                            const CameraChoices &choices)
{
    ForeignCamera camera = cameraOf("MuJoCo", PoseDirection::CameraToWorld);
    const std::vector<double> axes = values.numbers({"camxmat", "xmat"}, 9),
                              positions = values.numbers({"camxpos", "xpos"}, 3),
                              angles = values.numbers({"camfovy", "fovy"}, 1);
    const std::size_t count = axes.size() / 9;
    const auto fault = [&](const char *name, std::string reason) {
        const NamedValue *value = values.find({name});
        return CameraError{text.name, value ? value->line : 0, std::move(reason)};
    };
    if (count == 0 || axes.size() != 9 * count)
        return fault("xmat", tr("cam_xmat needs 9 numbers a camera; it has %1", axes.size()));
    if (positions.size() != 3 * count)
        return fault("xpos", tr("%1 needs %2 numbers; it has %3", "cam_xpos", 3 * count, positions.size()));
    if (angles.size() != count)
        return fault("fovy", tr("%1 needs %2 numbers; it has %3", "cam_fovy", count, angles.size()));
    for (std::size_t i = 0; count > 1 && i < count; ++i)
        camera.images.push_back(std::to_string(i));
    if (count > 1) {
        if (auto error = chooseImage(camera, choices, text.name))
            return *error;
    }
    const std::size_t i = camera.image;
    camera.pose = matrixByRows(std::span(axes).subspan(9 * i, 9));
    (*camera.pose)[3] = glm::dvec4(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2], 1.0);
    camera.size = sizeIn(values);
    // The planes are given as shares of the model's extent.
    const auto extent = values.number({"extent"}), nearShare = values.number({"znear"}),
               farShare = values.number({"zfar"});
    if (extent && nearShare)
        camera.nearDistance = *nearShare * *extent;
    if (extent && farShare)
        camera.farDistance = *farShare * *extent;
    if (auto error = setVerticalAngle(camera, choices, radiansFromDegrees(angles[i]), {}, text.name))
        return *error;
    return camera;
}

/// mjvGLCamera: pos, forward, up and the frustum at its near plane.
Result<ForeignCamera, CameraError> readGlCamera(const NamedText &text, const NamedValues &values,
                                                const CameraChoices &choices)
{
    ForeignCamera camera = cameraOf("MuJoCo", PoseDirection::CameraToWorld);
    const auto point = [&values](const char *name) -> std::optional<glm::dvec3> {
        const std::vector<double> v = values.numbers({name}, 3, {"x", "y", "z"});
        return v.size() == 3 ? std::optional(glm::dvec3(v[0], v[1], v[2])) : std::nullopt;
    };
    const auto eye = point("pos"), forward = point("forward"), up = point("up");
    const auto bottom = values.number({"frustumbottom"}), top = values.number({"frustumtop"}),
               nearDistance = values.number({"frustumnear"}), farDistance = values.number({"frustumfar"});
    if (!eye || !forward || !up || !bottom || !top || !nearDistance || !farDistance)
        return CameraError{text.name, 0,
                           tr("mjvGLCamera needs pos, forward, up, frustum_bottom, frustum_top, frustum_near and "
                              "frustum_far; one of them is missing")};
    camera.pose = looking(*eye, -*forward, *up);
    if (!camera.pose)
        return CameraError{text.name, 0, tr("forward and up are parallel or 0; they give no axes")};
    camera.size = sizeIn(values);
    const double center = values.number({"frustumcenter"}).value_or(0.0);
    double half = values.number({"frustumwidth"}).value_or(0.0);
    if (half == 0.0) { // the width follows the viewport
        const std::optional<ImageSize> size = sizeOf(camera, choices);
        if (!size)
            return noSize(text.name);
        half = 0.5 * size->width / size->height * (*top - *bottom);
    }
    const Frustum frustum{center - half, center + half, *bottom, *top, *nearDistance, *farDistance};
    const Ortho box{frustum.left, frustum.right, *bottom, *top, *nearDistance, *farDistance};
    const Result<glm::dmat4> clip = clipFromEye(values.isTrue("orthographic") ? Projection(box) : Projection(frustum));
    if (!clip)
        return CameraError{text.name, 0, geometry::errorText(clip.error())};
    camera.projection = MatrixProjection{*clip, NdcDepth::MinusOneToOne};
    return camera;
}

} // namespace

CameraRead readMujoco(std::span<const NamedText> texts, const CameraChoices &choices)
{
    const auto has = [](const std::string &text, const char *word) { return text.find(word) != text.npos; };
    const NamedText *text = firstWith(texts, [&](const std::string &one) {
        return has(one, "xmat") || (has(one, "frustum_near") && has(one, "frustum_top"));
    });
    if (text == nullptr)
        return std::nullopt;
    const NamedValues values(text->text);
    if (values.has({"camxmat", "xmat"}))
        return readData(*text, values, choices);
    if (values.has({"frustumnear"}) && values.has({"frustumtop"}))
        return readGlCamera(*text, values, choices);
    return std::nullopt;
}

CameraRead readPyBullet(std::span<const NamedText> texts, const CameraChoices & /*choices*/)
{
    constexpr std::size_t kVisualizer = 52; // width, height, view, projection and what follows from them
    constexpr std::size_t kView = 2, kProjection = 18, kEntries = 16;
    for (const NamedText &text : texts) {
        const NamedValues values(text.text);
        ForeignCamera camera = cameraOf("PyBullet", PoseDirection::WorldToCamera);
        for (const NamedValue &value : values.all()) {
            const std::span<const double> n = value.numbers;
            if (n.size() != kVisualizer || n[kView + 15] != 1.0 || n[kProjection + 11] != -1.0)
                continue;
            camera.size = sizeOf(n[0], n[1]);
            camera.pose = matrixByColumns(n.subspan(kView, kEntries));
            camera.projection =
                MatrixProjection{*matrixByColumns(n.subspan(kProjection, kEntries)), NdcDepth::MinusOneToOne};
            return camera;
        }
        const bool isNamed = text.text.find("pybullet") != text.text.npos
                             || text.text.find("PyBullet") != text.text.npos
                             || text.text.find("computeViewMatrix") != text.text.npos;
        const auto view = matrixByColumns(
            values.numbers({"computeviewmatrix", "computeviewmatrixfromyawpitchroll", "viewmatrix", "view"}, kEntries));
        const auto projection = matrixByColumns(values.numbers(
            {"computeprojectionmatrixfov", "computeprojectionmatrix", "projectionmatrix", "projmatrix", "projection"},
            kEntries));
        if (!isNamed || !view || !projection)
            continue;
        camera.size = sizeIn(values);
        camera.pose = view;
        camera.projection = MatrixProjection{*projection, NdcDepth::MinusOneToOne};
        return camera;
    }
    return std::nullopt;
}

CameraRead readSapien(std::span<const NamedText> texts, const CameraChoices & /*choices*/)
{
    for (const NamedText &text : texts) {
        const NamedValues values(text.text);
        const auto extrinsic = matrixByRows(values.numbers({"extrinsiccv"}, 12)),
                   pose = matrixByRows(values.numbers({"cam2worldgl"}, 12));
        const std::vector<double> k = values.numbers({"intrinsiccv", "intrinsic", "k"}, 9);
        const auto lens = matrixByRows(values.numbers({"projectionmatrix", "projection"}, 16));
        if ((!extrinsic && !pose) || (k.size() != 9 && !lens))
            continue;
        ForeignCamera camera =
            cameraOf("SAPIEN", extrinsic ? PoseDirection::WorldToCamera : PoseDirection::CameraToWorld);
        camera.axes = extrinsic ? EyeAxes::RightDownAhead : EyeAxes::RightUpBack;
        camera.pose = extrinsic ? extrinsic : pose;
        camera.size = sizeIn(values);
        if (k.size() == 9)
            camera.intrinsics = Intrinsics{k[0], k[4], k[2], k[5], k[1], PixelCentres::AtHalves};
        else
            camera.projection = MatrixProjection{*lens, NdcDepth::MinusOneToOne};
        return camera;
    }
    return std::nullopt;
}

} // namespace unprojector::cameras
