#include "core/base/json.h"
#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/cameras/camera_json.h"
#include "core/cameras/camera_reader.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

// transforms.json of NeRF, Instant-NGP and Nerfstudio.

namespace unprojector::cameras {
using namespace geometry;
using base::tr;
using Json = nlohmann::ordered_json;

namespace {

class Reader {
public:
    Reader(Reading &reading, const Json &file)
        : m_reading(reading), m_camera(reading.camera), m_file(file), m_frame(&file)
    {
    }

    void read()
    {
        m_reading.begin("NeRF", PoseDirection::CameraToWorld, EyeAxes::RightUpBack);
        if (const Json *frames = memberOf(m_file, "frames")) {
            for (std::size_t i = 0; i < frames->size(); ++i)
                m_camera.images.push_back(nameOf((*frames)[i], "file_path", i));
            if (frames->empty())
                fail("frames", tr("there are no frames"));
            m_reading.chooseImage();
            m_frame = &(*frames)[m_camera.image];
        }
        readPose();
        refuseModel();
        m_camera.size = sizeOf(value("w"), value("h"));
        refuseSize();
        readLens();
        const auto of = [this](const char *key) { return value(key).value_or(0.0); };
        const Distortion distortion{of("k1"), of("k2"), of("p1"), of("p2"), of("k3")};
        if (!distortion.isNone())
            m_camera.distortion = distortion;
        sayIgnored();
    }

private:
    [[noreturn]] void fail(const char *key, std::string reason) const
    {
        m_reading.fail(std::move(reason),
                       lineOfMember(m_reading.text.text, memberOf(*m_frame, key) ? *m_frame : m_file, key));
    }
    /// The frame's own member, else the file's.
    const Json *member(const char *key) const
    {
        const Json *own = memberOf(*m_frame, key);
        return own ? own : memberOf(m_file, key);
    }
    std::optional<double> value(const char *key) const
    {
        const auto own = numberOf(*m_frame, key);
        return own ? own : numberOf(m_file, key);
    }

    void readPose()
    {
        const std::vector<double> numbers = numbersOf(*m_frame, "transform_matrix");
        m_camera.pose = numbers.size() >= 12 ? matrixByRows(numbers) : std::nullopt;
        if (!m_camera.pose)
            m_reading.fail(tr("%1 needs %2 numbers; it has %3", "transform_matrix", 16, numbers.size()),
                           lineOfMember(m_reading.text.text, *m_frame, "transform_matrix"));
    }

    void refuseModel() const
    {
        if (m_reading.choices.isUndistorted)
            return;
        const Json *model = member("camera_model");
        const std::string name = model && model->is_string() ? model->get<std::string>() : "OPENCV";
        constexpr std::array kPinholes{"OPENCV", "PINHOLE", "SIMPLE_PINHOLE", "perspective", "SIMPLE_RADIAL", "RADIAL"};
        if (std::find(kPinholes.begin(), kPinholes.end(), name) == kPinholes.end())
            fail("camera_model", tr("the camera model %1 is not read: it is no pinhole with the distortion of Brown "
                                    "and Conrady. Undistort the images first, then give --undistorted",
                                    name));
        for (const char *key : {"is_fisheye", "k4", "k5", "k6"}) {
            const Json *flag = memberOf(m_file, key);
            if (value(key).value_or(0.0) != 0.0 || (flag && flag->is_boolean() && flag->get<bool>()))
                fail(key, tr("%1 is of a distortion that is not read; undistort the images first, then give "
                             "--undistorted",
                             key));
        }
    }

    /// Fails for a width or height that is given, but is no image's; not if both are missing.
    void refuseSize() const
    {
        for (const char *key : {"w", "h"}) {
            const Json *side = member(key);
            if (side && !m_reading.choices.size && !sizeOf(numberOf(Json{{key, *side}}, key), 1.0))
                fail(key, tr("%1 is %2; it must be a whole number from 1 to 1000000", key, base::compactJson(*side)));
        }
    }

    void readLens()
    {
        const auto fx = value("fl_x"), fy = value("fl_y"), angleX = value("camera_angle_x"),
                   angleY = value("camera_angle_y");
        if (!fx && !fy) {
            if (angleX)
                m_reading.setHorizontalAngle(*angleX);
            else if (angleY)
                m_reading.setVerticalAngle(*angleY);
            else
                fail("frames", tr("there is neither fl_x nor camera_angle_x; give one of them"));
            if (angleX && angleY)
                m_camera.intrinsics->fy = m_reading.neededSize().height / (2.0 * std::tan(*angleY / 2.0));
        } else {
            const double focal = fx.value_or(fy.value_or(1.0));
            m_camera.intrinsics = Intrinsics{focal, fy.value_or(focal), 0.0, 0.0, 0.0, PixelCentres::AtHalves};
            sayAngle(focal, angleX);
        }
        readCentre();
    }

    /// Says that the angle is another than the focal length's.
    void sayAngle(double focal, const std::optional<double> &angle)
    {
        constexpr double kSame = 0.01;
        if (!angle || !m_reading.size())
            return;
        const double byAngle = m_reading.size()->width / (2.0 * std::tan(*angle / 2.0));
        if (std::abs(byAngle / focal - 1.0) > kSame)
            m_camera.assumed.push_back(tr("fl_x is %1, but camera_angle_x gives %2: fl_x is taken. Remove the wrong "
                                          "one.",
                                          base::significantText(focal, 6), base::significantText(byAngle, 6)));
    }

    void readCentre()
    {
        const auto cx = value("cx"), cy = value("cy");
        if (cx.has_value() != cy.has_value())
            fail(cx ? "cx" : "cy", tr("%1 is given without %2; give both", cx ? "cx" : "cy", cx ? "cy" : "cx"));
        m_camera.intrinsics->cx = cx ? *cx : m_reading.neededSize().width / 2.0;
        m_camera.intrinsics->cy = cy ? *cy : m_reading.neededSize().height / 2.0;
        m_camera.intrinsics->isCentreComputed = !cx;
        m_camera.assumed.push_back(tr(cx ? "Pixel centres are read at halves, as COLMAP writes cx and cy; "
                                           "--pixel-centers integer says otherwise."
                                         : "The principal point is assumed in the image's centre, because cx and cy "
                                           "are missing. Write them into the file to say otherwise."));
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

    Reading &m_reading;
    ForeignCamera &m_camera;
    const Json &m_file;
    const Json *m_frame;
};

} // namespace

std::optional<ForeignCamera> readNerf(std::span<const NamedText> texts, const CameraChoices &choices)
{
    const auto text = std::find_if(texts.begin(), texts.end(), [](const NamedText &one) {
        return one.text.find("transform_matrix") != std::string::npos;
    });
    if (text == texts.end()) {
        for (const NamedText &lens : texts) {
            if (isJson(lens.text) && (lineOfKey(lens.text, "fl_x") > 0 || lineOfKey(lens.text, "camera_angle_x") > 0))
                Reading(lens, choices).fail(tr("there are no poses; give the frames, each with its transform_matrix"));
        }
        return std::nullopt;
    }
    // A part of a file, as people paste it, is no object yet.
    NamedText whole = *text;
    if (!isJson(whole.text)) {
        if (whole.text.find('"') == whole.text.npos)
            return std::nullopt;
        const std::size_t last = whole.text.find_last_not_of(" \t\r\n,");
        whole.text = '{' + whole.text.substr(0, last + 1) + '}';
    }
    const Json file = parsedJson(whole);
    const Json *frames = memberOf(file, "frames");
    if (!(frames && frames->is_array()) && !memberOf(file, "transform_matrix"))
        return std::nullopt;
    Reading reading(whole, choices);
    Reader(reading, file).read();
    reading.camera.files = {whole.name};
    return std::move(reading.camera);
}

} // namespace unprojector::cameras
