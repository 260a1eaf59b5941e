#pragma once

#include "core/cameras/foreign_camera.h"

#include <span>

namespace unprojector::cameras {

/// The camera that a reader finds; nothing if the texts do not have its program's form.
using CameraRead = std::optional<geometry::Result<ForeignCamera, CameraError>>;

/// The reader of a program's cameras. A new program takes a function here and a line in
/// camera_reader.cpp.
struct CameraReader {
    const char *program = "";
    CameraRead (*read)(std::span<const NamedText> texts, const CameraChoices &choices) = nullptr;
};

/// All readers. The first that recognises the texts reads them: the most particular form is first.
std::span<const CameraReader> cameraReaders();

/// K, R, t and distortion coefficients: text, JSON, the YAML and XML of cv::FileStorage, ROS's
/// camera_info.
CameraRead readOpenCv(std::span<const NamedText> texts, const CameraChoices &choices);

/// cameras.txt and images.txt.
CameraRead readColmap(std::span<const NamedText> texts, const CameraChoices &choices);
/// transforms.json of NeRF, Instant-NGP and Nerfstudio; one frame of it too.
CameraRead readNerf(std::span<const NamedText> texts, const CameraChoices &choices);
/// Its JSON: camera parameters, trajectories, and the view of its viewer.
CameraRead readOpen3d(std::span<const NamedText> texts, const CameraChoices &choices);
/// glTF and GLB with a camera.
CameraRead readGltf(std::span<const NamedText> texts, const CameraChoices &choices);
/// The printed camera of MuJoCo: cam_xpos, cam_xmat and cam_fovy, or the fields of mjvGLCamera.
CameraRead readMujoco(std::span<const NamedText> texts, const CameraChoices &choices);
/// The printed matrices of computeViewMatrix and computeProjectionMatrix, or the list of
/// getDebugVisualizerCamera.
CameraRead readPyBullet(std::span<const NamedText> texts, const CameraChoices &choices);
/// matrix_world with lens or angle, as its Python console prints them.
CameraRead readBlender(std::span<const NamedText> texts, const CameraChoices &choices);
/// Printed matrices, or position, rotation and fieldOfView.
CameraRead readUnity(std::span<const NamedText> texts, const CameraChoices &choices);
/// Location, rotation and FOV.
CameraRead readUnreal(std::span<const NamedText> texts, const CameraChoices &choices);
/// A camera's pose with yfov; trimesh's camera_transform with fov.
CameraRead readPyrender(std::span<const NamedText> texts, const CameraChoices &choices);
/// cameras.json, or the printed world_view_transform and full_proj_transform.
CameraRead readSplatting(std::span<const NamedText> texts, const CameraChoices &choices);
/// extrinsic_cv or cam2world_gl with intrinsic_cv, as ManiSkill prints them.
CameraRead readSapien(std::span<const NamedText> texts, const CameraChoices &choices);

} // namespace unprojector::cameras
