#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/cameras/camera_reader.h"
#include "core/cameras/reader_parts.h"
#include "core/geometry/error_text.h"
#include "core/geometry/numbers.h"
#include "core/geometry/projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

// Blender's camera, as its Python console prints it.

namespace unprojector::cameras {
using namespace geometry;
using base::tr;

namespace {

class Reader {
public:
    Reader(const NamedText &text, const NamedValues &values, const CameraChoices &choices)
        : m_text(text), m_values(values), m_choices(choices)
    {
    }

    Result<ForeignCamera, CameraError> read()
    {
        m_camera.program = "Blender";
        m_camera.direction = PoseDirection::CameraToWorld;
        m_camera.axes = EyeAxes::RightUpBack;
        m_camera.isDirectionCertain = m_camera.areAxesCertain = true;
        m_camera.nearDistance = m_values.number({"clipstart"});
        m_camera.farDistance = m_values.number({"clipend"});
        if (auto error = readPose())
            return *error;
        // The product of whole numbers is exact: 720 * 70 / 100 is 504, but 720 * 0.7 is less.
        const double percent = m_values.number({"resolutionpercentage"}).value_or(100.0);
        const auto scaled = [percent](std::optional<double> pixels) {
            return pixels ? std::optional(std::floor(*pixels * percent / 100.0)) : std::nullopt;
        };
        m_camera.size = sizeOf(scaled(m_values.number({"resolutionx"})), scaled(m_values.number({"resolutiony"})));
        if (!m_camera.size)
            m_camera.size = sizeIn(m_values);
        if (auto error = readLens())
            return *error;
        return m_camera;
    }

private:
    CameraError fault(const char *name, std::string reason) const
    {
        const NamedValue *value = m_values.find({name});
        return {m_text.name, value ? value->line : 0, std::move(reason)};
    }

    /// Returns whether any type is this one: the object's own type, CAMERA, may stand before its
    /// camera's.
    bool hasType(std::string_view type) const
    {
        const std::vector<NamedValue> &all = m_values.all();
        return std::any_of(all.begin(), all.end(),
                           [type](const NamedValue &value) { return value.isNamed("type") && value.word == type; });
    }

    std::optional<CameraError> readPose()
    {
        const std::vector<double> matrix = m_values.numbers({"matrixworld", "worldmatrix"}, 1);
        const std::vector<double> &unnamed = m_values.all().front().numbers;
        if (!matrix.empty() || unnamed.size() == 16) {
            m_camera.pose = matrixByRows(matrix.empty() ? unnamed : matrix);
            if (matrix.size() == 9 || !m_camera.pose)
                return fault("matrixworld", tr("%1 needs %2 numbers; it has %3", "matrix_world", 16, matrix.size()));
            return std::nullopt;
        }
        const std::vector<double> angles = m_values.numbers({"rotationeuler"}, 3),
                                  at = m_values.numbers({"location"}, 3);
        if (angles.size() != 3 || at.size() != 3)
            return fault("rotationeuler", tr("the camera's matrix_world is missing; give it, or location and "
                                             "rotation_euler"));
        for (const char *order : {"XZY", "YXZ", "YZX", "ZXY", "ZYX"}) {
            if (m_text.text.find(order) != m_text.text.npos)
                return fault("rotationeuler",
                             tr("Euler angles in the order %1 are not read; give matrix_world", order));
        }
        // About x, then y, then z.
        m_camera.pose = rigid(about(2, angles[2]) * about(1, angles[1]) * about(0, angles[0]), {at[0], at[1], at[2]});
        m_camera.assumed.push_back(tr("%1 and %2 count as the camera's pose in the world, as for a camera without "
                                      "parent. Give %3 if it has one.",
                                      "location", "rotation_euler", "matrix_world"));
        return std::nullopt;
    }

    /// The lens, as Blender computes its view plane: the sensor's side that fits the image's.
    std::optional<CameraError> readLens()
    {
        const std::optional<ImageSize> size = sizeOf(m_camera, m_choices);
        if (!size)
            return noSize(m_text.name);
        const auto number = [this](const char *name, double otherwise) {
            return m_values.number({name}).value_or(otherwise);
        };
        const double aspectX = number("pixelaspectx", 1.0), aspectY = number("pixelaspecty", 1.0);
        const NamedValue *given = m_values.find({"sensorfit"});
        const std::string fit = given ? given->word : "AUTO";
        const bool isVertical =
            fit == "VERTICAL" || (fit != "HORIZONTAL" && size->width * aspectX < size->height * aspectY);
        const double width = size->width, height = size->height, tall = aspectY / aspectX,
                     side = isVertical ? tall * height : width; // Blender's "view factor", in pixels
        const double shiftX = number("shiftx", 0.0) * side, shiftY = number("shifty", 0.0) * side / tall;
        if (hasType("PANO"))
            return fault("type", tr("a panoramic camera has no projection matrix; only PERSP and ORTHO are read"));
        const auto scale = m_values.number({"orthoscale"});
        if (hasType("ORTHO"))
            return readParallel(*size, scale, scale.value_or(0.0) / side, tall, {shiftX, shiftY});
        if (const auto lens = m_values.number({"lens"}); lens && !(*lens > 0.0))
            return fault("lens", tr("%1 is %2; it must be greater than 0", "lens", base::shortestText(*lens)));
        const std::optional<double> focal = focalLength(fit, isVertical, side);
        if (!focal)
            return fault("lens", tr("the focal length is missing; give lens in millimetres or angle in radians"));
        m_camera.intrinsics = Intrinsics{
            *focal, *focal / tall, width / 2.0 - shiftX, height / 2.0 + shiftY, 0.0, PixelCentres::AtHalves, true};
        return std::nullopt;
    }

    /// In pixels of width.
    std::optional<double> focalLength(const std::string &fit, bool isVertical, double side)
    {
        if (const auto lens = m_values.number({"lens"})) {
            constexpr double kWidth = 36.0, kHeight = 24.0; // of a new camera's sensor, mm
            const bool isByHeight = fit == "VERTICAL";
            const auto given = m_values.number({isByHeight ? "sensorheight" : "sensorwidth"});
            if (!given)
                m_camera.assumed.push_back(isByHeight
                                               ? tr("The sensor is assumed to be 24 mm high, because sensor_height is "
                                                    "missing. Add it to say otherwise.")
                                               : tr("The sensor is assumed to be 36 mm wide, because sensor_width is "
                                                    "missing. Add it to say otherwise."));
            return *lens * side / given.value_or(isByHeight ? kHeight : kWidth);
        }
        const auto size = sizeOf(m_camera, m_choices);
        const auto half = [](double radians) { return 2.0 * std::tan(radians / 2.0); };
        if (const auto angle = m_values.number({"angle"}); angle && *angle > 0.0 && *angle < kPi)
            return side / half(*angle);
        if (const auto angle = m_values.number({"anglex"}); angle && !isVertical && *angle > 0.0 && *angle < kPi)
            return size->width / half(*angle);
        return std::nullopt;
    }

    std::optional<CameraError> readParallel(const ImageSize &size, const std::optional<double> &scale, double pixel,
                                            double tall, const std::array<double, 2> &shift)
    {
        if (!scale || !m_camera.nearDistance || !m_camera.farDistance)
            return fault("type", tr("an orthographic camera needs ortho_scale, clip_start and clip_end"));
        const double halfWidth = size.width / 2.0, halfHeight = size.height / 2.0;
        const Ortho box{pixel * (shift[0] - halfWidth),
                        pixel * (shift[0] + halfWidth),
                        pixel * tall * (shift[1] - halfHeight),
                        pixel * tall * (shift[1] + halfHeight),
                        *m_camera.nearDistance,
                        *m_camera.farDistance};
        const Result<glm::dmat4> clip = clipFromEye(Projection(box));
        if (!clip)
            return fault("type", geometry::errorText(clip.error()));
        m_camera.projection = MatrixProjection{*clip, NdcDepth::MinusOneToOne};
        return std::nullopt;
    }

    const NamedText &m_text;
    const NamedValues &m_values;
    const CameraChoices &m_choices;
    ForeignCamera m_camera;
};

} // namespace

CameraRead readBlender(std::span<const NamedText> texts, const CameraChoices &choices)
{
    for (const NamedText &text : texts) {
        const NamedValues values(text.text);
        const bool hasPose = values.has({"matrixworld", "rotationeuler"})
                             || text.text.find("<Matrix 4x4") != text.text.npos
                             || text.text.find("Matrix(((") != text.text.npos;
        if (hasPose && values.has({"lens", "angle", "anglex", "orthoscale", "sensorwidth", "shiftx"}))
            return Reader(text, values, choices).read();
    }
    return std::nullopt;
}

} // namespace unprojector::cameras
