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

} // namespace unprojector::cameras
