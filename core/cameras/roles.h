#pragma once

#include "core/cameras/foreign_camera.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cameras {

/// The parts of a pinhole camera.
enum class Part {
    Intrinsics,   ///< K, nine numbers by rows, or fx, fy, cx, cy
    Focal,        ///< fx, fy
    Principal,    ///< cx, cy
    Rotation,     ///< R, nine numbers by rows, or a rotation vector
    Quaternion,   ///< x, y, z, w, each with its name, or in an order that the name tells
    Translation,  ///< t
    Center,       ///< the camera's position in the world
    Pose,         ///< [R t], twelve or sixteen numbers by rows
    CameraMatrix, ///< P, twelve numbers by rows
    Distortion,   ///< a list of coefficients
    Radial,       ///< k1, k2 and perhaps k3
    Tangential,   ///< p1, p2
    Size,         ///< width, height
    Model,        ///< the name of a distortion model
    // Beside them, CameraValues has:
    Number, ///< one number with a name: "fx", "k1"
    Other,  ///< what looks like a part, but whose name says none
    Unfit,  ///< the first values of each part whose count of numbers does not fit it
    Broken, ///< a number of a camera whose name has another count of numbers, or a matrix without data
    Empty   ///< a name of a pose's part that has something else than numbers
};
inline constexpr std::size_t kParts = 14, kKinds = 19; ///< without and with those of CameraValues

constexpr bool isOfPose(Part part)
{
    return part >= Part::Rotation && part <= Part::Pose;
}

/// What a name says about the numbers behind it.
struct Role {
    Part part = Part::Pose;
    /// The direction that the name states (T_world_cam) or usually has (extrinsic); none: any.
    std::optional<PoseDirection> direction{};
    bool isDirectionStated = false;
    std::optional<EyeAxes> axes{};
    bool areAxesStated = false;
    bool areRowsFirst = false; ///< of a size: height, width
    std::size_t w = 4;         ///< the place of a quaternion's w: 0 or 3; 4: not told
    std::string world{};       ///< the frame that counts as the world, where its name is another: "imu"
};

/// The role of numbers by the words of their name: "T_world_camera", "cam_K", "extrinsics.R".
///
/// Frames are read as robotics writes them: T_a_b, a_T_b and a_from_b lead from b to a; a_to_b, a2b
/// and a_in_b lead from a to b.
/// @param count  of the numbers; it decides between t and T
/// @return nothing for a name without a part, with a word that makes it another thing ("pose_std"),
///         or for a transform between two cameras
std::optional<Role> roleOf(std::string_view name, std::size_t count);

/// Returns whether a name has a word of a camera's parts, whatever else it says.
bool hasPartWord(std::string_view name);

/// Returns whether a name is of angles of a rotation, or of its axis: "yaw", "rpy", "rotation_deg".
bool isAngle(std::string_view name);

/// The coefficient of a lens that a name is of: "k1" of "radial_k1", "kappa1"; empty: none.
std::string coefficientOf(std::string_view name);

/// Returns whether a number with this name looks like a camera's: "k7", "skew", "yaw".
bool isScalarOfPart(std::string_view name);

/// Returns whether a name is of a transform between two cameras: "depth_to_color".
bool isBetweenCameras(std::string_view name);

/// Returns whether a name is of another thing than a camera, its pose or its image: "display", "imu".
bool isElsewhere(std::string_view name);

/// Which of several cameras a name is of: "02" of K_02, "left" of K_left; empty: it does not say.
std::string cameraOf(std::string_view name);

} // namespace unprojector::cameras
