#include "core/base/translation.h"
#include "core/cameras/camera_reader.h"
#include "core/geometry/numbers.h"
#include "core/geometry/projection.h"

#include <array>
#include <string_view>
#include <vector>

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

void readUnityPose(Reading &reading)
{
    const NamedValues &values = reading.values();
    ForeignCamera &camera = reading.camera;
    for (const char *name : {"worldtocameramatrix", "cameratoworldmatrix"}) {
        const std::vector<double> numbers = values.numbers({name}, 1);
        if (numbers.empty())
            continue;
        camera.pose = numbers.size() == 16 ? matrixByRows(numbers) : std::nullopt;
        if (!camera.pose)
            reading.failAt(name,
                           tr("%1 needs %2 numbers; it has %3", values.find({name})->written, 16, numbers.size()));
        const bool isForward = std::string_view(name).starts_with("world");
        camera.direction = isForward ? PoseDirection::WorldToCamera : PoseDirection::CameraToWorld;
        camera.axes = EyeAxes::RightUpBack;
        return;
    }
    const std::vector<double> at = values.numbers({"position", "mlocalposition"}, 3, {"x", "y", "z"});
    if (at.size() != 3)
        reading.failAt("position", tr("the camera's position is missing; give its x, y and z"));
    const std::vector<double> q = values.numbers({"rotation", "mlocalrotation"}, 4, {"x", "y", "z", "w"}),
                              angles = values.numbers({"eulerangles", "rotation", "mlocaleulerangleshint"}, 3,
                                                      {"x", "y", "z"});
    std::optional<glm::dmat3> rotation;
    if (q.size() == 4)
        rotation = rotationOf(q[3], q[0], q[1], q[2]);
    if (q.size() == 4 && !rotation)
        reading.failAt("rotation", tr("the quaternion is 0 or not finite; give a rotation's, of the length 1"));
    if (!rotation && angles.size() == 3)
        rotation = aboutByDegrees(1, angles[1]) * aboutByDegrees(0, angles[0]) * aboutByDegrees(2, angles[2]);
    if (!rotation)
        reading.failAt("rotation",
                       tr("the camera's rotation is missing; give the quaternion (x, y, z, w) or eulerAngles"));
    camera.pose = rigid(*rotation, {at[0], at[1], at[2]});
    if (!values.has({"position"}) || !values.has({"rotation", "eulerangles"}))
        camera.assumed.push_back(tr("%1 and %2 count as the camera's pose in the world, as for a camera without "
                                    "parent. Give %3 if it has one.",
                                    "m_LocalPosition", "m_LocalRotation", "position and rotation"));
}

void readUnityLens(Reading &reading)
{
    const NamedValues &values = reading.values();
    ForeignCamera &camera = reading.camera;
    const NamedValue *matrix = values.find({"projectionmatrix"});
    if (const std::vector<double> numbers = values.numbers({"projectionmatrix"}, 1); !numbers.empty()) {
        const auto clip = numbers.size() == 16 ? matrixByRows(numbers) : std::nullopt;
        if (!clip)
            reading.failAt("projectionmatrix",
                           tr("%1 needs %2 numbers; it has %3", matrix->written, 16, numbers.size()));
        camera.projection = MatrixProjection{*clip, NdcDepth::MinusOneToOne};
    } else if (values.isTrue("orthographic")) {
        const auto half = values.number({"orthographicsize"});
        if (!half || !camera.nearDistance || !camera.farDistance)
            reading.failAt("orthographic",
                           tr("an orthographic camera needs orthographicSize, nearClipPlane and farClipPlane"));
        const ImageSize size = reading.neededSize();
        const double halfWidth = *half * size.width / size.height;
        reading.setProjection(Ortho{-halfWidth, halfWidth, -*half, *half, *camera.nearDistance, *camera.farDistance},
                              values.find({"orthographic"})->line);
    } else {
        const auto degrees = values.number({"fieldofview"});
        if (!degrees)
            reading.failAt("fieldofview", tr("the field of view is missing; give fieldOfView or projectionMatrix"));
        reading.setVerticalAngle(radiansFromDegrees(*degrees), values.number({"aspect"}));
    }
}

/// Three values of one number each that follow one another under these names: "P=-10 Y=45 R=0".
/// @param parent  the name before them; others count where it is missing
/// @param ending  of the first name where others count: "X" leaves x out
std::optional<glm::dvec3> inSequence(const NamedValues &values, const std::array<std::string_view, 3> &names,
                                     std::string_view parent, std::string_view ending = {})
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
        if (!elsewhere && all[i].written.ends_with(ending))
            elsewhere = found;
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
    // Other programs write x, y, z and pitch, yaw, roll, too, in worlds of their own.
    const auto location = inSequence(values, {"x", "y", "z"}, "location", "X");
    auto rotation = inSequence(values, {"p", "y", "r"}, "rotation");
    if (!rotation)
        rotation = inSequence(values, {"pitch", "yaw", "roll"}, "rotation");
    if (const auto turned = inSequence(values, {"roll", "pitch", "yaw"}, "rotation"); turned && !rotation)
        rotation = glm::dvec3(turned->y, turned->z, turned->x);
    return location && rotation ? std::optional(UnrealPose{*location, *rotation}) : std::nullopt;
}

} // namespace

bool readUnity(Reading &reading)
{
    const NamedValues &values = reading.values();
    const bool hasMatrices =
        values.has({"worldtocameramatrix", "cameratoworldmatrix"}) && values.has({"projectionmatrix", "fieldofview"});
    const bool hasTransform = values.has({"position", "mlocalposition"})
                              && values.has({"rotation", "eulerangles", "mlocalrotation"})
                              && values.has({"fieldofview", "orthographicsize"});
    if (!hasMatrices && !hasTransform)
        return false;
    ForeignCamera &camera = reading.camera;
    reading.begin("Unity", PoseDirection::CameraToWorld, EyeAxes::RightUpAhead);
    camera.rightHandedFromWorld[2][2] = -1.0;
    camera.assumed.push_back(tr("Unity's world is left-handed. The scene has its z negated: the point (x, y, z) of "
                                "Unity is (x, y, -z) here."));
    camera.size = sizeIn(values);
    camera.nearDistance = values.number({"nearclipplane"});
    camera.farDistance = values.number({"farclipplane"});
    readUnityPose(reading);
    readUnityLens(reading);
    return true;
}

bool readUnreal(Reading &reading)
{
    const NamedValues &values = reading.values();
    const std::optional<UnrealPose> pose = unrealPose(values);
    const auto degrees = values.number({"fov", "fieldofview", "fovangle"});
    if (!pose || (!degrees && !values.has({"bugitgo"})))
        return false;
    ForeignCamera &camera = reading.camera;
    reading.begin("Unreal", PoseDirection::CameraToWorld, EyeAxes::AheadRightUp);
    camera.rightHandedFromWorld[1][1] = -1.0;
    // FRotator turns about x by roll, about y by pitch, then about z by yaw. Pitch and roll count
    // against the right-hand rule.
    camera.pose = rigid(aboutByDegrees(2, pose->rotation.y) * aboutByDegrees(1, -pose->rotation.x)
                            * aboutByDegrees(0, -pose->rotation.z),
                        pose->location);
    camera.size = sizeIn(values);
    if (values.has({"relativelocation", "relativerotation"}))
        camera.assumed.push_back(tr("%1 and %2 count as the camera's pose in the world, as for a camera without "
                                    "parent. Give %3 if it has one.",
                                    "RelativeLocation", "RelativeRotation", "Location and Rotation"));
    camera.assumed.push_back(tr("Unreal's world is left-handed and in centimetres. The scene has its y negated: the "
                                "point (x, y, z) of Unreal is (x, -y, z) here, in centimetres."));
    constexpr double kUsualAngle = 90.0;
    if (!degrees)
        camera.assumed.push_back(tr("The horizontal field of view is assumed to be 90 degrees, because FOV is missing. "
                                    "Add FOV=90 with the right value to say otherwise."));
    reading.setHorizontalAngle(radiansFromDegrees(degrees.value_or(kUsualAngle)));
    return true;
}

} // namespace unprojector::cameras
