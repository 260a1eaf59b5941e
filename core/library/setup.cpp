#include "unprojector/setup.h"

#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/cameras/camera_matrices.h"
#include "core/cameras/foreign_camera.h"
#include "core/geometry/api_conventions.h"
#include "core/geometry/condition_number.h"
#include "core/library/internal.h"
#include "core/pipeline/matrix_findings.h"
#include "core/scene_file/scene_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace unprojector {
namespace {

/// Calls a function by the type of a variant's value.
template <class... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

geometry::Ortho internalBox(const Ortho &o)
{
    return {o.left, o.right, o.bottom, o.top, o.nearDistance, o.farDistance};
}

geometry::Projection internalProjection(const Projection &projection, const geometry::Viewport &viewport)
{
    return std::visit(Overloaded{[&](const Perspective &p) -> geometry::Projection {
                                     return geometry::Perspective{geometry::Angle::fromDegrees(p.verticalFovDegrees),
                                                                  p.aspect ? geometry::DoubleDouble(*p.aspect)
                                                                           : geometry::aspectOf(viewport),
                                                                  p.nearDistance, p.farDistance};
                                 },
                                 [](const Frustum &f) -> geometry::Projection {
                                     return geometry::Frustum{f.left,         f.right,       f.bottom, f.top,
                                                              f.nearDistance, f.farDistance, f.skew};
                                 },
                                 [](const Ortho &o) -> geometry::Projection { return internalBox(o); },
                                 [](const Oblique &o) -> geometry::Projection {
                                     return geometry::Oblique{internalBox(o.box),
                                                              geometry::Angle::fromDegrees(o.thetaDegrees),
                                                              geometry::Angle::fromDegrees(o.phiDegrees)};
                                 }},
                      projection);
}

Projection publicProjection(const geometry::Projection &projection)
{
    const auto boxOf = [](const geometry::Ortho &o) {
        return Ortho{o.left, o.right, o.bottom, o.top, o.nearDistance, o.farDistance};
    };
    const auto frustumOf = [](const geometry::Frustum &f) {
        return Frustum{f.left, f.right, f.bottom, f.top, f.nearDistance, f.farDistance, f.skew};
    };
    return std::visit(
        Overloaded{[](const geometry::Perspective &p) -> Projection {
                       return Perspective{p.verticalFov.degrees(),
                                          p.aspect.rest == 0.0 ? std::optional(p.aspect.value) : std::nullopt,
                                          p.nearDistance, p.farDistance};
                   },
                   [&](const geometry::Frustum &f) -> Projection { return frustumOf(f); },
                   [&](const geometry::Pinhole &p) -> Projection { return frustumOf(geometry::frustumFromPinhole(p)); },
                   [&](const geometry::Ortho &o) -> Projection { return boxOf(o); },
                   [&](const geometry::Oblique &o) -> Projection {
                       return Oblique{boxOf(o.box), o.theta.degrees(), o.phi.degrees()};
                   }},
        projection);
}

/// A setup in a window, still without projection and camera.
geometry::Setup inWindow(const Window &window)
{
    geometry::Setup setup;
    setup.surface = {window.width, window.height, 1.0};
    setup.viewport = geometry::wholeSurface(setup.surface);
    if (window.viewport)
        setup.viewport = {window.viewport->x, window.viewport->y, window.viewport->width, window.viewport->height};
    setup.depthRange = {window.depthRange.atNear, window.depthRange.atFar};
    return setup;
}

Result<geometry::Api> apiOf(std::string_view key)
{
    if (const auto api = geometry::apiOf(key))
        return *api;
    std::string known;
    for (const std::string &each : conventionKeys())
        known += (known.empty() ? "" : ", ") + each;
    return valueError(base::tr("there are no conventions \"%1\"; known: %2", std::string(key), known));
}

void addFindings(const char *name, const glm::dmat4 &matrix, pipeline::MatrixRole role,
                 const std::optional<geometry::NdcDepth> &ndcDepth, const std::optional<glm::dmat4> &clipFromEye,
                 std::vector<std::string> &sentences)
{
    for (const pipeline::MatrixFinding &finding : pipeline::findings(matrix, role, ndcDepth, clipFromEye))
        sentences.push_back(std::string(name) + ": " + pipeline::findingText(finding, role));
}

struct Named {
    std::string name;
    double value;
};

void add(std::vector<Named> &numbers, const std::string &name, const glm::dvec3 &v)
{
    for (int k = 0; k < 3; ++k)
        numbers.push_back({name + '[' + std::to_string(k) + ']', v[k]});
}

/// "K[0, 2]".
std::string entryName(const std::string &matrix, int row, int column)
{
    return matrix + '[' + std::to_string(row) + ", " + std::to_string(column) + ']';
}

/// The numbers of a projection, under their names in OpenGL.
std::vector<Named> numbersOf(const Projection &projection)
{
    const auto ofBox = [](const auto &o) {
        return std::vector<Named>{{"left", o.left}, {"right", o.right},       {"bottom", o.bottom},
                                  {"top", o.top},   {"near", o.nearDistance}, {"far", o.farDistance}};
    };
    return std::visit(Overloaded{[](const Perspective &p) {
                                     return std::vector<Named>{{"fovy", p.verticalFovDegrees},
                                                               {"aspect", p.aspect.value_or(1.0)},
                                                               {"near", p.nearDistance},
                                                               {"far", p.farDistance}};
                                 },
                                 [&](const Oblique &o) {
                                     std::vector<Named> numbers = ofBox(o.box);
                                     numbers.push_back({"theta", o.thetaDegrees});
                                     numbers.push_back({"phi", o.phiDegrees});
                                     return numbers;
                                 },
                                 [&](const Frustum &f) {
                                     std::vector<Named> numbers = ofBox(f);
                                     numbers.push_back({"skew", f.skew});
                                     return numbers;
                                 },
                                 [&](const auto &box) { return ofBox(box); }},
                      projection);
}

std::vector<Named> numbersOf(const Window &window)
{
    std::vector<Named> numbers{{"depth_range[0]", window.depthRange.atNear},
                               {"depth_range[1]", window.depthRange.atFar}};
    if (const auto &v = window.viewport)
        numbers.insert(
            numbers.end(),
            {{"viewport[0]", v->x}, {"viewport[1]", v->y}, {"viewport[2]", v->width}, {"viewport[3]", v->height}});
    return numbers;
}

/// @return an error for the first number that is not finite
std::optional<Error> refusal(const std::vector<Named> &numbers)
{
    for (const Named &number : numbers) {
        if (!std::isfinite(number.value))
            return valueError(
                base::tr("%1 is %2; give a finite number", number.name, base::shortestText(number.value)));
    }
    return std::nullopt;
}

/// @return an error for a matrix without an inverse
std::optional<Error> refusal(const std::string &name, const glm::dmat4 &matrix)
{
    std::vector<Named> entries;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row)
            entries.push_back({entryName(name, row, column), matrix[column][row]});
    }
    if (const auto error = refusal(entries))
        return error;
    if (geometry::isSingular(matrix))
        return valueError(base::tr("%1 has no inverse; check whether it was copied completely", name));
    return std::nullopt;
}

/// The error of a window that no scene file may have.
std::optional<Error> refusal(const Window &window)
{
    constexpr int kMost = scene_file::kMostWindowPixels;
    if (window.width <= kMost && window.height <= kMost)
        return refusal(numbersOf(window));
    return valueError(
        base::tr("the window has %1x%2 pixels; give at most %3 a side", window.width, window.height, kMost));
}

std::string pointText(const glm::dvec3 &p)
{
    return '(' + base::shortestText(p.x) + ", " + base::shortestText(p.y) + ", " + base::shortestText(p.z) + ')';
}

/// "ortho left -1 right 1": a perspective's aspect and no skew are left out.
std::string projectionText(const Projection &projection)
{
    constexpr const char *kNames[] = {"perspective", "frustum", "ortho", "oblique"}; // in the order of Projection
    std::string text = kNames[projection.index()];
    for (const Named &number : numbersOf(projection)) {
        if (number.name != "aspect" && (number.name != "skew" || number.value != 0.0))
            text += ' ' + number.name + ' ' + base::shortestText(number.value);
    }
    return text;
}

} // namespace

std::vector<std::string> conventionKeys()
{
    std::vector<std::string> keys;
    keys.reserve(geometry::kApis.size());
    for (const geometry::Api api : geometry::kApis)
        keys.emplace_back(geometry::conventionsOf(api).key);
    return keys;
}

bool areVectorsRows(std::string_view conventions)
{
    const auto api = geometry::apiOf(conventions);
    return api && geometry::conventionsOf(*api).areVectorsRows;
}

glm::dmat3 rotationFromAxis(const glm::dvec3 &axis)
{
    return cameras::rotationOf(axis);
}

Result<Setup> Setup::of(const Projection &projection, const Camera &camera, const Window &window)
{
    if (const auto error = refusal(window))
        return *error;
    std::vector<Named> numbers = numbersOf(projection);
    add(numbers, "eye", camera.eye);
    add(numbers, "center", camera.center);
    add(numbers, "up", camera.up);
    if (const auto error = refusal(numbers))
        return *error;
    geometry::Setup setup = inWindow(window);
    setup.lens = internalProjection(projection, setup.viewport);
    setup.pose = geometry::LookAt{geometry::WorldPoint(camera.eye), geometry::WorldPoint(camera.center),
                                  geometry::WorldVector(camera.up)};
    return SetupAccess::make(setup);
}

Result<Setup> Setup::fromMatrices(const glm::dmat4 &clipFromEye, const glm::dmat4 &eyeFromWorld, const Window &window,
                                  std::string_view conventions)
{
    const Result<geometry::Api> api = apiOf(conventions);
    if (!api)
        return api.error();
    if (const auto error = refusal(window))
        return *error;
    if (const auto error = refusal("projection", clipFromEye))
        return *error;
    if (const auto error = refusal("view", eyeFromWorld))
        return *error;
    geometry::Setup setup = inWindow(window);
    const geometry::MatrixProjection lens = geometry::oursFromApi({clipFromEye, std::nullopt}, *api);
    const glm::dmat4 pose = geometry::oursFromView(eyeFromWorld, *api);
    setup.lens = lens;
    setup.pose = pose;
    std::vector<std::string> sentences = worldFindings(*api);
    addFindings("projection", lens.clipFromEye, pipeline::MatrixRole::Projection, lens.ndcDepth, std::nullopt,
                sentences);
    addFindings("view", pose, pipeline::MatrixRole::View, std::nullopt, lens.clipFromEye, sentences);
    return SetupAccess::make(setup, std::move(sentences));
}

Result<Setup> Setup::fromOpenCv(const glm::dmat3 &cameraMatrix, const glm::dmat3 &rotation,
                                const glm::dvec3 &translation, const Window &window, double nearDistance,
                                double farDistance)
{
    if (const auto error = refusal(window))
        return *error;
    std::vector<Named> numbers{{"near", nearDistance}, {"far", farDistance}};
    add(numbers, "t", translation);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            numbers.push_back({entryName("K", row, column), cameraMatrix[column][row]});
            numbers.push_back({entryName("R", row, column), rotation[column][row]});
        }
    }
    if (const auto error = refusal(numbers))
        return *error;
    for (const auto &[row, column, expected] : {std::array{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 1}}) {
        if (cameraMatrix[column][row] != expected)
            return valueError(base::tr("K[%1, %2] is %3; give [fx s cx; 0 fy cy; 0 0 1]", row, column,
                                       base::shortestText(cameraMatrix[column][row])));
    }
    double deviation = std::abs(glm::determinant(rotation) - 1.0);
    const glm::dmat3 product = rotation * glm::transpose(rotation);
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row)
            deviation = std::max(deviation, std::abs(product[column][row] - (row == column ? 1.0 : 0.0)));
    }
    constexpr double kPrintedDigits = 1e-3;
    if (!(deviation <= kPrintedDigits))
        return valueError(base::tr("R is no rotation: it deviates by %1; give the matrix of cv2.Rodrigues",
                                   base::shortestText(deviation, 0.01 * deviation)));
    cameras::ForeignCamera camera;
    camera.program = "OpenCV";
    cameras::Intrinsics &intrinsics = camera.intrinsics.emplace();
    intrinsics.fx = cameraMatrix[0][0];
    intrinsics.fy = cameraMatrix[1][1];
    intrinsics.cx = cameraMatrix[2][0];
    intrinsics.cy = cameraMatrix[2][1];
    intrinsics.skew = cameraMatrix[1][0];
    camera.size = cameras::ImageSize{window.width, window.height};
    camera.nearDistance = nearDistance;
    camera.farDistance = farDistance;
    camera.pose = glm::dmat4(rotation);
    (*camera.pose)[3] = glm::dvec4(translation, 1.0);
    camera.isDirectionCertain = camera.areAxesCertain = true;
    camera.axes = cameras::EyeAxes::RightDownAhead;
    const auto converted = cameras::sceneCamera(camera, {}, std::nullopt);
    if (!converted)
        return valueError(converted.error().message());
    geometry::Setup setup = inWindow(window);
    setup.lens = converted->projection;
    setup.pose = converted->eyeFromWorld;
    return SetupAccess::make(setup, converted->assumed);
}

Result<Setup> Setup::fromSceneText(std::string_view text, const std::string &name)
{
    const auto scene = scene_file::parseScene(text, name);
    if (!scene)
        return valueError(scene.error().message());
    return SetupAccess::make(scene_file::setupOf(*scene),
                             worldFindings(scene->conventions.value_or(geometry::Api::OpenGl)));
}

std::string Setup::sceneText() const
{
    const geometry::Setup &setup = m_data->setup;
    scene_file::SceneFile scene;
    scene.windowWidth = geometry::logicalFromDevice(setup.surface, setup.surface.widthPixels);
    scene.windowHeight = geometry::logicalFromDevice(setup.surface, setup.surface.heightPixels);
    scene.devicePixelRatio = setup.surface.devicePixelRatio;
    scene.isWindowFixed = true;
    scene.viewport = setup.viewport;
    scene.depthRange = setup.depthRange;
    std::visit([&](const auto &lens) { scene.projection = lens; }, setup.lens);
    std::visit([&](const auto &pose) { scene.view = pose; }, setup.pose);
    return scene_file::sceneText(scene).value();
}

int Setup::width() const
{
    return m_data->setup.surface.widthPixels;
}

int Setup::height() const
{
    return m_data->setup.surface.heightPixels;
}

Viewport Setup::viewport() const
{
    const geometry::Viewport &v = m_data->setup.viewport;
    return {v.x, v.y, v.width, v.height};
}

DepthRange Setup::depthRange() const
{
    return {m_data->setup.depthRange.atNear, m_data->setup.depthRange.atFar};
}

glm::dmat4 Setup::clipFromEye() const
{
    return geometry::clipFromEye(m_data->setup).value();
}

glm::dmat4 Setup::eyeFromWorld() const
{
    return geometry::eyeFromWorld(m_data->setup).value();
}

Result<ApiMatrices> Setup::matrices(std::string_view conventions) const
{
    const Result<geometry::Api> api = apiOf(conventions);
    if (!api)
        return api.error();
    const auto camera = geometry::apiCamera(m_data->setup, *api);
    if (!camera)
        return valueError(camera.error());
    return ApiMatrices{camera->clipFromEye, camera->eyeFromWorld, camera->windowFromNdc, camera->intrinsics};
}

std::optional<Projection> Setup::projection() const
{
    const auto *parameters = std::get_if<geometry::Projection>(&m_data->setup.lens);
    return parameters ? std::optional(publicProjection(*parameters)) : std::nullopt;
}

std::optional<Camera> Setup::camera() const
{
    const auto *view = std::get_if<geometry::LookAt>(&m_data->setup.pose);
    if (!view)
        return std::nullopt;
    return Camera{view->eye.coordinates(), view->center.coordinates(), view->up.coordinates()};
}

const std::vector<std::string> &Setup::findings() const
{
    return m_data->findings;
}

Setup Setup::withFindings(std::vector<std::string> findings) const
{
    return SetupAccess::make(m_data->setup, std::move(findings)).value();
}

std::string Setup::description() const
{
    const std::optional<Projection> parameters = projection();
    const std::optional<Camera> view = camera();
    const geometry::Setup &setup = m_data->setup;
    std::string line = parameters ? projectionText(*parameters) : "matrix";
    line += ", ";
    if (view)
        line += "eye " + pointText(view->eye) + " center " + pointText(view->center);
    else
        line += "view matrix";
    line += ", " + std::to_string(width()) + 'x' + std::to_string(height());
    if (!(setup.viewport == geometry::wholeSurface(setup.surface)))
        line += ", viewport " + base::shortestText(setup.viewport.x) + ' ' + base::shortestText(setup.viewport.y) + ' '
                + base::shortestText(setup.viewport.width) + ' ' + base::shortestText(setup.viewport.height);
    if (!(setup.depthRange == geometry::DepthRange{}))
        line += ", depth range " + base::shortestText(setup.depthRange.atNear) + " to "
                + base::shortestText(setup.depthRange.atFar);
    return line;
}

bool Setup::operator==(const Setup &other) const
{
    return m_data->setup == other.m_data->setup;
}

} // namespace unprojector
