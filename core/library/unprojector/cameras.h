#pragma once

#include "unprojector/setup.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace unprojector {

/// The user's choices about another program's camera. Empty members are taken from the file or
/// assumed.
struct CameraChoices {
    /// The image's or frame's name, or a frame's index from 0; empty: the only one, else the first.
    std::string image;
    int width = 0, height = 0; ///< of the image, pixels; 0: the file's
    std::optional<double> nearDistance, farDistance;
    std::string axes;           ///< "opengl", "opencv", "direct3d", "unreal", "ros"; empty: by the program
    std::string pose;           ///< "world-to-camera" or "camera-to-world"; empty: by the program
    std::string pixelCenters;   ///< "integer" or "half", of the first pixel; "pixel_centers" in messages
    bool isUndistorted = false; ///< pixels are of the undistorted image
};

struct CameraText {
    std::string name, text;
};

/// A camera that was read.
struct CameraRead {
    Setup setup;
    std::string program;              ///< whose form the text has: "OpenCV", "COLMAP"
    std::vector<std::string> images;  ///< all images or frames of the texts
    std::vector<std::string> assumed; ///< what was assumed, and how to say otherwise; one sentence each
};

/// Reads the camera in the texts of another program: OpenCV, ROS, COLMAP, NeRF, Open3D, glTF, MuJoCo,
/// PyBullet, Blender, Unity, Unreal, pyrender, Gaussian splatting, SAPIEN.
/// @return Value: the file, the line and the value that are wrong; no known form
UNPROJECTOR_PUBLIC Result<CameraRead> readCamera(const std::vector<CameraText> &texts,
                                                 const CameraChoices &choices = {});
/// The same from files.
/// @return File: a file that cannot be read
UNPROJECTOR_PUBLIC Result<CameraRead> readCamera(const std::vector<std::filesystem::path> &files,
                                                 const CameraChoices &choices = {});

} // namespace unprojector
