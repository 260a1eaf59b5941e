#include "core/matrices/pipeline.h"

#include "core/geometry/condition_number.h"
#include "core/geometry/finite.h"

#include <glm/matrix.hpp>

#include <cmath>
#include <optional>

namespace unprojector::matrices {
using namespace geometry;
namespace {

/// A point of finite coordinates, else NotFinite.
template <class Space>
Result<Point<Space>> finite(const Point<Space> &point)
{
    if (const std::optional<double> value = firstNotFinite(point))
        return Error{ErrorCode::NotFinite, *value};
    return point;
}

/// The next stage of a point, or the reason why there was none before.
template <class Target, class Source, class Step>
Result<Point<Target>> next(const Result<Point<Source>> &point, Step step)
{
    if (!point)
        return point.error();
    return step(*point);
}

/// An affine matrix or an inverse of one: w stays 1.
template <class Target, class Source>
Result<Point<Target>> affine(const glm::dmat4 &targetFromSource, const Result<Point<Source>> &point)
{
    return next<Target>(point, [&](const Point<Source> &p) {
        return finite(Point<Target>(glm::dvec3(targetFromSource * glm::dvec4(p.coordinates(), 1.0))));
    });
}

PipelinePoints forwardOf(const Pipeline &pipeline, const Result<ObjectPoint> &object, const Result<WorldPoint> &world)
{
    const Picture &geometry = pipeline.geometry;
    const auto matrix = [&](PipelineStage stage) { return pipeline.matrix(stage, PipelineDirection::Forward); };
    const Result<EyePoint> eye = affine<EyeSpace>(matrix(PipelineStage::ViewMatrix), world);
    const Result<ClipPoint> clip = next<ClipSpace>(eye, [&](const EyePoint &p) {
        return finite(ClipPoint(matrix(PipelineStage::ProjectionMatrix) * glm::dvec4(p.coordinates(), 1.0)));
    });
    const Result<NdcPoint> ndc = next<NdcSpace>(clip, [](const ClipPoint &p) -> Result<NdcPoint> {
        if (p.w == 0.0)
            return Error{ErrorCode::PointAtInfinity};
        return finite(NdcPoint(glm::dvec3(p.coordinates()) / p.w));
    });
    const Result<WindowPoint> window = next<WindowSpace>(
        ndc, [&](const NdcPoint &p) { return finite(windowFromNdc(geometry.viewport, geometry.depthRange, p)); });
    const Result<DevicePoint> device =
        next<DeviceSpace>(window, [&](const WindowPoint &p) { return finite(deviceFromWindow(geometry.surface, p)); });
    const Result<WidgetPoint> widget =
        next<WidgetSpace>(device, [&](const DevicePoint &p) { return finite(widgetFromDevice(geometry.surface, p)); });
    return {object, world, eye, clip, ndc, window, device, widget};
}

} // namespace

const glm::dmat4 &Pipeline::matrix(PipelineStage stage, PipelineDirection direction) const
{
    const auto index = static_cast<std::size_t>(stage);
    return direction == PipelineDirection::Forward ? forward[index] : backward[index];
}

Result<Pipeline> pipeline(const Picture &geometry, const glm::dmat4 &worldFromObject)
{
    if (const Check valid = check(geometry); !valid)
        return valid.error();
    if (const std::optional<double> value = firstNotFinite(worldFromObject))
        return Error{ErrorCode::NotFinite, *value};
    const EyeFrame frame = eyeFrame(geometry.camera()).value();

    const glm::dmat4 view = eyeFromWorld(frame);
    const glm::dmat4 projection = clipFromEye(geometry.projection()).value();
    const glm::dmat4 viewport = windowFromNdc(geometry.viewport, geometry.depthRange);
    if (std::isinf(conditionNumber(worldFromObject)) || std::isinf(conditionNumber(projection)))
        return Error{ErrorCode::SingularMatrix};

    const glm::dmat4 objectFromWorld = glm::inverse(worldFromObject);
    const glm::dmat4 worldFromEye(
        glm::dvec4(frame.side.coordinates(), 0.0), glm::dvec4(frame.upward.coordinates(), 0.0),
        glm::dvec4((-frame.forward).coordinates(), 0.0), glm::dvec4(frame.eye.coordinates(), 1.0));
    const glm::dmat4 eyeFromClip = glm::inverse(projection);
    glm::dmat4 ndcFromWindow(1.0);
    for (int axis = 0; axis < 3; ++axis) {
        ndcFromWindow[axis][axis] = 1.0 / viewport[axis][axis];
        ndcFromWindow[3][axis] = -viewport[3][axis] / viewport[axis][axis];
    }
    const glm::dmat4 objectFromEye = objectFromWorld * worldFromEye;
    const glm::dmat4 modelview = view * worldFromObject;

    Pipeline result{geometry,
                    {worldFromObject, view, projection, viewport, modelview, viewport * projection * modelview},
                    {objectFromWorld, worldFromEye, eyeFromClip, ndcFromWindow, objectFromEye,
                     objectFromEye * eyeFromClip * ndcFromWindow}};
    for (const glm::dmat4 &m : result.forward) {
        if (const std::optional<double> value = firstNotFinite(m))
            return Error{ErrorCode::NotFinite, *value};
    }
    for (const glm::dmat4 &m : result.backward) {
        if (firstNotFinite(m))
            return Error{ErrorCode::SingularMatrix};
    }
    return result;
}

PipelinePoints pointsForward(const Pipeline &pipeline, const ObjectPoint &point)
{
    const Result<ObjectPoint> object = finite(point);
    return forwardOf(
        pipeline, object,
        affine<WorldSpace>(pipeline.matrix(PipelineStage::ModelMatrix, PipelineDirection::Forward), object));
}

PipelinePoints pointsForward(const Pipeline &pipeline, const WorldPoint &point)
{
    const Result<WorldPoint> world = finite(point);
    return forwardOf(
        pipeline, affine<ObjectSpace>(pipeline.matrix(PipelineStage::ModelMatrix, PipelineDirection::Backward), world),
        world);
}

PipelinePoints pointsBackward(const Pipeline &pipeline, const WindowPoint &point)
{
    const Surface &surface = pipeline.geometry.surface;
    const auto matrix = [&](PipelineStage stage) { return pipeline.matrix(stage, PipelineDirection::Backward); };
    const Result<WindowPoint> window = finite(point);
    const Result<NdcPoint> ndc = affine<NdcSpace>(matrix(PipelineStage::ViewportMatrix), window);
    std::optional<glm::dvec4> undivided;
    if (ndc)
        undivided = matrix(PipelineStage::ProjectionMatrix) * glm::dvec4(ndc->coordinates(), 1.0);
    const auto divided = [&](const NdcPoint &) -> Result<EyePoint> {
        if (undivided->w == 0.0)
            return Error{ErrorCode::PointAtInfinity};
        return finite(EyePoint(glm::dvec3(*undivided) / undivided->w));
    };
    const Result<EyePoint> eye = next<EyeSpace>(ndc, divided);
    const Result<ClipPoint> clip = next<ClipSpace>(
        eye, [&](const EyePoint &) { return finite(ClipPoint(glm::dvec4(ndc->coordinates(), 1.0) / undivided->w)); });
    const Result<WorldPoint> world = affine<WorldSpace>(matrix(PipelineStage::ViewMatrix), eye);
    const Result<ObjectPoint> object = affine<ObjectSpace>(matrix(PipelineStage::ModelMatrix), world);
    const Result<DevicePoint> device =
        next<DeviceSpace>(window, [&](const WindowPoint &p) { return finite(deviceFromWindow(surface, p)); });
    const Result<WidgetPoint> widget =
        next<WidgetSpace>(device, [&](const DevicePoint &p) { return finite(widgetFromDevice(surface, p)); });
    return {object, world, eye, clip, ndc, window, device, widget, undivided};
}

std::vector<Outside> clipTest(const ClipPoint &p)
{
    if (p.w <= 0.0)
        return {p.w < 0.0 ? Outside::BehindEye : Outside::InEyePlane};
    std::vector<Outside> failed;
    const auto test = [&failed, w = p.w](double value, Outside below, Outside above) {
        if (value < -w)
            failed.push_back(below);
        else if (value > w)
            failed.push_back(above);
    };
    test(p.x, Outside::Left, Outside::Right);
    test(p.y, Outside::Bottom, Outside::Top);
    test(p.z, Outside::Near, Outside::Far);
    return failed;
}

bool isInsideViewVolume(const ClipPoint &p)
{
    return clipTest(p).empty();
}

} // namespace unprojector::matrices
