#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/cameras/camera_json.h"
#include "core/cameras/camera_reader.h"
#include "core/cameras/reader_parts.h"
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

class Reader {
public:
    Reader(const NamedText &text, const Json &file, const CameraChoices &choices)
        : m_text(text), m_file(file), m_choices(choices)
    {
    }

    Result<ForeignCamera, CameraError> read(const std::string &kind)
    {
        m_camera.program = "Open3D";
        m_camera.isDirectionCertain = m_camera.areAxesCertain = true;
        const bool isView = kind == "ViewTrajectory";
        const Json *list = memberOf(m_file, isView ? "trajectory" : "parameters");
        const Json *one = &m_file;
        if (list) {
            if (!list->is_array() || list->empty())
                return fault(isView ? "trajectory" : "parameters", tr("there are no cameras"));
            for (std::size_t i = 0; i < list->size(); ++i)
                m_camera.images.push_back(std::to_string(i));
            if (auto error = chooseImage(m_camera, m_choices, m_text.name))
                return *error;
            one = &(*list)[m_camera.image];
        }
        const auto error = isView ? readView(*one) : readPinhole(*one, kind);
        if (error)
            return *error;
        return m_camera;
    }

private:
    CameraError fault(const char *key, std::string reason) const
    {
        return {m_text.name, lineOfKey(m_text.text, key, m_camera.image), std::move(reason)};
    }

    /// Numbers under a key of an object, by count.
    std::optional<CameraError> take(const Json &object, const char *key, std::size_t count,
                                    std::vector<double> &numbers) const
    {
        const Json *member = memberOf(object, key);
        const auto found = member ? numbersOf(*member) : std::nullopt;
        if (!found || found->size() != count)
            return fault(key, tr("%1 needs %2 numbers; it has %3", key, count, found ? found->size() : 0));
        numbers = *found;
        return std::nullopt;
    }

    std::optional<CameraError> readPinhole(const Json &parameters, const std::string &kind)
    {
        m_camera.axes = EyeAxes::RightDownAhead;
        const bool isLensAlone = kind == "PinholeCameraIntrinsic";
        const Json *lens = isLensAlone ? &parameters : memberOf(parameters, "intrinsic");
        if (lens == nullptr)
            return fault("extrinsic", tr("there is no intrinsic; give the focal length there"));
        std::vector<double> k, pose;
        if (auto error = take(*lens, "intrinsic_matrix", 9, k)) // by columns
            return error;
        m_camera.intrinsics = Intrinsics{k[0], k[4], k[6], k[7], k[3], PixelCentres::AtIntegers};
        m_camera.size = sizeOf(numberOf(*lens, "width"), numberOf(*lens, "height"));
        if (isLensAlone)
            return std::nullopt;
        if (auto error = take(parameters, "extrinsic", 16, pose))
            return error;
        m_camera.pose = matrixByColumns(pose);
        return std::nullopt;
    }

    /// The camera of Open3D's viewer, as its ViewControl computes it.
    std::optional<CameraError> readView(const Json &view)
    {
        std::array<std::vector<double>, 5> v;
        constexpr std::array kKeys{"boundingbox_min", "boundingbox_max", "front", "lookat", "up"};
        for (std::size_t i = 0; i < kKeys.size(); ++i) {
            if (auto error = take(view, kKeys[i], 3, v[i]))
                return error;
        }
        const auto point = [&v](std::size_t i) { return glm::dvec3(v[i][0], v[i][1], v[i][2]); };
        const auto degrees = numberOf(view, "field_of_view"), zoom = numberOf(view, "zoom");
        if (!degrees || !zoom)
            return fault("zoom", tr("field_of_view and zoom need a number each"));
        const glm::dvec3 extents = point(1) - point(0);
        const double extent = std::max({extents.x, extents.y, extents.z}), half = *zoom * extent;
        constexpr double kOrthographic = 5.0; // this angle stands for a parallel projection
        const bool isOrthographic = *degrees == kOrthographic;
        const double distance = half / std::tan(radiansFromDegrees(*degrees) / 2.0);
        if (!(extent > 0.0) || !(distance > 0.0))
            return fault("zoom", tr("the bounding box, zoom and field_of_view give no distance; all must be above 0"));
        const glm::dvec3 front = point(2);
        const auto pose = looking(point(3) + distance * front / glm::length(front), front, point(4));
        if (!pose)
            return fault("front", tr("front and up are parallel or 0; they give no axes"));
        m_camera.pose = pose;
        m_camera.direction = PoseDirection::CameraToWorld;
        m_camera.axes = EyeAxes::RightUpBack;
        const double nearDistance = distance - 3.0 * extent, farDistance = distance + 3.0 * extent;
        m_camera.farDistance = farDistance;
        m_camera.nearDistance = std::max(0.01 * extent, nearDistance);
        if (!isOrthographic)
            return setVerticalAngle(m_camera, m_choices, radiansFromDegrees(*degrees), {}, m_text.name);
        const std::optional<ImageSize> size = m_choices.size;
        if (!size)
            return noSize(m_text.name);
        const double aspect = double(size->width) / size->height;
        const Result<glm::dmat4> box =
            clipFromEye(Projection(Ortho{-aspect * half, aspect * half, -half, half, nearDistance, farDistance}));
        if (!box)
            return fault("zoom", tr("the bounding box, zoom and field_of_view give no distance; all must be above 0"));
        m_camera.projection = MatrixProjection{*box, NdcDepth::MinusOneToOne};
        return std::nullopt;
    }

    const NamedText &m_text;
    const Json &m_file;
    const CameraChoices &m_choices;
    ForeignCamera m_camera;
};

} // namespace

CameraRead readOpen3d(std::span<const NamedText> texts, const CameraChoices &choices)
{
    const NamedText *text = firstWith(texts, [](const std::string &one) {
        // The name of the class is missing where someone copied the middle of a file.
        const bool isNamed = one.find("\"class_name\"") != one.npos
                             && std::any_of(kKinds.begin(), kKinds.end(), [&one](const char *kind) {
                                    return one.find('"' + std::string(kind) + '"') != one.npos;
                                });
        return isJson(one) && (isNamed || one.find("\"intrinsic_matrix\"") != one.npos);
    });
    if (text == nullptr)
        return std::nullopt;
    const auto json = parsedJson(*text);
    if (!json)
        return json.error();
    const Json *name = memberOf(*json, "class_name");
    std::string kind = name && name->is_string() ? name->get<std::string>() : "PinholeCameraParameters";
    if (!name && memberOf(*json, "intrinsic_matrix"))
        kind = "PinholeCameraIntrinsic";
    if (std::find(kKinds.begin(), kKinds.end(), kind) == kKinds.end())
        return std::nullopt;
    return Reader(*text, *json, choices).read(kind);
}

} // namespace unprojector::cameras
