#pragma once

#include "core/cameras/reader_parts.h"

#include <optional>
#include <span>

namespace unprojector::cameras {

// A new program takes a function here and a line in camera_reader.cpp. A function returns false or
// nothing if the text does not have its program's form.

/// K, R, t and distortion coefficients: text, JSON, the YAML and XML of cv::FileStorage, ROS's
/// camera_info.
std::optional<ForeignCamera> readNamedParts(std::span<const NamedText> texts, const CameraChoices &choices);
/// cameras.txt and images.txt.
std::optional<ForeignCamera> readColmap(std::span<const NamedText> texts, const CameraChoices &choices);
/// transforms.json of NeRF, Instant-NGP and Nerfstudio; one frame of it too.
std::optional<ForeignCamera> readNerf(std::span<const NamedText> texts, const CameraChoices &choices);
/// Its JSON: camera parameters, trajectories, and the view of its viewer.
bool readOpen3d(Reading &reading);
/// glTF and GLB with a camera.
bool readGltf(Reading &reading);
/// The printed camera of MuJoCo: cam_xpos, cam_xmat and cam_fovy, or the fields of mjvGLCamera.
bool readMujoco(Reading &reading);
/// The printed matrices of computeViewMatrix and computeProjectionMatrix, or the list of
/// getDebugVisualizerCamera.
bool readPyBullet(Reading &reading);
/// matrix_world with lens or angle, as its Python console prints them.
bool readBlender(Reading &reading);
/// Printed matrices, or position, rotation and fieldOfView.
bool readUnity(Reading &reading);
/// Location, rotation and FOV.
bool readUnreal(Reading &reading);
/// A camera's pose with yfov; trimesh's camera_transform with fov.
bool readPyrender(Reading &reading);
/// cameras.json, or the printed world_view_transform and full_proj_transform.
bool readSplatting(Reading &reading);
/// sfm_data.json.
bool readOpenMvg(Reading &reading);
/// cameras.sfm of AliceVision and Meshroom.
bool readAliceVision(Reading &reading);
/// reconstruction.json of OpenSfM and ODM.
bool readOpenSfm(Reading &reading);
/// camera_path.json of Nerfstudio's viewer.
bool readCameraPath(Reading &reading);
/// scene_camera.json, and camera.json, which has the image's size.
std::optional<ForeignCamera> readBop(std::span<const NamedText> texts, const CameraChoices &choices);
/// calibrated_sensor.json, or one record of it.
bool readNuScenes(Reading &reading);
/// A key frame's JSON.
bool readPolycam(Reading &reading);
/// A frame's JSON of 3D Scanner App: cameraPoseARFrame and intrinsics.
bool readArKit(Reading &reading);
/// The metadata of a .r3d file.
bool readRecord3d(Reading &reading);
/// A camera of Object3D.toJSON or of its editor.
bool readThree(Reading &reading);
/// extrinsic_cv or cam2world_gl with intrinsic_cv, as ManiSkill prints them.
bool readSapien(Reading &reading);
/// cameras.xml of Metashape and PhotoScan.
bool readMetashape(Reading &reading);
/// A view or project of MeshLab.
bool readMeshLab(Reading &reading);
/// XMP beside an image.
bool readRealityCapture(Reading &reading);
/// A camera of SDF.
bool readGazebo(Reading &reading);
/// A camera of MJCF.
bool readMjcf(Reading &reading);
/// A perspective sensor of a scene.
bool readMitsuba(Reading &reading);
/// A lens with poses in a file of numbers: TUM, KITTI, Replica, 7-Scenes, ScanNet; DSO's camera.txt.
std::optional<ForeignCamera> readTables(std::span<const NamedText> texts, const CameraChoices &choices);
/// A camera file with its line of depths.
bool readMvsNet(Reading &reading);
/// The KRT file of Multiface.
bool readKrt(Reading &reading);
/// calib.txt of a stereo pair.
bool readMiddlebury(Reading &reading);
/// bundle.out.
bool readBundler(Reading &reading);
/// A printed Camera and Rigid3d.
bool readPycolmap(Reading &reading);
/// The camera of VTK, ParaView and PyVista.
bool readVtk(Reading &reading);
/// Calib_Results.m of Bouguet's toolbox.
bool readBouguet(Reading &reading);
/// calibration.toml.
bool readAnipose(Reading &reading);
/// camera-parameters.json.
bool readHuman36m(Reading &reading);
/// A camera of a .usda file.
bool readUsd(Reading &reading);
/// A Camera3D of a scene, or its printed transform.
bool readGodot(Reading &reading);
/// Its JSON: cameraTransform and relativeFocalLength.
bool readFspy(Reading &reading);
/// camera_data of NVISII, as DOPE has it.
bool readDope(Reading &reading);
/// A camera of its sensors' JSON.
bool readLgsvl(Reading &reading);

} // namespace unprojector::cameras
