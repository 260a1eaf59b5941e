#pragma once

#include "core/base/error.h"
#include "core/base/expected.h"
#include "core/geometry/box.h"
#include "core/geometry/matrix_projection.h"
#include "core/geometry/setup.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Cameras of other programs: from their files and printed values to a scene's projection and view.
/// Each program has a reader; all readers fill a ForeignCamera, and sceneCamera() converts it.
namespace unprojector::cameras {

/// The directions of the axes x, y, z of an eye space, as seen in the image.
enum class EyeAxes {
    RightUpBack,    ///< OpenGL, Blender, NeRF, PyBullet, MuJoCo
    RightDownAhead, ///< OpenCV, COLMAP, Open3D, ROS's optical frames
    RightUpAhead,   ///< left-handed: Direct3D, Unity's transforms
    AheadRightUp,   ///< left-handed: Unreal
    AheadLeftUp     ///< ROS's body frames
};

/// OpenGL's eye axes (right, up, back) from a camera's.
glm::dmat3 eyeFromCamera(EyeAxes axes);

/// The direction of a given pose.
enum class PoseDirection { WorldToCamera, CameraToWorld };

/// The coordinates of the centre of the first pixel, from the top-left corner: 0 or ½.
enum class PixelCentres { AtIntegers, AtHalves };

/// The position of the first pixel's centre from the image's corner, less its coordinate; pixels.
constexpr double cornerToCentre(PixelCentres centres)
{
    return centres == PixelCentres::AtIntegers ? 0.5 : 0.0;
}

/// A pinhole's numbers, in pixels from the top-left corner: x = fx X/Z + skew Y/Z + cx,
/// y = fy Y/Z + cy, with X right, Y down, Z ahead.
struct Intrinsics {
    double fx = 1.0, fy = 1.0, cx = 0.0, cy = 0.0, skew = 0.0;
    PixelCentres centres = PixelCentres::AtIntegers;
    /// cx and cy follow from the image's size. They count from its corner, and a choice of centres
    /// does not move them.
    bool isCentreComputed = false;
};

/// The coefficients of Brown and Conrady, as OpenCV numbers them.
struct Distortion {
    double k1 = 0.0, k2 = 0.0, p1 = 0.0, p2 = 0.0, k3 = 0.0;
    bool isNone() const { return k1 == 0.0 && k2 == 0.0 && p1 == 0.0 && p2 == 0.0 && k3 == 0.0; }
    friend bool operator==(const Distortion &, const Distortion &) = default;
};

/// Width and height of the image, pixels.
struct ImageSize {
    int width = 0, height = 0;
    friend bool operator==(const ImageSize &, const ImageSize &) = default;
};

/// A value of a text, and the part of the camera that it gave.
struct ReadValue {
    enum class Of { Lens, Pose, Distortion, Image };

    Of of = Of::Lens;
    std::string name; ///< as written: "K"
    std::size_t line = 0;
};

/// A camera as another program gives it, before conversion.
struct ForeignCamera {
    std::string program;             ///< whose form it is: "OpenCV", "COLMAP"
    std::vector<std::string> images; ///< all images or frames of the texts, in their order; empty: only this one
    std::size_t image = 0;           ///< the index of the one read, among `images`
    std::vector<std::string> files;  ///< the names of the texts that have a part of it
    std::optional<Intrinsics> intrinsics;
    std::optional<geometry::MatrixProjection> projection; ///< instead of intrinsics; OpenGL's clip space
    std::optional<ImageSize> size;
    std::optional<double> nearDistance, farDistance;
    std::optional<glm::dmat4> pose; ///< column vectors; the camera's axes are `axes`
    PoseDirection direction = PoseDirection::WorldToCamera;
    bool isDirectionCertain = false; ///< the names or the program tell it; else sceneCamera() decides
    bool isDirectionOpen = false;    ///< neither is usual: sceneCamera() refuses what the objects do not decide
    std::string poseName;            ///< its name in the text, where that tells or suggests the direction
    /// The camera's position in the world. `pose` is its rotation alone then.
    std::optional<glm::dvec3> center;
    EyeAxes axes = EyeAxes::RightUpBack;
    bool areAxesCertain = false; ///< as isDirectionCertain
    /// The transform from the program's world to a right-handed one; the identity for right-handed
    /// worlds.
    glm::dmat4 rightHandedFromWorld{1.0};
    std::optional<Distortion> distortion;
    std::vector<ReadValue> read;      ///< as far as its reader notes them
    std::vector<std::string> assumed; ///< one sentence each, in the language of base::tr()
};

/// The choices of the user about a camera. Empty members are taken from the file or assumed.
struct CameraChoices {
    std::string image; ///< the image's or frame's name, or a frame's index from 0; empty: the only one, else the first
    std::optional<ImageSize> size;
    std::optional<double> nearDistance, farDistance;
    std::optional<EyeAxes> axes;
    std::optional<PoseDirection> direction;
    std::optional<PixelCentres> centres;
    bool isUndistorted = false; ///< pixels are of the undistorted image; the coefficients are dropped with a message

    /// Returns whether the user says nothing but the size.
    bool isNothing() const
    {
        return image.empty() && !nearDistance && !farDistance && !axes && !direction && !centres && !isUndistorted;
    }
};

/// The largest file that is read for a camera, bytes. A .glb has its meshes beside the camera.
inline constexpr std::size_t kMostCameraBytes = std::size_t{256} << 20;

/// A text with its name, for messages.
struct NamedText {
    std::string name, text;
};

/// A scene's camera. Its eye space is OpenGL's; pixels count as everywhere in the program.
struct SceneCamera {
    geometry::Lens projection; ///< a pinhole, or the file's matrix
    glm::dmat4 eyeFromWorld{1.0};
    ImageSize size;
    std::optional<Distortion> distortion;                   ///< of its pixels, where it was not dropped
    std::optional<Intrinsics> intrinsics;                   ///< of the file, for undistorting pixels
    PoseDirection direction = PoseDirection::WorldToCamera; ///< as read
    EyeAxes axes = EyeAxes::RightUpBack;                    ///< as read
    std::optional<double> nearDistance, farDistance;        ///< given or assumed; none: the file has a projection
    std::vector<std::string> assumed; ///< what was assumed, and how to say otherwise; one sentence each
};

/// Reads the camera in these texts; the texts of one program belong together (cameras.txt and
/// images.txt).
/// @return nothing if no text has the form of a known program; an error with its file and line
std::optional<base::Expected<ForeignCamera, base::Error>> readCamera(std::span<const NamedText> texts,
                                                                     const CameraChoices &choices);

/// Converts a camera. Where neither the file nor the choices tell the pose's direction or the axes,
/// those count with which the camera sees the objects; a message names them.
/// @param objects  bounds of the scene's objects, world space; empty: no objects, then the
///         program's usual direction and axes count
base::Expected<SceneCamera, base::Error> sceneCamera(const ForeignCamera &camera, const CameraChoices &choices,
                                                     const std::optional<geometry::Box> &objects);

/// Returns whether CameraChoices::centres counts: whether the camera's file has a principal point.
bool hasCentres(const ForeignCamera &camera);

/// The words for axes and directions on the command line: "opencv", "camera-to-world".
inline constexpr std::array kEyeAxes{EyeAxes::RightUpBack, EyeAxes::RightDownAhead, EyeAxes::RightUpAhead,
                                     EyeAxes::AheadRightUp, EyeAxes::AheadLeftUp};
const char *keyOf(EyeAxes axes);
const char *keyOf(PoseDirection direction);
const char *keyOf(PixelCentres centres);

} // namespace unprojector::cameras
