#include "core/base/json.h"
#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/cameras/camera_json.h"
#include "core/cameras/camera_reader.h"
#include "core/cameras/reader_parts.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <utility>

// transforms.json of NeRF, Instant-NGP and Nerfstudio.

namespace unprojector::cameras {
using namespace geometry;
using base::tr;
using Json = nlohmann::ordered_json;

namespace {

/// A frame's own value, else the file's.
std::optional<double> valueOf(const Json &file, const Json &frame, const char *key)
{
    const auto own = numberOf(frame, key);
    return own ? own : numberOf(file, key);
}

class Reader {
public:
    Reader(const NamedText &text, const Json &file, const CameraChoices &choices)
        : m_text(text), m_file(file), m_choices(choices)
    {
    }

    Result<ForeignCamera, CameraError> read()
    {
        m_camera.program = "NeRF";
        m_camera.direction = PoseDirection::CameraToWorld;
        m_camera.axes = EyeAxes::RightUpBack;
        m_camera.isDirectionCertain = m_camera.areAxesCertain = true;
        const Json *frames = memberOf(m_file, "frames");
        if (frames) {
            for (std::size_t i = 0; i < frames->size(); ++i) {
                const Json *path = memberOf((*frames)[i], "file_path");
                m_camera.images.push_back(path && path->is_string() ? path->get<std::string>() : std::to_string(i));
            }
            if (frames->empty())
                return fault("frames", tr("there are no frames"));
            if (auto error = chooseImage(m_camera, m_choices, m_text.name))
                return *error;
        }
        m_frame = frames ? &(*frames)[m_camera.image] : &m_file;
        if (auto error = readPose())
            return *error;
        if (auto error = refuseModel())
            return *error;
        m_camera.size = sizeOf(value("w"), value("h"));
        if (auto error = refuseSize())
            return *error;
        if (auto error = readLens())
            return *error;
        readDistortion();
        sayIgnored();
        return m_camera;
    }

private:
    CameraError fault(const char *key, std::string reason) const
    {
        return {m_text.name, lineOfKey(m_text.text, key), std::move(reason)};
    }
    std::optional<double> value(const char *key) const { return valueOf(m_file, *m_frame, key); }

    std::optional<CameraError> readPose()
    {
        const Json *matrix = memberOf(*m_frame, "transform_matrix");
        const auto numbers = matrix ? numbersOf(*matrix) : std::nullopt;
        const auto pose = numbers && numbers->size() >= 12 ? matrixByRows(*numbers) : std::nullopt;
        if (!pose)
            return CameraError{
                m_text.name, lineOfKey(m_text.text, "transform_matrix", m_camera.image),
                tr("%1 needs %2 numbers; it has %3", "transform_matrix", 16, numbers ? numbers->size() : 0)};
        m_camera.pose = pose;
        return std::nullopt;
    }

    std::optional<CameraError> refuseModel() const
    {
        if (m_choices.isUndistorted)
            return std::nullopt;
        const Json *own = memberOf(*m_frame, "camera_model");
        const Json *model = own ? own : memberOf(m_file, "camera_model");
        const std::string name = model && model->is_string() ? model->get<std::string>() : "OPENCV";
        const bool isPinhole = name == "OPENCV" || name == "PINHOLE" || name == "SIMPLE_PINHOLE"
                               || name == "perspective" || name == "SIMPLE_RADIAL" || name == "RADIAL";
        if (!isPinhole)
            return fault("camera_model", tr("the camera model %1 is not read: it is no pinhole with the distortion of "
                                            "Brown and Conrady. Undistort the images first, then give --undistorted",
                                            name));
        for (const char *key : {"is_fisheye", "k4", "k5", "k6"}) {
            const Json *flag = memberOf(m_file, key);
            if (value(key).value_or(0.0) != 0.0 || (flag && flag->is_boolean() && flag->get<bool>()))
                return fault(
                    key,
                    tr("%1 is of a distortion that is not read; undistort the images first, then give --undistorted",
                       key));
        }
        return std::nullopt;
    }

    /// The error of a width or height that is given, but is no image's; nothing if both are missing.
    std::optional<CameraError> refuseSize() const
    {
        for (const char *key : {"w", "h"}) {
            const Json *own = memberOf(*m_frame, key), *side = own ? own : memberOf(m_file, key);
            if (side && !m_choices.size && !sizeOf(numberOf(Json{{key, *side}}, key), 1.0))
                return fault(
                    key, tr("%1 is %2; it must be a whole number from 1 to 1000000", key, base::compactJson(*side)));
        }
        return std::nullopt;
    }

    std::optional<CameraError> readLens()
    {
        const auto fx = value("fl_x"), fy = value("fl_y"), angleX = value("camera_angle_x"),
                   angleY = value("camera_angle_y");
        if (!fx && !fy) {
            if (!angleX && !angleY)
                return fault("frames", tr("there is neither fl_x nor camera_angle_x; give one of them"));
            if (auto error = angleX ? setHorizontalAngle(m_camera, m_choices, *angleX, m_text.name)
                                    : setVerticalAngle(m_camera, m_choices, *angleY, {}, m_text.name))
                return error;
            const std::optional<ImageSize> size = sizeOf(m_camera, m_choices);
            if (angleX && angleY && size)
                m_camera.intrinsics->fy = size->height / (2.0 * std::tan(*angleY / 2.0));
        } else {
            const double focal = fx.value_or(fy.value_or(1.0));
            m_camera.intrinsics = Intrinsics{focal, fy.value_or(focal), 0.0, 0.0, 0.0, PixelCentres::AtHalves};
            sayAngle(focal, angleX);
        }
        return readCentre();
    }

    /// Says that the angle is another than the focal length's.
    void sayAngle(double focal, const std::optional<double> &angle)
    {
        const std::optional<ImageSize> size = sizeOf(m_camera, m_choices);
        constexpr double kSame = 0.01;
        if (!angle || !size)
            return;
        const double byAngle = size->width / (2.0 * std::tan(*angle / 2.0));
        if (std::abs(byAngle / focal - 1.0) > kSame)
            m_camera.assumed.push_back(tr("fl_x is %1, but camera_angle_x gives %2: fl_x is taken. Remove the wrong "
                                          "one.",
                                          base::significantText(focal, 6), base::significantText(byAngle, 6)));
    }

    std::optional<CameraError> readCentre()
    {
        const auto cx = value("cx"), cy = value("cy");
        const std::optional<ImageSize> size = sizeOf(m_camera, m_choices);
        if (cx.has_value() != cy.has_value())
            return fault(cx ? "cx" : "cy", tr("%1 is given without %2; give both", cx ? "cx" : "cy", cx ? "cy" : "cx"));
        if (!cx && !size)
            return noSize(m_text.name);
        m_camera.intrinsics->cx = cx ? *cx : size->width / 2.0;
        m_camera.intrinsics->cy = cy ? *cy : size->height / 2.0;
        m_camera.intrinsics->isCentreComputed = !cx;
        if (cx)
            m_camera.assumed.push_back(tr("Pixel centres are read at halves, as COLMAP writes cx and cy; "
                                          "--pixel-centers integer says otherwise."));
        else
            m_camera.assumed.push_back(tr("The principal point is assumed in the image's centre, because cx and cy "
                                          "are missing. Write them into the file to say otherwise."));
        return std::nullopt;
    }

    void readDistortion()
    {
        const auto of = [this](const char *key) { return value(key).value_or(0.0); };
        const Distortion distortion{of("k1"), of("k2"), of("p1"), of("p2"), of("k3")};
        if (!distortion.isNone())
            m_camera.distortion = distortion;
    }

    void sayIgnored()
    {
        std::string names;
        for (const char *key : {"scale", "offset", "aabb_scale", "aabb", "applied_transform", "applied_scale"}) {
            if (memberOf(m_file, key))
                names += (names.empty() ? "" : ", ") + std::string(key);
        }
        if (!names.empty())
            m_camera.assumed.push_back(tr("%1: not applied. Coordinates are those of transform_matrix.", names));
    }

    const NamedText &m_text;
    const Json &m_file;
    const Json *m_frame = nullptr;
    const CameraChoices &m_choices;
    ForeignCamera m_camera;
};

} // namespace

CameraRead readNerf(std::span<const NamedText> texts, const CameraChoices &choices)
{
    const NamedText *text =
        firstWith(texts, [](const std::string &one) { return one.find("transform_matrix") != one.npos; });
    if (text == nullptr) {
        const NamedText *lens = firstWith(texts, [](const std::string &one) {
            return isJson(one) && (lineOfKey(one, "fl_x") > 0 || lineOfKey(one, "camera_angle_x") > 0);
        });
        if (lens == nullptr)
            return std::nullopt;
        return CameraError{lens->name, 0, tr("there are no poses; give the frames, each with its transform_matrix")};
    }
    // A part of a file, as people paste it, is no object yet.
    NamedText whole = *text;
    if (!isJson(whole.text)) {
        const std::size_t first = whole.text.find('"');
        if (first == whole.text.npos)
            return std::nullopt;
        const std::size_t last = whole.text.find_last_not_of(" \t\r\n,");
        whole.text = '{' + whole.text.substr(0, last + 1) + '}';
    }
    const auto json = parsedJson(whole);
    if (!json)
        return json.error();
    const bool hasFrames = memberOf(*json, "frames") && memberOf(*json, "frames")->is_array();
    if (!hasFrames && !memberOf(*json, "transform_matrix"))
        return std::nullopt;
    return Reader(whole, *json, choices).read();
}

} // namespace unprojector::cameras
