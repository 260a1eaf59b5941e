#include "core/matrices/pipeline.h"

#include "core/geometry/condition_number.h"
#include "core/geometry/finite.h"

#include <glm/matrix.hpp>

#include <cmath>
#include <optional>
#include <variant>

namespace unprojector::matrices {
using namespace geometry;
namespace {

/// The point if its coordinates are finite, else NotFinite.
template <class Space>
Result<Point<Space>> finite(const Point<Space> &point)
{
    if (const std::optional<double> value = firstNotFinite(point))
        return Error{ErrorCode::NotFinite, *value};
    return point;
}

/// The point in the next space, or the error of an earlier stage.
template <class Target, class Source, class Step>
Result<Point<Target>> next(const Result<Point<Source>> &point, Step step)
{
    if (!point)
        return point.error();
    return step(*point);
}

/// Applies an affine matrix or the inverse of one: w stays 1.
template <class Target, class Source>
Result<Point<Target>> affine(const glm::dmat4 &targetFromSource, const Result<Point<Source>> &point)
{
    return next<Target>(point, [&](const Point<Source> &p) {
        return finite(Point<Target>(glm::dvec3(targetFromSource * glm::dvec4(p.coordinates(), 1.0))));
    });
}

/// Adds the points after the window point.
PipelinePoints withWidget(const Pipeline &pipeline, PipelinePoints points)
{
    const Surface &surface = pipeline.setup.surface;
    points.device =
        next<DeviceSpace>(points.window, [&](const WindowPoint &p) { return finite(deviceFromWindow(surface, p)); });
    points.widget =
        next<WidgetSpace>(points.device, [&](const DevicePoint &p) { return finite(widgetFromDevice(surface, p)); });
    return points;
}

/// Adds the window point and those after it.
PipelinePoints withWindow(const Pipeline &pipeline, PipelinePoints points)
{
    const Setup &setup = pipeline.setup;
    points.window = next<WindowSpace>(
        points.ndc, [&](const NdcPoint &p) { return finite(windowFromNdc(setup.viewport, setup.depthRange, p)); });
    return withWidget(pipeline, points);
}

/// Adds the NDC point and those after it.
PipelinePoints withNdc(const Pipeline &pipeline, PipelinePoints points)
{
    points.ndc = next<NdcSpace>(points.clip, [](const ClipPoint &p) -> Result<NdcPoint> {
        if (p.w == 0.0)
            return Error{ErrorCode::PointAtInfinity};
        return finite(NdcPoint(glm::dvec3(p.coordinates()) / p.w));
    });
    return withWindow(pipeline, points);
}

/// Adds the clip point and those after it.
PipelinePoints withClip(const Pipeline &pipeline, PipelinePoints points)
{
    const glm::dmat4 &projection = pipeline.matrix(PipelineStage::ProjectionMatrix, PipelineDirection::Forward);
    points.clip = next<ClipSpace>(points.eye, [&](const EyePoint &p) {
        return finite(ClipPoint(projection * glm::dvec4(p.coordinates(), 1.0)));
    });
    return withNdc(pipeline, points);
}

/// Adds the eye point and those after it.
PipelinePoints withEye(const Pipeline &pipeline, PipelinePoints points)
{
    points.eye = affine<EyeSpace>(pipeline.matrix(PipelineStage::ViewMatrix, PipelineDirection::Forward), points.world);
    return withClip(pipeline, points);
}

/// Adds the world and object point from the eye point.
PipelinePoints withObject(const Pipeline &pipeline, PipelinePoints points)
{
    const auto matrix = [&](PipelineStage stage) { return pipeline.matrix(stage, PipelineDirection::Backward); };
    points.world = affine<WorldSpace>(matrix(PipelineStage::ViewMatrix), points.eye);
    points.object = affine<ObjectSpace>(matrix(PipelineStage::ModelMatrix), points.world);
    return points;
}

/// The eye point of a homogeneous clip-space point before the projection: divided by its own w'.
Result<EyePoint> divided(const glm::dvec4 &eye)
{
    if (eye.w == 0.0)
        return Error{ErrorCode::PointAtInfinity};
    return finite(EyePoint(glm::dvec3(eye) / eye.w));
}

std::optional<glm::dvec4> undivided(const Pipeline &pipeline, const Result<NdcPoint> &ndc)
{
    if (!ndc)
        return std::nullopt;
    return pipeline.matrix(PipelineStage::ProjectionMatrix, PipelineDirection::Backward)
           * glm::dvec4(ndc->coordinates(), 1.0);
}

/// Adds the eye, clip, world and object point from the NDC point.
PipelinePoints withUndivided(const Pipeline &pipeline, PipelinePoints points)
{
    points.undividedEye = undivided(pipeline, points.ndc);
    points.eye = next<EyeSpace>(points.ndc, [&](const NdcPoint &) { return divided(*points.undividedEye); });
    points.clip = next<ClipSpace>(points.eye, [&](const EyePoint &) {
        return finite(ClipPoint(glm::dvec4(points.ndc->coordinates(), 1.0) / points.undividedEye->w));
    });
    return withObject(pipeline, points);
}

// Each of these functions starts from the given point; the steps above compute the other points.

PipelinePoints from(const Pipeline &pipeline, const ObjectPoint &point)
{
    PipelinePoints points;
    points.object = finite(point);
    points.world =
        affine<WorldSpace>(pipeline.matrix(PipelineStage::ModelMatrix, PipelineDirection::Forward), points.object);
    return withEye(pipeline, points);
}

PipelinePoints from(const Pipeline &pipeline, const WorldPoint &point)
{
    PipelinePoints points;
    points.world = finite(point);
    points.object =
        affine<ObjectSpace>(pipeline.matrix(PipelineStage::ModelMatrix, PipelineDirection::Backward), points.world);
    return withEye(pipeline, points);
}

PipelinePoints from(const Pipeline &pipeline, const EyePoint &point)
{
    PipelinePoints points;
    points.eye = finite(point);
    return withClip(pipeline, withObject(pipeline, points));
}

PipelinePoints from(const Pipeline &pipeline, const ClipPoint &point)
{
    PipelinePoints points;
    points.clip = finite(point);
    points.eye = next<EyeSpace>(points.clip, [&](const ClipPoint &p) {
        return divided(pipeline.matrix(PipelineStage::ProjectionMatrix, PipelineDirection::Backward) * p.coordinates());
    });
    return withNdc(pipeline, withObject(pipeline, points));
}

PipelinePoints from(const Pipeline &pipeline, const NdcPoint &point)
{
    PipelinePoints points;
    points.ndc = finite(point);
    return withWindow(pipeline, withUndivided(pipeline, points));
}

PipelinePoints from(const Pipeline &pipeline, const WindowPoint &point)
{
    PipelinePoints points;
    points.window = finite(point);
    points.ndc =
        affine<NdcSpace>(pipeline.matrix(PipelineStage::ViewportMatrix, PipelineDirection::Backward), points.window);
    return withWidget(pipeline, withUndivided(pipeline, points));
}

} // namespace

const glm::dmat4 &Pipeline::matrix(PipelineStage stage, PipelineDirection direction) const
{
    const auto index = static_cast<std::size_t>(stage);
    return direction == PipelineDirection::Forward ? forward[index] : backward[index];
}

Result<Pipeline> pipeline(const Setup &setup, const glm::dmat4 &worldFromObject)
{
    if (const Check valid = check(setup); !valid)
        return valid.error();
    if (const std::optional<double> value = firstNotFinite(worldFromObject))
        return Error{ErrorCode::NotFinite, *value};
    const EyeFrame frame = eyeFrame(setup.camera()).value();

    const glm::dmat4 view = eyeFromWorld(frame);
    const glm::dmat4 projection = clipFromEye(setup.projection()).value();
    const glm::dmat4 viewport = windowFromNdc(setup.viewport, setup.depthRange);
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

    Pipeline result{setup,
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

Pipeline inApi(const Pipeline &pipeline, const ApiSpaces &spaces)
{
    struct Ends {
        AxisChange source, target; // of the forward direction
    };
    const AxisChange same;
    const std::array<Ends, kPipelineStages.size()> ends{{{same, spaces.world},
                                                         {spaces.world, spaces.eye},
                                                         {spaces.eye, spaces.clip},
                                                         {spaces.clip, spaces.window},
                                                         {same, spaces.eye},
                                                         {same, spaces.window}}};
    Pipeline result = pipeline;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const auto &[source, target] = ends[i];
        result.forward[i] = target.matrix() * pipeline.forward[i] * source.inverse().matrix();
        result.backward[i] = source.matrix() * pipeline.backward[i] * target.inverse().matrix();
    }
    return result;
}

PipelinePoints pointsForward(const Pipeline &pipeline, const ObjectPoint &point)
{
    return from(pipeline, point);
}

PipelinePoints pointsForward(const Pipeline &pipeline, const WorldPoint &point)
{
    return from(pipeline, point);
}

PipelinePoints pointsBackward(const Pipeline &pipeline, const WindowPoint &point)
{
    return from(pipeline, point);
}

PipelinePoints pointsFrom(const Pipeline &pipeline, const GivenPoint &given)
{
    PipelinePoints points = std::visit([&](const auto &point) { return from(pipeline, point); }, given.point);
    if (!points.undividedEye)
        points.undividedEye = undivided(pipeline, points.ndc);
    return points;
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
