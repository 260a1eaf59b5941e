#include "core/cli/commands/scene_command.h"

#include "core/base/path_text.h"
#include "core/base/translation.h"
#include "core/cameras/lens.h"
#include "core/cameras/pasted_calls.h"
#include "core/cameras/told_order.h"
#include "core/cli/commands/command.h"
#include "core/cli/commands/inputs.h"
#include "core/cli/terminal/refusal.h"
#include "core/geometry/condition_number.h"
#include "core/pipeline/decomposition.h"
#include "core/pipeline/matrix_findings.h"
#include "core/pipeline/matrix_format.h"
#include "core/scene_file/scene_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
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

/// A matrix of a text, and its role in a scene.
struct Part {
    PastedMatrix *matrix;
    PastedPart part;
    MatrixRole role;
    bool isNeeded;
};

/// The matrices whose order matters; the model matrix is not used.
std::vector<Part> partsOf(PastedScene &pasted)
{
    const bool isWhole = pasted.projection && (pasted.view || pasted.modelView);
    std::vector<Part> parts;
    const auto add = [&parts](std::optional<PastedMatrix> &matrix, PastedPart part, MatrixRole role, bool isNeeded) {
        if (matrix && matrix->form != MatrixForm::Call) // a call has no order of numbers
            parts.push_back({&*matrix, part, role, isNeeded});
    };
    add(pasted.view, PastedPart::View, MatrixRole::View, isWhole);
    add(pasted.modelView, PastedPart::ModelView, MatrixRole::View, isWhole && !pasted.view);
    add(pasted.projection, PastedPart::Projection, MatrixRole::Projection, isWhole);
    add(pasted.product, PastedPart::Product, MatrixRole::Product, !isWhole);
    // Its last row is 0 0 0 1, as in a view.
    add(pasted.viewportMatrix, PastedPart::Viewport, MatrixRole::View, true);
    return parts;
}

/// Reads pasted matrices in the order and conventions that the options give or the numbers reveal.
/// Reports findings on stderr, such as an inverse or reversed depths.
class MatrixTaker {
public:
    /// @param options  must outlive this
    /// @param name     of the text; messages begin with it
    MatrixTaker(const SceneOptions &options, std::string name) : m_options(options), m_name(std::move(name)) {}

    /// Sets the order of the matrices where no option gives it and the numbers contradict the order
    /// of the matrix's form. Reports each such change.
    /// @return whether the order of all matrices of a scene is known; if not, a message asks for
    ///         the option
    bool tellOrders(PastedScene &pasted) const
    {
        if (m_options.order)
            return true;
        const std::vector<Part> parts = partsOf(pasted);
        std::vector<BothOrders> both;
        for (const Part &part : parts) {
            const auto read = [&](const PastedMatrix &matrix) {
                return part.part == PastedPart::Viewport ? matrixAsGiven(matrix) : this->matrix(matrix, part.role);
            };
            PastedMatrix other = *part.matrix;
            other.order = opposite(order(*part.matrix));
            both.push_back({part.role, part.matrix->form, read(*part.matrix), read(other)});
        }
        const std::optional<double> aspect = pasted.viewport && pasted.viewport->height > 0.0
                                                 ? std::optional(pasted.viewport->width / pasted.viewport->height)
                                                 : std::nullopt;
        const std::vector<ToldOrder> told = toldOrders(both, aspect);
        bool isKnown = true;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::optional<MatrixFinding> finding = findingOf(told[i]);
            const bool isOpen = told[i] == ToldOrder::Open;
            if (!finding || (isOpen && !parts[i].isNeeded))
                continue;
            if (!isOpen)
                parts[i].matrix->order = opposite(order(*parts[i].matrix));
            isKnown = isKnown && !isOpen;
            say(parts[i].part, findingText(*finding, parts[i].role)
                                   + adviceFor(*finding, order(*parts[i].matrix), m_options.conventions.has_value()));
        }
        return isKnown;
    }

    /// The matrix in the order of the option, of its numbers, or of its form, in this priority.
    glm::dmat4 matrixAsGiven(const PastedMatrix &pasted) const { return meantMatrix(pasted, order(pasted)); }

    /// The matrix converted from the option's conventions to OpenGL's.
    glm::dmat4 matrix(const PastedMatrix &pasted, MatrixRole role) const
    {
        const glm::dmat4 given = matrixAsGiven(pasted);
        if (pasted.form == MatrixForm::Call) // it has OpenGL's eye already
            return given;
        switch (role) {
        case MatrixRole::View: return oursFromView(given, api());
        case MatrixRole::Projection: return oursFromApi({given, {}}, api()).clipFromEye;
        case MatrixRole::Product: break;
        }
        // The eye space between the two may look either way.
        return oursFromApi({given * viewFromOurs(glm::dmat4(1.0), api()), {}}, api()).clipFromEye;
    }

    /// Viewport and depth range from a matrix from NDC to the window. Where pixels count from the
    /// top, y is 0 at the top.
    ViewportAndDepths viewport(const PastedMatrix &pasted) const
    {
        // The window's height is not known yet, so 0 is used.
        const ApiSpaces spaces = apiSpaces(Setup(), api());
        AxisChange window = spaces.window;
        window.scale.z = 1.0;
        window.shift.z = 0.0;
        const glm::dmat4 ours = window.inverse().matrix() * matrixAsGiven(pasted) * spaces.clip.matrix();
        ViewportAndDepths result =
            viewportOf(ours, conventionsOf(api()).hasOnlyThatDepth ? NdcDepth::MinusOneToOne : m_options.depth);
        if (conventionsOf(api()).isDepthReversed)
            std::swap(result.depthRange.atNear, result.depthRange.atFar);
        return result;
    }

    /// The NDC depths, where the options or the call that made the projection determine them.
    std::optional<NdcDepth> depthOf(const PastedMatrix &pasted) const
    {
        if (pasted.ndcDepth)
            return pasted.ndcDepth;
        return conventionsOf(api()).hasOnlyThatDepth ? conventionsOf(api()).ndcDepth : m_options.depth;
    }

    void say(PastedPart part, const std::string &what) const { complain(m_name + ": " + nameOf(part) + ": " + what); }

    /// Reports the findings about a matrix, unless an option already resolves them.
    /// @return whether the matrix reverses depths
    bool lookAt(const PastedMatrix &pasted, PastedPart part, MatrixRole role,
                const std::optional<glm::dmat4> &clipFromEye = std::nullopt) const
    {
        bool isReversed = false;
        if (pasted.isInverse)
            say(part, inverseText(pasted));
        if (!pasted.call.empty())
            say(part, pasted.call);
        for (const MatrixFinding &finding : findings(matrix(pasted, role), role, depthOf(pasted), clipFromEye)) {
            const bool isAboutDepth = finding.fault == MatrixFault::DepthReversed;
            isReversed = isReversed || isAboutDepth;
            if ((isAboutDepth && m_options.isReversed) || (finding.fault == MatrixFault::YDown && m_options.isYDown))
                continue;
            if (finding.fault == MatrixFault::Rounded && m_options.isOrthonormal)
                continue;
            say(part, taken(findingText(finding, role))
                          + adviceFor(finding, order(pasted), m_options.conventions.has_value()));
            if (finding.fault == MatrixFault::Scaled && m_options.isOrthonormal)
                say(part,
                    tr(finding.repair == MatrixRepair::None
                           ? "--orthonormal is for rounded axes and would change "
                             "this camera; give the view without the model's scale"
                           : "--orthonormal removes the model's scale; near, far and eye coordinates stay unchanged, "
                             "so world coordinates are in eye units"));
        }
        return isReversed;
    }

private:
    Api api() const { return m_options.conventions.value_or(Api::OpenGl); }

    NumberOrder order(const PastedMatrix &pasted) const
    {
        if (pasted.form == MatrixForm::Call)
            return NumberOrder::ByColumns;
        // Rows of row vectors are columns.
        const NumberOrder usual = conventionsOf(api()).areVectorsRows ? NumberOrder::ByColumns : orderOf(pasted.form);
        return m_options.order.value_or(pasted.order.value_or(usual));
    }

    /// The finding worded for the matrix converted to OpenGL's conventions.
    std::string taken(const std::string &finding) const
    {
        return api() == Api::OpenGl
                   ? finding
                   : tr("converted from %1's conventions to OpenGL's, it %2", conventionsOf(api()).name, finding);
    }

    const SceneOptions &m_options;
    std::string m_name;
};

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
/// @return nothing if the texts have no known program's form
std::optional<ExitCode> runCameraScene(const SceneOptions &options, const GivenTexts &given)
{
    CameraChoices choices = options.camera;
    choices.size = imageSize(options);
    const auto read = readCamera(given.texts, choices);
    if (!read)
        return std::nullopt;
    if (!*read)
        refuseCamera(read->error(), given);
    SceneFile scene;
    InputFiles inputs = given.files;
    const Box bounds = addObjects(options, inputs, scene);
    const ForeignCamera &camera = **read;
    const auto converted = sceneCamera(camera, choices, bounds.isEmpty() ? std::nullopt : std::optional(bounds));
    if (!converted)
        refuseCamera(converted.error(), given);
    if (converted->distortion)
        refuse(given.name + ": "
               + tr("the lens distorts the image (%1), and a scene has no lens. If the pixels are those of the "
                    "undistorted image, give --undistorted. Else make the scene with --undistorted and give the "
                    "coefficients to 'unproject points --distortion'",
                    coefficientsText(*converted->distortion)));
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

std::string pasteErrorText(const PasteError &error, const std::string &name)
{
    base::Error named = errorOf(error);
    named.file = name;
    return named.message();
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
void setViewport(const SceneOptions &options, const MatrixTaker &taker, const PastedScene &pasted,
                 const std::string &name, SceneFile &scene)
{
    if (!pasted.viewportMatrix) {
        scene.viewport = setWindow(options, *pasted.viewport, false, scene);
        return;
    }
    const auto &[viewport, depthRange] = taker.viewport(*pasted.viewportMatrix);
    if (viewport.height < 0.0)
        refuse(name + ": viewport: "
               + tr(isOriginTop(options)
                        ? "its matrix flips y, as for pixels counted from the bottom: give its --conventions"
                        : "its matrix flips y, as for pixels counted from the top: give its --conventions"));
    if (!isWindowsOwn(depthRange))
        complain(
            name + ": viewport: "
            + tr(options.depth || options.conventions
                     ? "its depths go from %1 to %2, beyond the 0 to 1 of a window; the depths of clicks must be in "
                       "this range"
                     : "its depths go from %1 to %2, beyond the 0 to 1 of a window; give their NDC depths with --depth",
                 numberText(depthRange.atNear, Digits::Double, 5), numberText(depthRange.atFar, Digits::Double, 5)));
    scene.depthRange = depthRange;
    scene.viewport = setWindow(options, viewport, isOriginTop(options), scene);
}

/// Deviation of a matrix from any multiple of another one, relative to its largest entry; 1 where
/// either is 0 or beyond doubles.
double offUpToScale(const glm::dmat4 &given, const glm::dmat4 &other)
{
    const double ofGiven = largestEntry(given), ofOther = largestEntry(other);
    if (!(ofGiven > 0.0 && ofOther > 0.0 && std::isfinite(ofGiven) && std::isfinite(ofOther)))
        return 1.0;
    const glm::dmat4 a = given / ofGiven, b = other / ofOther;
    double ab = 0.0, bb = 0.0, off = 0.0;
    for (int i = 0; i < 16; ++i) {
        ab += a[i / 4][i % 4] * b[i / 4][i % 4];
        bb += b[i / 4][i % 4] * b[i / 4][i % 4];
    }
    for (int i = 0; i < 16; ++i)
        off = std::max(off, std::abs(a[i / 4][i % 4] - ab / bb * b[i / 4][i % 4]));
    return off;
}

constexpr double kSame = 1e-3; // the error of three printed digits

/// The contradiction between a product and the given projection and view; empty if they agree.
std::string contradiction(const MatrixTaker &taker, const PastedScene &pasted)
{
    const glm::dmat4 product = taker.matrixAsGiven(*pasted.product),
                     clipFromEye = taker.matrixAsGiven(*pasted.projection);
    if (largestEntry(product) == 0.0)
        return tr(", and it is not their product, but all zeros");
    std::vector<glm::dmat4> others;
    for (const auto &view : {pasted.view, pasted.modelView}) {
        if (!view)
            continue;
        const glm::dmat4 eyeFromWorld = taker.matrixAsGiven(*view);
        const glm::dmat4 model = pasted.model ? taker.matrixAsGiven(*pasted.model) : glm::dmat4(1.0);
        // Any of them may be in the wrong order, which another message reports.
        others.insert(others.end(), {clipFromEye * eyeFromWorld, eyeFromWorld * clipFromEye,
                                     clipFromEye * eyeFromWorld * model, model * eyeFromWorld * clipFromEye});
    }
    double off = std::numeric_limits<double>::infinity();
    for (const glm::dmat4 &other : others)
        off = std::min(off, offUpToScale(product, other));
    return off <= kSame ? ""
                        : tr(", and it differs from their product by %1 of its largest entry: one of them is of "
                             "another setup, or contains an object's matrix",
                             numberText(off, Digits::Double, 2));
}

/// Reports that a matrix beside a product is ignored, and whether it agrees with the product.
void sayLeftOut(const MatrixTaker &taker, const PastedScene &pasted, PastedPart part,
                const std::optional<Decomposition> &apart)
{
    const bool isProjection = part == PastedPart::Projection;
    const auto &given = isProjection ? pasted.projection : part == PastedPart::View ? pasted.view : pasted.modelView;
    if (!given)
        return;
    const bool isSame = apart
                        && offUpToScale(isProjection ? apart->clipFromEye : apart->eyeFromWorld,
                                        taker.matrix(*given, isProjection ? MatrixRole::Projection : MatrixRole::View))
                               <= kSame;
    taker.say(part, tr(isProjection ? "ignored without a view: only the product counts"
                                    : "ignored without a projection: only the product counts")
                        + (isSame || !apart ? "" : tr(", and it differs from the product's")));
}

/// Sets projection and view as pasted, applies the options to them, and reports the other findings.
void setMatrices(const SceneOptions &options, const MatrixTaker &taker, const PastedScene &pasted, SceneFile &scene)
{
    const bool isWhole = pasted.projection && (pasted.view || pasted.modelView);
    const PastedMatrix &lens = isWhole ? *pasted.projection : *pasted.product;
    glm::dmat4 clipFromEye = taker.matrix(lens, isWhole ? MatrixRole::Projection : MatrixRole::Product);
    bool isReversed = false;
    if (isWhole) {
        const PastedMatrix &view = pasted.view ? *pasted.view : *pasted.modelView;
        const PastedPart viewPart = pasted.view ? PastedPart::View : PastedPart::ModelView;
        glm::dmat4 eyeFromWorld = taker.matrix(view, MatrixRole::View);
        if (eyeFromWorld[3][3] < 0.0)
            eyeFromWorld = repaired(eyeFromWorld, {MatrixFault::Negated, MatrixRepair::Negate});
        if (options.isOrthonormal && eyeFromWorld[3][3] != 0.0)
            eyeFromWorld = repaired(eyeFromWorld, {MatrixFault::Rounded, MatrixRepair::Orthonormal});
        scene.view = eyeFromWorld;
        taker.lookAt(view, viewPart, MatrixRole::View, clipFromEye);
        isReversed = taker.lookAt(lens, PastedPart::Projection, MatrixRole::Projection);
        for (const MatrixFinding &finding : findings(clipFromEye, MatrixRole::Projection, taker.depthOf(lens))) {
            if (finding.fault == MatrixFault::Negated)
                clipFromEye = repaired(clipFromEye, finding);
        }
        if (pasted.product)
            taker.say(PastedPart::Product, tr("ignored, because the projection and the %1 are given", nameOf(viewPart))
                                               + contradiction(taker, pasted));
        if (pasted.view && pasted.modelView)
            taker.say(PastedPart::ModelView, tr("ignored, because the view is given"));
    } else {
        isReversed = taker.lookAt(lens, PastedPart::Product, MatrixRole::Product);
        const auto apart = decomposed(clipFromEye);
        for (const PastedPart part : {PastedPart::Projection, PastedPart::View, PastedPart::ModelView})
            sayLeftOut(taker, pasted, part, apart);
        scene.view = apart ? apart->eyeFromWorld : glm::dmat4(1.0);
        clipFromEye = apart ? apart->clipFromEye : clipFromEye;
        taker.say(PastedPart::Product, !apart ? tr("it cannot be decomposed: only the inverted matrix will answer, "
                                                   "because the formulas need projection and view")
                                              : decompositionText(*apart));
    }
    for (const PastedPart part : pasted.inversesLeft)
        taker.say(part, tr("its inverse is ignored, because the needed matrices are given"));
    for (const PastedPart part : pasted.more)
        taker.say(part, tr("there are several; the first one is used"));
    if (pasted.model)
        taker.say(PastedPart::Model, tr("ignored: world coordinates do not need it"));
    if (options.isYDown.value_or(false))
        clipFromEye = repaired(clipFromEye, {MatrixFault::YDown, MatrixRepair::TurnY});
    if (options.isReversed && !isReversed)
        scene.depthRange = {1.0, 0.0};
    // Stored with the depth convention used here, so that every reader uses the same.
    const MatrixProjection asRead{clipFromEye, taker.depthOf(lens)};
    scene.projection = MatrixProjection{clipFromEye, recognised(asRead) ? ndcDepthOf(asRead) : taker.depthOf(lens)};
    scene.conventions = options.conventions;
}

/// Joins the texts.
std::string joined(const GivenTexts &given)
{
    std::string text;
    for (const NamedText &one : given.texts)
        text += (text.empty() ? "" : "\n") + one.text;
    return text;
}

/// The parts of a text with calls such as gluLookAt, and of the matrices beside them; else its
/// matrices.
Result<PastedScene, PasteError> partsOf(const SceneOptions &options, const std::string &text)
{
    const Result<PastedCalls, PasteError> calls = pastedCalls(text);
    if (!calls)
        return calls.error();
    if (!calls->hasAny)
        return pastedScene(text);
    const Result<PastedScene, PasteError> beside = pastedParts(calls->rest);
    PastedScene parts = beside ? *beside : PastedScene();
    if (calls->parts.view)
        parts.view = calls->parts.view;
    if (calls->parts.projection)
        parts.projection = calls->parts.projection;
    if (calls->parts.viewport)
        parts.viewport = calls->parts.viewport;
    const auto size = imageSize(options);
    if (!parts.viewport && !parts.viewportMatrix && size)
        parts.viewport = Viewport{0.0, 0.0, double(size->width), double(size->height)};
    if (!parts.projection)
        return countError(PastedPart::Projection, 0, 16, 0);
    if (!parts.view && !parts.modelView)
        return countError(PastedPart::View, 0, 16, 0);
    if (!parts.viewport && !parts.viewportMatrix)
        return countError(PastedPart::Viewport, 0, 4, 0);
    return parts;
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

ExitCode sceneFromMatrices(const SceneOptions &options, const GivenTexts &given)
{
    Result<PastedScene, PasteError> read = partsOf(options, joined(given));
    if (!read) {
        const PasteError &error = read.error();
        const std::vector<std::string> &words = options.fromMatrices.empty() ? options.from : options.fromMatrices;
        const auto camera = options.isAboutMatrices() && options.fromMatrices.empty()
                                ? readCamera(given.texts, options.camera)
                                : std::nullopt;
        if (camera)
            refuse(tr("%1: the text is of a camera, and %2 is only about matrices; leave it out", given.name,
                      optionAboutMatrices(options)));
        if (error.line == 0 && error.all == 0 && !error.isOfCall && given.files.empty() && words.size() == 1)
            refuse(words[0] + ": " + tr("there is no such file"));
        if (options.fromMatrices.empty())
            refuse(tr("%1: no camera of a known program, and no matrices (%2); the manual lists the programs under "
                      "Cameras of other programs",
                      given.name, pasteErrorText(error, given.name)));
        refuse(pasteErrorText(error, given.name));
    }
    if (!options.camera.isNothing())
        complain(given.name + ": "
                 + tr("the text has matrices, so --image, --near, --far, --axes, --pose, --pixel-centers and "
                      "--undistorted are ignored"));

    SceneFile scene;
    InputFiles inputs = given.files;
    addObjects(options, inputs, scene);
    const MatrixTaker taker(options, given.name);
    PastedScene numbers = std::move(read).value();
    if (!taker.tellOrders(numbers))
        throw Refused();
    setViewport(options, taker, numbers, given.name, scene);
    setMatrices(options, taker, numbers, scene);
    for (const std::string &aside : numbers.aside)
        complain(tr("%1: %2: its numbers belong to no matrix, and are not used", given.name, aside));

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
    if (!options.isAboutMatrices()) {
        if (const std::optional<ExitCode> made = runCameraScene(options, given))
            return *made;
    }
    return sceneFromMatrices(options, given);
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
                   {{"integer", PixelCentres::AtIntegers}, {"half", PixelCentres::AtHalves}});
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
