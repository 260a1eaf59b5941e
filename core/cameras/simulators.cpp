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

/// One or all cameras of mjData: cam_xpos, cam_xmat by rows, and mjModel's cam_fovy in degrees.
void readData(Reading &reading)
{
    const NamedValues &values = reading.values();
    ForeignCamera &camera = reading.camera;
    const std::vector<double> axes = values.numbers({"camxmat", "xmat"}, 9),
                              positions = values.numbers({"camxpos", "xpos"}, 3),
                              angles = values.numbers({"camfovy", "fovy"}, 1);
    const std::size_t count = axes.size() / 9;
    if (count == 0 || axes.size() != 9 * count)
        reading.failAt("xmat", tr("cam_xmat needs 9 numbers a camera; it has %1", axes.size()));
    if (positions.size() != 3 * count)
        reading.failAt("xpos", tr("%1 needs %2 numbers; it has %3", "cam_xpos", 3 * count, positions.size()));
    if (angles.size() != count)
        reading.failAt("fovy", tr("%1 needs %2 numbers; it has %3", "cam_fovy", count, angles.size()));
    for (std::size_t i = 0; count > 1 && i < count; ++i)
        camera.images.push_back(std::to_string(i));
    if (count > 1)
        reading.chooseImage();
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
    reading.setVerticalAngle(radiansFromDegrees(angles[i]));
}

/// mjvGLCamera: pos, forward, up and the frustum at its near plane.
void readGlCamera(Reading &reading)
{
    const NamedValues &values = reading.values();
    ForeignCamera &camera = reading.camera;
    const auto point = [&values](const char *name) -> std::optional<glm::dvec3> {
        const std::vector<double> v = values.numbers({name}, 3, {"x", "y", "z"});
        return v.size() == 3 ? std::optional(glm::dvec3(v[0], v[1], v[2])) : std::nullopt;
    };
    const auto eye = point("pos"), forward = point("forward"), up = point("up");
    const auto bottom = values.number({"frustumbottom"}), top = values.number({"frustumtop"}),
               nearDistance = values.number({"frustumnear"}), farDistance = values.number({"frustumfar"});
    if (!eye || !forward || !up || !bottom || !top || !nearDistance || !farDistance)
        reading.fail(tr("mjvGLCamera needs pos, forward, up, frustum_bottom, frustum_top, frustum_near and "
                        "frustum_far; one of them is missing"));
    camera.pose = looking(*eye, -*forward, *up);
    if (!camera.pose)
        reading.fail(tr("forward and up are parallel or 0; they give no axes"));
    camera.size = sizeIn(values);
    const double center = values.number({"frustumcenter"}).value_or(0.0);
    double half = values.number({"frustumwidth"}).value_or(0.0);
    if (half == 0.0) { // the width follows the viewport
        const ImageSize size = reading.neededSize();
        half = 0.5 * size.width / size.height * (*top - *bottom);
    }
    const Frustum frustum{center - half, center + half, *bottom, *top, *nearDistance, *farDistance};
    const Ortho box{frustum.left, frustum.right, *bottom, *top, *nearDistance, *farDistance};
    reading.setProjection(values.isTrue("orthographic") ? Projection(box) : Projection(frustum), 0);
}

} // namespace

bool readMujoco(Reading &reading)
{
    const std::string &text = reading.text.text;
    const auto has = [&text](const char *word) { return text.find(word) != text.npos; };
    if (!has("xmat") && !(has("frustum_near") && has("frustum_top")))
        return false;
    const NamedValues &values = reading.values();
    const bool isData = values.has({"camxmat", "xmat"});
    if (!isData && !(values.has({"frustumnear"}) && values.has({"frustumtop"})))
        return false;
    reading.begin("MuJoCo", PoseDirection::CameraToWorld, EyeAxes::RightUpBack);
    isData ? readData(reading) : readGlCamera(reading);
    return true;
}

bool readPyBullet(Reading &reading)
{
    constexpr std::size_t kVisualizer = 52; // width, height, view, projection and what follows from them
    constexpr std::size_t kView = 2, kProjection = 18, kEntries = 16;
    const NamedValues &values = reading.values();
    ForeignCamera &camera = reading.camera;
    const auto take = [&](const glm::dmat4 &view, const glm::dmat4 &projection, std::optional<ImageSize> size) {
        reading.begin("PyBullet", PoseDirection::WorldToCamera, EyeAxes::RightUpBack);
        camera.size = size;
        camera.pose = view;
        camera.projection = MatrixProjection{projection, NdcDepth::MinusOneToOne};
        return true;
    };
    for (const NamedValue &value : values.all()) {
        const std::span<const double> n = value.numbers;
        if (n.size() == kVisualizer && n[kView + 15] == 1.0 && n[kProjection + 11] == -1.0)
            return take(*matrixByColumns(n.subspan(kView, kEntries)),
                        *matrixByColumns(n.subspan(kProjection, kEntries)), sizeOf(n[0], n[1]));
    }
    const std::string &text = reading.text.text;
    const bool isNamed = text.find("pybullet") != text.npos || text.find("PyBullet") != text.npos
                         || text.find("computeViewMatrix") != text.npos;
    const auto view = matrixByColumns(
        values.numbers({"computeviewmatrix", "computeviewmatrixfromyawpitchroll", "viewmatrix", "view"}, kEntries));
    const auto projection = matrixByColumns(values.numbers(
        {"computeprojectionmatrixfov", "computeprojectionmatrix", "projectionmatrix", "projmatrix", "projection"},
        kEntries));
    return isNamed && view && projection && take(*view, *projection, sizeIn(values));
}

bool readSapien(Reading &reading)
{
    const NamedValues &values = reading.values();
    const auto extrinsic = matrixByRows(values.numbers({"extrinsiccv"}, 12)),
               pose = matrixByRows(values.numbers({"cam2worldgl"}, 12));
    const std::vector<double> k = values.numbers({"intrinsiccv", "intrinsic", "k"}, 9);
    const auto lens = matrixByRows(values.numbers({"projectionmatrix", "projection"}, 16));
    if ((!extrinsic && !pose) || (k.size() != 9 && !lens))
        return false;
    ForeignCamera &camera = reading.camera;
    if (extrinsic)
        reading.begin("SAPIEN", PoseDirection::WorldToCamera, EyeAxes::RightDownAhead);
    else
        reading.begin("SAPIEN", PoseDirection::CameraToWorld, EyeAxes::RightUpBack);
    camera.pose = extrinsic ? extrinsic : pose;
    camera.size = sizeIn(values);
    if (k.size() == 9)
        camera.intrinsics = Intrinsics{k[0], k[4], k[2], k[5], k[1], PixelCentres::AtHalves};
    else
        camera.projection = MatrixProjection{*lens, NdcDepth::MinusOneToOne};
    return true;
}

} // namespace unprojector::cameras
