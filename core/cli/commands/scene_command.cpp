#include "core/cli/commands/scene_command.h"

#include "core/base/path_text.h"
#include "core/base/translation.h"
#include "core/cameras/lens.h"
#include "core/cameras/pasted_camera.h"
#include "core/cli/commands/command.h"
#include "core/cli/commands/inputs.h"
#include "core/cli/terminal/refusal.h"
#include "core/pipeline/decomposition.h"
#include "core/pipeline/matrix_findings.h"
#include "core/pipeline/matrix_format.h"
#include "core/scene_file/scene_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace unprojector::cli {
using namespace cameras;
using namespace geometry;
using namespace pipeline;
using namespace scene_file;
using base::tr;
namespace {

/// The remedy for a finding, by an option or by hand.
/// @param hasConventions  an option names the matrices' API, which determines depths and y
std::string adviceFor(const MatrixFinding &finding, NumberOrder order, bool hasConventions)
{
    switch (finding.fault) {
    case MatrixFault::Transposed:
    case MatrixFault::OtherOrder:
    case MatrixFault::OrderOfOthers:
        return tr(order == NumberOrder::ByColumns ? "; read by columns, --order row reads it by rows"
                                                  : "; read by rows, --order column reads it by columns");
    case MatrixFault::OrderOpen: return tr("; give --order row or --order column");
    case MatrixFault::Inverse: return tr("; if it is, give its inverse");
    case MatrixFault::Exchanged: return tr("; give each behind its name, modelview and projection");
    case MatrixFault::DepthZeroToOne:
        return tr(hasConventions ? "; --conventions of an API with such depths reads it so"
                                 : "; --depth zero-to-one reads it so, --depth minus-one-to-one does not");
    case MatrixFault::DepthReversed: return tr("; the depths of clicks must be reversed too; give --reversed");
    case MatrixFault::YDown:
        return tr(hasConventions ? "; it is not changed: if it is unwanted, give --conventions of its API"
                                 : "; --y down flips it back, --y up keeps it");
    case MatrixFault::Rounded: return tr("; --orthonormal uses the nearest axes that are");
    case MatrixFault::Negated: return tr("; its signs are flipped");
    case MatrixFault::UnknownForm: return tr(": only the inverted matrix will answer");
    case MatrixFault::Mirrored:
    case MatrixFault::Scaled:
    case MatrixFault::FarAtInfinity:
    case MatrixFault::LeftHanded: break;
    }
    return {};
}

/// Reports the findings about the matrices of a text, unless an option already resolves them.
class Findings {
public:
    /// @param name  of the text; messages begin with it
    Findings(const SceneOptions &options, const PastedCamera &camera, const std::string &name)
        : m_options(options), m_camera(camera), m_name(name)
    {
    }

    /// @return whether the order of all matrices is known; if not, a message asks for the option
    bool say() const
    {
        std::vector<ReadMatrix> all(m_camera.matrices.rbegin(), m_camera.matrices.rend()); // the view first
        if (m_camera.viewportMatrix)
            all.push_back(*m_camera.viewportMatrix);
        const auto isOrder = [](const MatrixFinding &finding) {
            return finding.fault == MatrixFault::OtherOrder || finding.fault == MatrixFault::OrderOfOthers
                   || finding.fault == MatrixFault::OrderOpen;
        };
        const bool isOpen = std::ranges::any_of(all, [](const ReadMatrix &one) {
            return std::ranges::any_of(
                one.findings, [](const MatrixFinding &finding) { return finding.fault == MatrixFault::OrderOpen; });
        });
        for (const ReadMatrix &one : all) {
            for (const MatrixFinding &finding : one.findings) {
                if (isOrder(finding))
                    say(one.part, findingText(finding, one.role) + advice(finding, one));
            }
        }
        if (isOpen)
            return false;
        for (const ReadMatrix &one : all) {
            sayRole(one);
            for (const MatrixFinding &finding : one.findings) {
                if (!isOrder(finding))
                    say(one, finding);
            }
            if (one.role == MatrixRole::Product)
                say(one.part, m_camera.apart ? decompositionText(*m_camera.apart)
                                             : tr("it cannot be decomposed: only the inverted matrix will answer, "
                                                  "because the formulas need projection and view"));
        }
        for (const std::string &note : m_camera.notes)
            complain(m_name + ": " + note);
        for (const std::string &aside : m_camera.aside)
            complain(tr("%1: %2: its numbers belong to no matrix, and are not used", m_name, aside));
        return true;
    }

private:
    void say(PastedPart part, const std::string &what) const { complain(m_name + ": " + nameOf(part) + ": " + what); }

    std::string advice(const MatrixFinding &finding, const ReadMatrix &one) const
    {
        return adviceFor(finding, one.order, m_options.conventions.has_value());
    }

    /// Reports how a matrix was made.
    void sayRole(const ReadMatrix &one) const
    {
        if (one.given.isInverse)
            say(one.part, inverseText(one.given));
        if (!one.given.call.empty())
            say(one.part, one.given.call);
    }

    void say(const ReadMatrix &one, const MatrixFinding &finding) const
    {
        if (!isResolved(finding))
            say(one.part, taken(findingText(finding, one.role)) + advice(finding, one));
        if (finding.fault == MatrixFault::Scaled && m_options.isOrthonormal)
            say(one.part,
                tr(finding.repair == MatrixRepair::None
                       ? "--orthonormal is for rounded axes and would change "
                         "this camera; give the view without the model's scale"
                       : "--orthonormal removes the model's scale; near, far and eye coordinates stay unchanged, "
                         "so world coordinates are in eye units"));
    }

    bool isResolved(const MatrixFinding &finding) const
    {
        return (finding.fault == MatrixFault::DepthReversed && m_options.isReversed)
               || (finding.fault == MatrixFault::YDown && m_options.isYDown)
               || (finding.fault == MatrixFault::Rounded && m_options.isOrthonormal);
    }

    /// The finding worded for the matrix converted to OpenGL's conventions.
    std::string taken(const std::string &finding) const
    {
        const Api api = m_options.conventions.value_or(Api::OpenGl);
        return api == Api::OpenGl
                   ? finding
                   : tr("converted from %1's conventions to OpenGL's, it %2", conventionsOf(api).name, finding);
    }

    const SceneOptions &m_options;
    const PastedCamera &m_camera;
    const std::string &m_name;
};

/// The corrections that the options wish, and those that change no point.
std::vector<Correction> corrections(const SceneOptions &options, const PastedCamera &camera)
{
    std::vector<Correction> list;
    for (const ReadMatrix &one : camera.matrices) {
        for (const MatrixFinding &finding : one.findings) {
            if (finding.fault == MatrixFault::Negated && one.role != MatrixRole::Product)
                list.push_back({one.role, finding});
        }
        const bool isView = one.role == MatrixRole::View;
        if (isView && options.isOrthonormal && one.matrix[3][3] != 0.0)
            list.push_back({one.role, {MatrixFault::Rounded, MatrixRepair::Orthonormal}});
        if (!isView && options.isYDown.value_or(false))
            list.push_back({one.role, {MatrixFault::YDown, MatrixRepair::TurnY}});
    }
    return list;
}

/// Adds the objects of --objects to a scene, and their files to the inputs.
/// @return their bounds, empty without objects
Box addObjects(const SceneOptions &options, InputFiles &inputs, SceneFile &scene)
{
    Box bounds;
    const std::filesystem::path sceneFile = base::pathFromUtf8(options.output == "-" ? "scene.json" : options.output);
    for (const std::string &file : options.objects) {
        const OpenedScene opened = openScene(file);
        inputs.insert(inputs.end(), opened.files.begin(), opened.files.end());
        for (const scene::SceneObject &object : opened.objects) {
            scene.objects.push_back(sceneFileObject(object, sceneFile));
            if (!object.isHidden)
                bounds.add(scene::boundsOf(object));
        }
    }
    return bounds;
}

/// Writes a scene after the reader has accepted it: that checks a scene's limits.
ExitCode writeScene(const SceneOptions &options, const InputFiles &inputs, const SceneFile &scene)
{
    ByteSink sink(options.output, inputs);
    const auto written = sceneText(scene);
    const auto readAgain = written ? parseScene(*written, options.output == "-" ? "scene" : options.output)
                                   : SceneOrError(written.error());
    if (!readAgain)
        refuse(readAgain.error().message());
    sink.write(*written);
    return sink.finish();
}

/// The size of --size, else of --window.
std::optional<ImageSize> imageSize(const SceneOptions &options)
{
    const std::string &given = options.size.empty() ? options.window : options.size;
    return given.empty() ? std::nullopt : std::optional(sizeGiven(options.size.empty() ? "--window" : "--size", given));
}

/// Makes a scene from another program's camera. Assumptions are printed on stderr.
ExitCode cameraScene(const SceneOptions &options, const GivenTexts &given, const SceneCamera &camera,
                     const InputFiles &inputs, SceneFile &scene)
{
    if (camera.distortion)
        refuse(given.name + ": "
               + tr("the lens distorts the image (%1), and a scene has no lens. If the pixels are those of the "
                    "undistorted image, give --undistorted. Else make the scene with --undistorted and give the "
                    "coefficients to 'unproject points --distortion'",
                    coefficientsText(*camera.distortion)));
    for (const std::string &sentence : camera.assumed)
        complain(given.name + ": " + sentence);

    scene.windowWidth = camera.size.width;
    scene.windowHeight = camera.size.height;
    scene.isWindowFixed = true; // another size would move the principal point
    scene.viewport = Viewport{0.0, 0.0, double(camera.size.width), double(camera.size.height)};
    std::visit([&scene](const auto &lens) { scene.projection = lens; }, camera.projection);
    scene.view = camera.eyeFromWorld;
    scene.conventions = options.conventions;
    return writeScene(options, inputs, scene);
}

/// Sets the window's size: the requested one, or up to the viewport's edge.
/// @param viewport   in pixels from the bottom left; where pixels count from the top, from the
///         window's top left corner with y up
/// @return in pixels from the bottom left
Viewport setWindow(const SceneOptions &options, Viewport viewport, bool isFromTop, SceneFile &scene)
{
    const double bottomFromTop = -viewport.y;
    if (!options.window.empty()) {
        const ImageSize size = sizeGiven("--window", options.window);
        scene.windowWidth = size.width;
        scene.windowHeight = size.height;
    } else {
        const double width = std::ceil(viewport.x + viewport.width),
                     height = std::ceil(isFromTop ? bottomFromTop : viewport.y + viewport.height);
        if (!(width >= 1.0 && height >= 1.0 && width <= kMostWindowPixels && height <= kMostWindowPixels))
            refuse(tr("viewport: it reaches beyond any window; give four numbers, x y width height, in pixels"));
        scene.windowWidth = static_cast<int>(width);
        scene.windowHeight = static_cast<int>(height);
        if (viewport.x > 0.0 || (isFromTop ? bottomFromTop - viewport.height : viewport.y) > 0.0)
            complain(tr("the window is assumed to end with the viewport, at %1x%2; py counts from its top: give its "
                        "size with --window",
                        scene.windowWidth, scene.windowHeight));
    }
    if (isFromTop)
        viewport.y += scene.windowHeight;
    return viewport;
}

bool isOriginTop(const SceneOptions &options)
{
    return conventionsOf(options.conventions.value_or(Api::OpenGl)).isOriginTop;
}

/// Sets viewport, depth range and window.
void setViewport(const SceneOptions &options, const PastedCamera &camera, const std::string &name, SceneFile &scene)
{
    if (!camera.viewportMatrix) {
        scene.viewport = setWindow(options, *camera.viewport, false, scene);
        return;
    }
    if (camera.viewport->height < 0.0)
        refuse(name + ": viewport: "
               + tr(isOriginTop(options)
                        ? "its matrix flips y, as for pixels counted from the bottom: give its --conventions"
                        : "its matrix flips y, as for pixels counted from the top: give its --conventions"));
    const DepthRange &range = *camera.depthRange;
    if (!isWindowsOwn(range))
        complain(
            name + ": viewport: "
            + tr(options.depth || options.conventions
                     ? "its depths go from %1 to %2, beyond the 0 to 1 of a window; the depths of clicks must be in "
                       "this range"
                     : "its depths go from %1 to %2, beyond the 0 to 1 of a window; give their NDC depths with --depth",
                 numberText(range.atNear, Digits::Double, 5), numberText(range.atFar, Digits::Double, 5)));
    scene.depthRange = range;
    scene.viewport = setWindow(options, *camera.viewport, isOriginTop(options), scene);
}

/// Sets projection and view.
/// @param isReversed  the numbers tell that depths are reversed
void setMatrices(const SceneOptions &options, const PastedCamera &camera, bool isReversed, SceneFile &scene)
{
    auto lens = std::get<MatrixProjection>(*camera.projection);
    // Stored with the depth convention used here, so that every reader uses the same.
    if (recognised(lens))
        lens.ndcDepth = ndcDepthOf(lens);
    scene.projection = lens;
    scene.view = *camera.eyeFromWorld;
    if (options.isReversed && !isReversed)
        scene.depthRange = {1.0, 0.0};
    scene.conventions = options.conventions;
}

/// The first given option that is only about matrices.
std::string optionAboutMatrices(const SceneOptions &options)
{
    return options.conventions  ? "--conventions"
           : options.order      ? "--order"
           : options.depth      ? "--depth"
           : options.isYDown    ? "--y"
           : options.isReversed ? "--reversed"
                                : "--orthonormal";
}

/// Refuses a text without a camera.
[[noreturn]] void refuseText(const SceneOptions &options, const GivenTexts &given, const PastedCamera &camera)
{
    const std::vector<std::string> &words = options.fromMatrices.empty() ? options.from : options.fromMatrices;
    if (options.isAboutMatrices() && options.fromMatrices.empty() && readCamera(given.texts, options.camera))
        refuse(tr("%1: the text is of a camera, and %2 is only about matrices; leave it out", given.name,
                  optionAboutMatrices(options)));
    if (!camera.hasNumbers && given.files.empty() && words.size() == 1)
        refuse(words[0] + ": " + tr("there is no such file"));
    if (!camera.matrices.empty() && camera.fault->subject == nameOf(PastedPart::Viewport))
        refuse(given.name + ": "
               + tr("there is no viewport; give x y width height behind the word viewport, or the image's size with "
                    "--size"));
    base::Error error = *camera.fault;
    error.file = given.name;
    if (options.fromMatrices.empty())
        refuse(tr("%1: no camera of a known program, and no matrices (%2); the manual lists the programs under "
                  "Cameras of other programs",
                  given.name, error.message()));
    refuse(error.message());
}

ExitCode matricesScene(const SceneOptions &options, const GivenTexts &given, PasteChoices choices,
                       const PastedCamera &read, const InputFiles &inputs, SceneFile &scene)
{
    if (read.fault)
        refuseText(options, given, read);
    if (!options.camera.isNothing())
        complain(given.name + ": "
                 + tr("the text has matrices, so --image, --near, --far, --axes, --pose, --pixel-centers and "
                      "--undistorted are ignored"));
    if (!Findings(options, read, given.name).say())
        throw Refused();
    setViewport(options, read, given.name, scene);
    const bool isReversed = std::ranges::any_of(read.matrices, [](const ReadMatrix &one) {
        return std::ranges::any_of(
            one.findings, [](const MatrixFinding &finding) { return finding.fault == MatrixFault::DepthReversed; });
    });
    choices.corrections = corrections(options, read);
    choices.areMatrices = true;
    setMatrices(options, choices.corrections.empty() ? read : pastedCamera(given.texts, choices, std::nullopt),
                isReversed, scene);
    return writeScene(options, inputs, scene);
}

/// A file among several that is a model by its name; nothing if there is none.
std::optional<std::string> modelAmong(const GivenTexts &given)
{
    static constexpr std::array kModels{".obj", ".ply", ".stl", ".off"};
    const auto isModel = [](const std::string &file) {
        return std::any_of(kModels.begin(), kModels.end(), [&](const char *suffix) { return file.ends_with(suffix); });
    };
    const auto found = std::find_if(given.files.begin(), given.files.end(), isModel);
    return given.files.size() < 2 || found == given.files.end() ? std::nullopt : std::optional<std::string>(*found);
}

} // namespace

ExitCode runScene(const SceneOptions &options)
{
    const bool isFromMatrices = !options.fromMatrices.empty();
    const GivenTexts given =
        isFromMatrices ? givenTexts(options.fromMatrices, "--from-matrices") : givenTexts(options.from, "--from");
    if (const auto model = modelAmong(given))
        refuse(tr("%1: this is a model, not a camera; give it with --objects", *model));
    SceneFile scene;
    InputFiles inputs = given.files;
    const Box bounds = addObjects(options, inputs, scene);
    PasteChoices choices;
    choices.camera = options.camera;
    choices.camera.size = imageSize(options);
    choices.order = options.order;
    choices.ndcDepth = options.depth;
    choices.conventions = options.conventions.value_or(Api::OpenGl);
    choices.areMatrices = options.isAboutMatrices();
    choices.isScene = true;
    const PastedCamera read =
        pastedCamera(given.texts, choices, bounds.isEmpty() ? std::nullopt : std::optional(bounds));
    if (read.isProgram && read.fault)
        refuseCamera(*read.fault, given);
    return read.scene ? cameraScene(options, given, *read.scene, inputs, scene)
                      : matricesScene(options, given, std::move(choices), read, inputs, scene);
}

void addScene(const Command &command)
{
    const auto options = std::make_shared<SceneOptions>();
    CameraChoices &camera = options->camera;
    CLI::Option *from = command.add("FILE,--from", options->from)->expected(1, 64);
    command.add("--from-matrices", options->fromMatrices)->expected(1, 64)->excludes(from);
    command.add("--image", camera.image);
    command.add("--size", options->size);
    command.add("--near", camera.nearDistance);
    command.add("--far", camera.farDistance);
    std::map<std::string, std::optional<EyeAxes>> axes;
    for (const EyeAxes one : kEyeAxes)
        axes.emplace(keyOf(one), one);
    command.choice("--axes", camera.axes, axes);
    command.choice("--pose", camera.direction,
                   {{keyOf(PoseDirection::WorldToCamera), PoseDirection::WorldToCamera},
                    {keyOf(PoseDirection::CameraToWorld), PoseDirection::CameraToWorld}});
    command.choice("--pixel-centers", camera.centres,
                   {{keyOf(PixelCentres::AtIntegers), PixelCentres::AtIntegers},
                    {keyOf(PixelCentres::AtHalves), PixelCentres::AtHalves}});
    command.flag("--undistorted", camera.isUndistorted);
    command.add("--objects", options->objects)->expected(1, 64);
    command.choice("--order", options->order, {{"column", NumberOrder::ByColumns}, {"row", NumberOrder::ByRows}});
    CLI::Option *depth =
        command.choice("--depth", options->depth,
                       {{"minus-one-to-one", NdcDepth::MinusOneToOne}, {"zero-to-one", NdcDepth::ZeroToOne}});
    CLI::Option *y = command.choice("--y", options->isYDown, {{"up", false}, {"down", true}});
    command.flag("--reversed", options->isReversed);
    command.conventions(options->conventions)->excludes(depth)->excludes(y);
    command.flag("--orthonormal", options->isOrthonormal);
    command.add("--window", options->window);
    command.file("-o,--output", options->output)->default_str("-");
    command.runs(options, [command](const SceneOptions &given) {
        if (!command.has("--from") && !command.has("--from-matrices"))
            throw CLI::RequiredError(tr("%1 (or --from-matrices)", "FILE"));
        return runScene(given);
    });
}

} // namespace unprojector::cli
