#include "core/cameras/camera_reader.h"

namespace unprojector::cameras {

CameraRead readOpenCv(std::span<const NamedText>, const CameraChoices &)
{
    return std::nullopt;
}

} // namespace unprojector::cameras
