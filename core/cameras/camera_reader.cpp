#include "core/cameras/camera_reader.h"

#include <array>

namespace unprojector::cameras {

std::span<const CameraReader> cameraReaders()
{
    static constexpr std::array kReaders{CameraReader{"COLMAP", readColmap},
                                         CameraReader{"NeRF", readNerf},
                                         CameraReader{"Open3D", readOpen3d},
                                         CameraReader{"glTF", readGltf},
                                         CameraReader{"MuJoCo", readMujoco},
                                         CameraReader{"PyBullet", readPyBullet},
                                         CameraReader{"Blender", readBlender},
                                         CameraReader{"Unreal", readUnreal},
                                         CameraReader{"Unity", readUnity},
                                         CameraReader{"pyrender", readPyrender},
                                         CameraReader{"Gaussian splatting", readSplatting},
                                         CameraReader{"SAPIEN", readSapien},
                                         CameraReader{"OpenCV", readOpenCv}};
    return kReaders;
}

CameraRead readCamera(std::span<const NamedText> texts, const CameraChoices &choices)
{
    for (const CameraReader &reader : cameraReaders()) {
        if (CameraRead read = reader.read(texts, choices))
            return read;
    }
    return std::nullopt;
}

} // namespace unprojector::cameras
