#include "core/geometry/api_conventions.h"

#include <algorithm>
#include <cmath>

namespace unprojector::geometry {
namespace {

/// The conventions in the order of Api.
constexpr std::array<ApiConventions, kApis.size()> kApiConventions{{
    {.key = "opengl", .name = "OpenGL"},
    {.key = "vulkan",
     .name = "Vulkan",
     .isNdcYDown = true,
     .ndcDepth = NdcDepth::ZeroToOne,
     .hasOnlyThatDepth = true,
     .isOriginTop = true},
    {.key = "direct3d",
     .name = "Direct3D",
     .looksAlongPlusZ = true,
     .ndcDepth = NdcDepth::ZeroToOne,
     .hasOnlyThatDepth = true,
     .areVectorsRows = true,
     .isOriginTop = true},
    {.key = "metal", .name = "Metal", .ndcDepth = NdcDepth::ZeroToOne, .hasOnlyThatDepth = true, .isOriginTop = true},
    {.key = "webgpu", .name = "WebGPU", .ndcDepth = NdcDepth::ZeroToOne, .hasOnlyThatDepth = true, .isOriginTop = true},
    {.key = "threejs", .name = "three.js", .isOriginTop = true, .areLogicalPixels = true},
    {.key = "unity", .name = "Unity", .isWorldMirrored = true, .isDepthReversed = true},
    {.key = "opencv",
     .name = "OpenCV",
     .looksAlongPlusZ = true,
     .isEyeYDown = true,
     .isOriginTop = true,
     .pixelCentre = 0.0},
    {.key = "opencascade", .name = "Open CASCADE", .areVectorsRows = true, .isOriginTop = true},
}};

constexpr double sign(bool isTurned)
{
    return isTurned ? -1.0 : 1.0;
}

AxisChange worldChange(const ApiConventions &api)
{
    return {{1.0, 1.0, sign(api.isWorldMirrored)}, {}};
}

/// @param looksAlongPlusZ  whether the source eye space looks along +z
AxisChange eyeChange(const ApiConventions &api, bool looksAlongPlusZ)
{
    return {{1.0, sign(api.isEyeYDown), sign(api.looksAlongPlusZ != looksAlongPlusZ)}, {}};
}

/// @param depth  NDC depths of the source clip space
AxisChange clipChange(const ApiConventions &api, NdcDepth depth)
{
    AxisChange change{{1.0, sign(api.isNdcYDown), 1.0}, {}};
    if (depth != api.ndcDepth) {
        const bool isHalved = api.ndcDepth == NdcDepth::ZeroToOne;
        change.scale.z = isHalved ? 0.5 : 2.0;
        change.shift.z = isHalved ? 0.5 : -1.0;
    }
    return change;
}

/// windowFromNdc as an axis change, also for NDC depths in [0, 1].
AxisChange viewportChange(const Setup &setup)
{
    const Viewport &v = setup.viewport;
    const double atNear = setup.depthRange.atNear, depth = setup.depthRange.atFar - atNear;
    const bool isZeroToOne = ndcDepthOf(setup) == NdcDepth::ZeroToOne;
    return {{v.width / 2.0, v.height / 2.0, isZeroToOne ? depth : depth / 2.0},
            {v.x + v.width / 2.0, v.y + v.height / 2.0, isZeroToOne ? atNear : atNear + depth / 2.0}};
}

std::optional<RecognisedProjection> formOf(const Setup &setup)
{
    const auto *matrix = std::get_if<MatrixProjection>(&setup.lens);
    const auto form = matrix ? recognised(*matrix) : Result<RecognisedProjection>(Error{ErrorCode::NotFinite});
    return form ? std::optional(*form) : std::nullopt;
}

/// K of a projection that divides by the z of OpenCV's eye space: positions are (first two rows of
/// clip) / z.
std::optional<glm::dmat3> intrinsicsOf(const glm::dmat4 &clipFromEye, const glm::dmat4 &windowFromNdc)
{
    const glm::dmat4 m = windowFromNdc * clipFromEye; // homogeneous pixels
    const double w = m[2][3];
    if (!(w > 0.0) || m[0][3] != 0.0 || m[1][3] != 0.0 || m[3][3] != 0.0 || m[3][0] != 0.0 || m[3][1] != 0.0)
        return std::nullopt;
    glm::dmat3 k(0.0);
    for (int column = 0; column < 3; ++column)
        k[column] = {m[column][0] / w, m[column][1] / w, m[column][3] / w};
    return k;
}

} // namespace

const ApiConventions &conventionsOf(Api api)
{
    return kApiConventions[static_cast<std::size_t>(api)];
}

std::optional<Api> apiOf(std::string_view key)
{
    const auto found =
        std::find_if(kApis.begin(), kApis.end(), [key](Api api) { return key == conventionsOf(api).key; });
    return found == kApis.end() ? std::nullopt : std::optional(*found);
}

glm::dmat4 AxisChange::matrix() const
{
    glm::dmat4 m(1.0);
    for (int axis = 0; axis < 3; ++axis) {
        m[axis][axis] = scale[axis];
        m[3][axis] = shift[axis];
    }
    return m;
}

AxisChange AxisChange::inverse() const
{
    return {1.0 / scale, -shift / scale};
}

ApiSpaces apiSpaces(const Setup &setup, Api which)
{
    const ApiConventions &api = conventionsOf(which);
    const std::optional<RecognisedProjection> form = formOf(setup);
    const auto &[atNear, atFar] = setup.depthRange;
    const bool isReversed = (atNear > atFar) != (form && form->reversed);

    AxisChange window;
    if (api.isOriginTop) {
        window.scale.y = -1.0;
        window.shift.y = setup.surface.heightPixels;
    }
    constexpr double kCentre = 0.5; // of this program's pixels
    window.shift += glm::dvec3(api.pixelCentre - kCentre, api.pixelCentre - kCentre, 0.0);
    if (api.areLogicalPixels) {
        const glm::dvec3 ratio(setup.surface.devicePixelRatio, setup.surface.devicePixelRatio, 1.0);
        window.scale /= ratio;
        window.shift /= ratio;
    }
    if (api.isDepthReversed && !isReversed) {
        window.scale.z = -1.0;
        window.shift.z = atNear + atFar;
    }
    return {worldChange(api), eyeChange(api, form && form->looksAlongPlusZ), clipChange(api, ndcDepthOf(setup)),
            window};
}

Result<ApiCamera> apiCamera(const Setup &setup, Api api)
{
    const Result<glm::dmat4> view = eyeFromWorld(setup), projection = clipFromEye(setup);
    if (!view)
        return view.error();
    if (!projection)
        return projection.error();
    const ApiSpaces spaces = apiSpaces(setup, api);
    ApiCamera camera;
    camera.eyeFromWorld = spaces.eye.matrix() * *view * spaces.world.inverse().matrix();
    camera.clipFromEye = spaces.clip.matrix() * *projection * spaces.eye.inverse().matrix();
    camera.windowFromNdc = spaces.window.matrix() * viewportChange(setup).matrix() * spaces.clip.inverse().matrix();
    if (api == Api::OpenCv)
        camera.intrinsics = intrinsicsOf(camera.clipFromEye, camera.windowFromNdc);
    return camera;
}

Result<ApiClick> apiClick(const Setup &setup, Api api, const WindowPoint &window, const EyePoint &eye,
                          const WorldPoint &world)
{
    const Result<glm::dmat4> projection = clipFromEye(setup);
    if (!projection)
        return projection.error();
    const ApiSpaces spaces = apiSpaces(setup, api);
    ApiClick click;
    const glm::dvec3 pixel = spaces.window * glm::dvec3(window.coordinates());
    click.position = glm::dvec2(pixel);
    click.depth = pixel.z;
    click.eye = spaces.eye * glm::dvec3(eye.coordinates());
    click.world = spaces.world * glm::dvec3(world.coordinates());
    if (api == Api::OpenCv) {
        click.depth = click.eye.z;
        click.ndc = click.eye / click.eye.z;
        return click;
    }
    const NdcPoint ndc = ndcFromWindow(setup.viewport, setup.depthRange, window, ndcDepthOf(setup));
    click.ndc = spaces.clip * glm::dvec3(ndc.coordinates());
    click.clip = spaces.clip * (*projection * glm::dvec4(eye.coordinates(), 1.0));
    return click;
}

MatrixProjection apiFromOurs(const MatrixProjection &projection, Api which)
{
    const ApiConventions &api = conventionsOf(which);
    MatrixProjection result = projection;
    AxisChange clip = clipChange(api, ndcDepthOf(projection));
    if (api.hasOnlyThatDepth) {
        result.ndcDepth = api.ndcDepth;
    } else { // result.ndcDepth tells the matrix's depth convention
        clip.scale.z = 1.0;
        clip.shift.z = 0.0;
    }
    result.clipFromEye = clip.matrix() * projection.clipFromEye * eyeChange(api, false).matrix();
    return result;
}

MatrixProjection oursFromApi(const MatrixProjection &projection, Api which)
{
    const ApiConventions &api = conventionsOf(which);
    MatrixProjection result = projection;
    if (api.hasOnlyThatDepth)
        result.ndcDepth = api.ndcDepth;
    const AxisChange clip = clipChange(api, api.ndcDepth); // y only
    result.clipFromEye = clip.inverse().matrix() * projection.clipFromEye * eyeChange(api, false).matrix();
    return result;
}

glm::dmat4 viewFromOurs(const glm::dmat4 &eyeFromWorld, Api which)
{
    const ApiConventions &api = conventionsOf(which);
    return eyeChange(api, false).matrix() * eyeFromWorld * worldChange(api).matrix();
}

glm::dmat4 oursFromView(const glm::dmat4 &eyeFromWorld, Api api)
{
    return viewFromOurs(eyeFromWorld, api); // sign changes are their own inverse
}

} // namespace unprojector::geometry
