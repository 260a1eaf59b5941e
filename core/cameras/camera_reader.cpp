#include "core/cameras/camera_reader.h"

#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/geometry/finite.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace unprojector::cameras {
using base::tr;

namespace {

using CameraRead = std::optional<base::Expected<ForeignCamera, base::Error>>;

/// The reader of a program's cameras: of one text, or of texts that belong together.
struct CameraReader {
    const char *program = "";
    bool (*read)(Reading &reading) = nullptr;
    std::optional<ForeignCamera> (*readAll)(std::span<const NamedText> texts, const CameraChoices &choices) = nullptr;
};

/// The first that recognises the texts reads them: the most particular form is first.
constexpr std::array kReaders{CameraReader{"COLMAP", nullptr, readColmap},
                              CameraReader{"Metashape", readMetashape},
                              CameraReader{"MeshLab", readMeshLab},
                              CameraReader{"RealityCapture", readRealityCapture},
                              CameraReader{"Gazebo", readGazebo},
                              CameraReader{"MuJoCo", readMjcf},
                              CameraReader{"Mitsuba", readMitsuba},
                              CameraReader{"pycolmap", readPycolmap},
                              CameraReader{"Bundler", readBundler},
                              CameraReader{"MVSNet", readMvsNet},
                              CameraReader{"Multiface", readKrt},
                              CameraReader{"Middlebury", readMiddlebury},
                              CameraReader{"OpenMVG", readOpenMvg},
                              CameraReader{"AliceVision", readAliceVision},
                              CameraReader{"OpenSfM", readOpenSfm},
                              CameraReader{"Nerfstudio", readCameraPath},
                              CameraReader{"BOP", nullptr, readBop},
                              CameraReader{"nuScenes", readNuScenes},
                              CameraReader{"Polycam", readPolycam},
                              CameraReader{"ARKit", readArKit},
                              CameraReader{"Record3D", readRecord3d},
                              CameraReader{"three.js", readThree},
                              CameraReader{"Human3.6M", readHuman36m},
                              CameraReader{"fSpy", readFspy},
                              CameraReader{"NVISII", readDope},
                              CameraReader{"LGSVL", readLgsvl},
                              CameraReader{"NeRF", nullptr, readNerf},
                              CameraReader{"Open3D", readOpen3d},
                              CameraReader{"glTF", readGltf},
                              CameraReader{"MuJoCo", readMujoco},
                              CameraReader{"PyBullet", readPyBullet},
                              CameraReader{"VTK", readVtk},
                              CameraReader{"USD", readUsd},
                              CameraReader{"Godot", readGodot},
                              CameraReader{"Blender", readBlender},
                              CameraReader{"Unreal", readUnreal},
                              CameraReader{"Unity", readUnity},
                              CameraReader{"pyrender", readPyrender},
                              CameraReader{"Gaussian splatting", readSplatting},
                              CameraReader{"SAPIEN", readSapien},
                              CameraReader{"Bouguet's toolbox", readBouguet},
                              CameraReader{"Anipose", readAnipose},
                              CameraReader{"DSO", nullptr, readTables},
                              CameraReader{"OpenCV", nullptr, readNamedParts}};

/// The reader that recognises the texts, with what it reads.
std::pair<const CameraReader *, CameraRead> firstRead(std::span<const NamedText> texts, const CameraChoices &choices)
{
    std::vector<Reading> readings;
    for (const NamedText &text : texts)
        readings.emplace_back(text, choices);
    for (const CameraReader &reader : kReaders) {
        try {
            if (reader.readAll) {
                if (auto camera = reader.readAll(texts, choices))
                    return {&reader, std::move(*camera)};
                continue;
            }
            for (Reading &reading : readings) {
                if (reader.read(reading)) {
                    reading.camera.files = {reading.text.name};
                    return {&reader, std::move(reading.camera)};
                }
                reading.camera = {};
            }
        } catch (base::Error &error) {
            return {&reader, std::move(error)};
        }
    }
    return {nullptr, std::nullopt};
}

/// The error of files of several programs, of which all but one would be ignored.
std::optional<base::Error> mixedError(std::span<const NamedText> texts, const CameraChoices &choices,
                                      const CameraReader *reader)
{
    std::string list;
    bool hasSame = false, hasOther = false;
    for (const NamedText &text : texts) {
        const CameraReader *alone = firstRead({&text, 1}, choices).first;
        hasSame = hasSame || alone == reader;
        hasOther = hasOther || (alone && alone != reader);
        if (alone)
            list += (list.empty() ? "" : ", ") + text.name + " (" + alone->program + ')';
    }
    if (!hasSame || !hasOther)
        return std::nullopt;
    return base::Error{.text = tr("the files are of several programs: %1. Give those of one program", list),
                       .file = texts.front().name};
}

/// The error of a camera with numbers that no camera has.
std::optional<std::string> reasonAgainst(const ForeignCamera &camera, const CameraChoices &choices)
{
    if ((camera.pose && !geometry::isFinite(*camera.pose))
        || (camera.projection && !geometry::isFinite(camera.projection->clipFromEye)))
        return tr("a number is not finite");
    if (!camera.intrinsics)
        return std::nullopt;
    const Intrinsics &k = *camera.intrinsics;
    if (!std::isfinite(k.fx + k.fy + k.cx + k.cy + k.skew))
        return tr("a number is not finite");
    for (const auto &[name, value] : {std::pair("fx", k.fx), std::pair("fy", k.fy)}) {
        if (value < 0.0)
            return tr("the focal length %1 is %2; it must be greater than 0", name, base::shortestText(value));
    }
    const std::optional<ImageSize> size = choices.size ? choices.size : camera.size;
    constexpr double kLargest = 20.0; // in image widths; an angle of 3 degrees
    const bool isNormalized = k.cx > 0.0 && k.cx < 1.0 && k.cy > 0.0 && k.cy < 1.0
                              && ((k.fx < kLargest && k.fy < kLargest) || !k.isCentreComputed);
    if (isNormalized && !(size && size->width <= 2 && size->height <= 2))
        return tr("fx %1, fy %2, cx %3, cy %4 are no pixels; they look normalized. Multiply fx and cx by the image's "
                  "width, fy and cy by its height",
                  base::shortestText(k.fx), base::shortestText(k.fy), base::shortestText(k.cx),
                  base::shortestText(k.cy));
    return std::nullopt;
}

} // namespace

std::optional<base::Expected<ForeignCamera, base::Error>> readCamera(std::span<const NamedText> texts,
                                                                     const CameraChoices &choices)
{
    if (texts.empty())
        return std::nullopt;
    auto [reader, read] = firstRead(texts, choices);
    if (!read)
        return std::nullopt;
    if (texts.size() > 1) {
        if (auto error = mixedError(texts, choices, reader))
            return *error;
    }
    if (!*read)
        return std::move(read);
    ForeignCamera camera = **read;
    for (const NamedText &text : texts.size() > 1 ? texts : std::span<const NamedText>()) {
        if (std::find(camera.files.begin(), camera.files.end(), text.name) == camera.files.end())
            return base::Error{.text = tr("nothing in it is read; leave it out, or give its numbers the names of a "
                                          "camera's parts"),
                               .file = text.name};
    }
    if (auto reason = reasonAgainst(camera, choices))
        return base::Error{.text = std::move(*reason), .file = texts.size() == 1 ? texts.front().name : std::string()};
    for (std::optional<double> *distance : {&camera.nearDistance, &camera.farDistance}) {
        if (*distance && !std::isfinite(**distance))
            distance->reset(); // "far: inf", as if it were missing
    }
    return camera;
}

} // namespace unprojector::cameras
