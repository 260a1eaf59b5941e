#include "core/base/translation.h"
#include "core/cameras/camera_reader.h"
#include "core/cameras/reader_parts.h"
#include "core/geometry/error_text.h"
#include "core/geometry/numbers.h"
#include "core/geometry/projection.h"

#include <array>
#include <string_view>
#include <utility>

// Unity and Unreal. Both have left-handed worlds.

namespace unprojector::cameras {
using namespace geometry;
using base::tr;

namespace {

/// A rotation about an axis, counter-clockwise as seen against a right-handed axis.
glm::dmat3 aboutByDegrees(int axis, double degrees)
{
    return about(axis, radiansFromDegrees(degrees));
}

class UnityReader {
public:
    UnityReader(const NamedText &text, const NamedValues &values, const CameraChoices &choices)
        : m_text(text), m_values(values), m_choices(choices)
    {
    }

    Result<ForeignCamera, CameraError> read()
    {
        m_camera.program = "Unity";
        m_camera.isDirectionCertain = m_camera.areAxesCertain = true;
        m_camera.rightHandedFromWorld[2][2] = -1.0;
        m_camera.assumed.push_back(tr("Unity's world is left-handed. The scene has its z negated: the point (x, y, z) "
                                      "of Unity is (x, y, -z) here."));
        m_camera.size = sizeIn(m_values);
        m_camera.nearDistance = m_values.number({"nearclipplane"});
        m_camera.farDistance = m_values.number({"farclipplane"});
        if (auto error = readPose())
            return *error;
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

    std::optional<CameraError> readPose()
    {
        for (const char *name : {"worldtocameramatrix", "cameratoworldmatrix"}) {
            const std::vector<double> numbers = m_values.numbers({name}, 1);
            if (numbers.empty())
                continue;
            m_camera.pose = numbers.size() == 16 ? matrixByRows(numbers) : std::nullopt;
            if (!m_camera.pose)
                return fault(name,
                             tr("%1 needs %2 numbers; it has %3", m_values.find({name})->written, 16, numbers.size()));
            const bool isForward = std::string_view(name).starts_with("world");
            m_camera.direction = isForward ? PoseDirection::WorldToCamera : PoseDirection::CameraToWorld;
            m_camera.axes = EyeAxes::RightUpBack;
            return std::nullopt;
        }
        const std::vector<double> at = m_values.numbers({"position", "mlocalposition"}, 3, {"x", "y", "z"});
        if (at.size() != 3)
            return fault("position", tr("the camera's position is missing; give its x, y and z"));
        const std::vector<double> q = m_values.numbers({"rotation", "mlocalrotation"}, 4, {"x", "y", "z", "w"}),
                                  angles = m_values.numbers({"eulerangles", "rotation", "mlocaleulerangleshint"}, 3,
                                                            {"x", "y", "z"});
        std::optional<glm::dmat3> rotation;
        if (q.size() == 4)
            rotation = rotationOf(q[3], q[0], q[1], q[2]);
        if (q.size() == 4 && !rotation)
            return fault("rotation", tr("the quaternion is 0 or not finite; give a rotation's, of the length 1"));
        if (!rotation && angles.size() == 3)
            rotation = aboutByDegrees(1, angles[1]) * aboutByDegrees(0, angles[0]) * aboutByDegrees(2, angles[2]);
        if (!rotation)
            return fault("rotation", tr("the camera's rotation is missing; give the quaternion (x, y, z, w) or "
                                        "eulerAngles"));
        m_camera.pose = rigid(*rotation, {at[0], at[1], at[2]});
        m_camera.direction = PoseDirection::CameraToWorld;
        m_camera.axes = EyeAxes::RightUpAhead;
        if (!m_values.has({"position"}) || !m_values.has({"rotation", "eulerangles"}))
            m_camera.assumed.push_back(tr("%1 and %2 count as the camera's pose in the world, as for a camera without "
                                          "parent. Give %3 if it has one.",
                                          "m_LocalPosition", "m_LocalRotation", "position and rotation"));
        return std::nullopt;
    }

    std::optional<CameraError> readLens()
    {
        const std::vector<double> matrix = m_values.numbers({"projectionmatrix"}, 1);
        if (!matrix.empty()) {
            const auto clip = matrix.size() == 16 ? matrixByRows(matrix) : std::nullopt;
            if (!clip)
                return fault("projectionmatrix", tr("%1 needs %2 numbers; it has %3",
                                                    m_values.find({"projectionmatrix"})->written, 16, matrix.size()));
            m_camera.projection = MatrixProjection{*clip, NdcDepth::MinusOneToOne};
            return std::nullopt;
        }
        if (m_values.isTrue("orthographic"))
            return readParallel();
        const auto degrees = m_values.number({"fieldofview"});
        if (!degrees)
            return fault("fieldofview", tr("the field of view is missing; give fieldOfView or projectionMatrix"));
        return setVerticalAngle(m_camera, m_choices, radiansFromDegrees(*degrees), m_values.number({"aspect"}),
                                m_text.name);
    }

    std::optional<CameraError> readParallel()
    {
        const auto half = m_values.number({"orthographicsize"});
        const std::optional<ImageSize> size = sizeOf(m_camera, m_choices);
        if (!half || !m_camera.nearDistance || !m_camera.farDistance)
            return fault("orthographic", tr("an orthographic camera needs orthographicSize, nearClipPlane and "
                                            "farClipPlane"));
        if (!size)
            return noSize(m_text.name);
        const double halfWidth = *half * size->width / size->height;
        const Result<glm::dmat4> clip = clipFromEye(
            Projection(Ortho{-halfWidth, halfWidth, -*half, *half, *m_camera.nearDistance, *m_camera.farDistance}));
        if (!clip)
            return fault("orthographic", geometry::errorText(clip.error()));
        m_camera.projection = MatrixProjection{*clip, NdcDepth::MinusOneToOne};
        return std::nullopt;
    }

    const NamedText &m_text;
    const NamedValues &m_values;
    const CameraChoices &m_choices;
    ForeignCamera m_camera;
};

/// Three values of one number each that follow one another under these names: "P=-10 Y=45 R=0".
/// @param parent  the name before them; others count where it is missing
std::optional<glm::dvec3> inSequence(const NamedValues &values, const std::array<std::string_view, 3> &names,
                                     std::string_view parent)
{
    const std::vector<NamedValue> &all = values.all();
    std::optional<glm::dvec3> elsewhere;
    for (std::size_t i = 0; i + 3 <= all.size(); ++i) {
        bool isIt = true;
        for (std::size_t k = 0; k < 3; ++k)
            isIt = isIt && all[i + k].isNamed(names[k]) && !all[i + k].numbers.empty();
        if (!isIt)
            continue;
        const glm::dvec3 found(all[i].numbers[0], all[i + 1].numbers[0], all[i + 2].numbers[0]);
        if (all[i].parent.ends_with(parent))
            return found;
        elsewhere = elsewhere ? elsewhere : found;
    }
    return elsewhere;
}

/// Unreal's location, and its pitch, yaw and roll in degrees.
struct UnrealPose {
    glm::dvec3 location, rotation;
};

std::optional<UnrealPose> unrealPose(const NamedValues &values)
{
    // As the console command BugIt writes them.
    if (const std::vector<double> n = values.numbers({"bugitgo"}, 6); n.size() == 6)
        return UnrealPose{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
    const auto location = inSequence(values, {"x", "y", "z"}, "location");
    auto rotation = inSequence(values, {"p", "y", "r"}, "rotation");
    if (!rotation)
        rotation = inSequence(values, {"pitch", "yaw", "roll"}, "rotation");
    if (const auto turned = inSequence(values, {"roll", "pitch", "yaw"}, "rotation"); turned && !rotation)
        rotation = glm::dvec3(turned->y, turned->z, turned->x);
    return location && rotation ? std::optional(UnrealPose{*location, *rotation}) : std::nullopt;
}

} // namespace

CameraRead readUnity(std::span<const NamedText> texts, const CameraChoices &choices)
{
    for (const NamedText &text : texts) {
        const NamedValues values(text.text);
        const bool hasMatrices = values.has({"worldtocameramatrix", "cameratoworldmatrix"})
                                 && values.has({"projectionmatrix", "fieldofview"});
        const bool hasTransform = values.has({"position", "mlocalposition"})
                                  && values.has({"rotation", "eulerangles", "mlocalrotation"})
                                  && values.has({"fieldofview", "orthographicsize"});
        if (hasMatrices || hasTransform)
            return UnityReader(text, values, choices).read();
    }
    return std::nullopt;
}

CameraRead readUnreal(std::span<const NamedText> texts, const CameraChoices &choices)
{
    for (const NamedText &text : texts) {
        const NamedValues values(text.text);
        const std::optional<UnrealPose> pose = unrealPose(values);
        const auto degrees = values.number({"fov", "fieldofview", "fovangle"});
        if (!pose || (!degrees && !values.has({"bugitgo"})))
            continue;
        ForeignCamera camera;
        camera.program = "Unreal";
        camera.direction = PoseDirection::CameraToWorld;
        camera.axes = EyeAxes::AheadRightUp;
        camera.isDirectionCertain = camera.areAxesCertain = true;
        camera.rightHandedFromWorld[1][1] = -1.0;
        // FRotator turns about x by roll, about y by pitch, then about z by yaw. Pitch and roll
        // count against the right-hand rule.
        camera.pose = rigid(aboutByDegrees(2, pose->rotation.y) * aboutByDegrees(1, -pose->rotation.x)
                                * aboutByDegrees(0, -pose->rotation.z),
                            pose->location);
        camera.size = sizeIn(values);
        if (values.has({"relativelocation", "relativerotation"}))
            camera.assumed.push_back(tr("%1 and %2 count as the camera's pose in the world, as for a camera without "
                                        "parent. Give %3 if it has one.",
                                        "RelativeLocation", "RelativeRotation", "Location and Rotation"));
        camera.assumed.push_back(tr("Unreal's world is left-handed and in centimetres. The scene has its y negated: "
                                    "the point (x, y, z) of Unreal is (x, -y, z) here, in centimetres."));
        constexpr double kUsualAngle = 90.0;
        if (!degrees)
            camera.assumed.push_back(
                tr("The horizontal field of view is assumed to be 90 degrees, because FOV is missing. "
                   "Add FOV=90 with the right value to say otherwise."));
        if (auto error =
                setHorizontalAngle(camera, choices, radiansFromDegrees(degrees.value_or(kUsualAngle)), text.name))
            return *error;
        return camera;
    }
    return std::nullopt;
}

} // namespace unprojector::cameras
