#include "core/cli/commands/camera_scene.h"

#include "core/base/path_text.h"
#include "core/base/translation.h"
#include "core/cameras/lens.h"
#include "core/cli/commands/opened_scene.h"
#include "core/cli/commands/size_text.h"
#include "core/scene_file/scene_error_text.h"
#include "core/scene_file/scene_file.h"

#include <utility>

namespace unprojector::cli {
using namespace cameras;
using namespace geometry;
using namespace scene_file;
using base::tr;

std::optional<Box> addObjects(const SceneOptions &options, InputFiles &inputs, SceneFile &scene)
{
    Box bounds;
    const std::filesystem::path sceneFile = base::pathFromUtf8(options.output == "-" ? "scene.json" : options.output);
    for (const std::string &file : options.objects) {
        const std::optional<OpenedScene> opened = openScene(file);
        if (!opened)
            return std::nullopt;
        inputs.insert(inputs.end(), opened->files.begin(), opened->files.end());
        for (const scene::SceneObject &object : opened->objects) {
            scene.objects.push_back(sceneFileObject(object, sceneFile));
            if (!object.isHidden)
                bounds.add(scene::boundsOf(object));
        }
    }
    return bounds;
}

ExitCode writeScene(const SceneOptions &options, const InputFiles &inputs, const SceneFile &scene)
{
    ByteSink sink(options.output, inputs);
    if (!sink.isOpen())
        return ExitCode::UnusableInput;
    const auto written = sceneText(scene);
    const auto readAgain = written ? parseScene(*written, options.output == "-" ? "scene" : options.output)
                                   : Result<SceneFile, SceneFileError>(written.error());
    if (!readAgain) {
        complain(sceneErrorText(readAgain.error()));
        return ExitCode::UnusableInput;
    }
    sink.write(*written);
    return sink.finish();
}

std::optional<ExitCode> runCameraScene(const SceneOptions &options, const GivenTexts &given)
{
    CameraChoices choices = options.camera;
    const std::string &sizeText = options.size.empty() ? options.window : options.size;
    if (!sizeText.empty()) {
        const std::optional<SizeGiven> size = sizeGiven(options.size.empty() ? "--window" : "--size", sizeText);
        if (!size)
            return ExitCode::UnusableInput;
        choices.size = ImageSize{size->width, size->height};
    }
    const auto read = readCamera(given.texts, choices);
    if (!read)
        return std::nullopt;
    const auto complainOf = [&given](const CameraError &error) { complain(cameraErrorText(error, given.name)); };
    if (!*read) {
        complainOf(read->error());
        return ExitCode::UnusableInput;
    }
    SceneFile scene;
    InputFiles inputs = given.files;
    const std::optional<Box> bounds = addObjects(options, inputs, scene);
    if (!bounds)
        return ExitCode::UnusableInput;
    const ForeignCamera &camera = **read;
    const auto converted = sceneCamera(camera, choices, bounds->isEmpty() ? std::nullopt : bounds);
    if (!converted) {
        complainOf(converted.error());
        return ExitCode::UnusableInput;
    }
    if (converted->distortion) {
        complain(given.name + ": "
                 + tr("the lens distorts the image (%1), and a scene has no lens. If the pixels are those of the "
                      "undistorted image, give --undistorted. Else make the scene with --undistorted and give the "
                      "coefficients to 'unproject points --distortion'",
                      coefficientsText(*converted->distortion)));
        return ExitCode::UnusableInput;
    }
    for (const std::string &sentence : converted->assumed)
        complain(given.name + ": " + sentence);

    scene.windowWidth = converted->size.width;
    scene.windowHeight = converted->size.height;
    scene.isWindowFixed = true; // another size would move the principal point
    scene.viewport = Viewport{0.0, 0.0, double(converted->size.width), double(converted->size.height)};
    std::visit([&scene](const auto &lens) { scene.projection = lens; }, converted->projection);
    scene.view = converted->eyeFromWorld;
    scene.conventions = options.conventions;
    return writeScene(options, inputs, scene);
}

} // namespace unprojector::cli
