#include "core/pipeline/pipeline.h"

#include "core/geometry/condition_number.h"
#include "core/geometry/finite.h"

#include <glm/matrix.hpp>

#include <cmath>
#include <optional>
#include <tuple>
#include <variant>

namespace unprojector::pipeline {
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

// The spaces of a pipeline, by their index in GivenPoint.
constexpr std::size_t kObject = 0, kWorld = 1, kEye = 2, kClip = 3, kNdc = 4, kWindow = 5;

/// Computes the points of all spaces behind the given one.
void addForward(const Pipeline &pipeline, PipelinePoints &points, std::size_t given)
{
    const auto matrix = [&](PipelineStage stage) { return pipeline.matrix(stage, PipelineDirection::Forward); };
    const Setup &setup = pipeline.setup;
    if (given <= kObject)
        points.world = affine<WorldSpace>(matrix(PipelineStage::ModelMatrix), points.object);
    if (given <= kWorld)
        points.eye = affine<EyeSpace>(matrix(PipelineStage::ViewMatrix), points.world);
    if (given <= kEye)
        points.clip = next<ClipSpace>(points.eye, [&](const EyePoint &p) {
            return finite(ClipPoint(matrix(PipelineStage::ProjectionMatrix) * glm::dvec4(p.coordinates(), 1.0)));
        });
    if (given <= kClip)
        points.ndc = next<NdcSpace>(points.clip, [](const ClipPoint &p) -> Result<NdcPoint> {
            if (p.w == 0.0)
                return Error{ErrorCode::PointAtInfinity};
            return finite(NdcPoint(glm::dvec3(p.coordinates()) / p.w));
        });
    if (given <= kNdc)
        points.window = next<WindowSpace>(
            points.ndc, [&](const NdcPoint &p) { return finite(windowFromNdc(setup.viewport, setup.depthRange, p)); });
    points.device = next<DeviceSpace>(points.window,
                                      [&](const WindowPoint &p) { return finite(deviceFromWindow(setup.surface, p)); });
    points.widget = next<WidgetSpace>(points.device,
                                      [&](const DevicePoint &p) { return finite(widgetFromDevice(setup.surface, p)); });
}

/// Computes the points of all spaces before the given one.
void addBackward(const Pipeline &pipeline, PipelinePoints &points, std::size_t given)
{
    const auto matrix = [&](PipelineStage stage) { return pipeline.matrix(stage, PipelineDirection::Backward); };
    if (given >= kWindow)
        points.ndc = affine<NdcSpace>(matrix(PipelineStage::ViewportMatrix), points.window);
    if (given >= kNdc) {
        points.undividedEye = undivided(pipeline, points.ndc);
        points.eye = next<EyeSpace>(points.ndc, [&](const NdcPoint &) { return divided(*points.undividedEye); });
        points.clip = next<ClipSpace>(points.eye, [&](const EyePoint &) {
            return finite(ClipPoint(glm::dvec4(points.ndc->coordinates(), 1.0) / points.undividedEye->w));
        });
    } else if (given == kClip) {
        points.eye = next<EyeSpace>(points.clip, [&](const ClipPoint &p) {
            return divided(matrix(PipelineStage::ProjectionMatrix) * p.coordinates());
        });
    }
    if (given >= kEye)
        points.world = affine<WorldSpace>(matrix(PipelineStage::ViewMatrix), points.eye);
    if (given >= kWorld)
        points.object = affine<ObjectSpace>(matrix(PipelineStage::ModelMatrix), points.world);
}

template <class P>
PipelinePoints from(const Pipeline &pipeline, const P &point)
{
    PipelinePoints points;
    const auto results = std::tie(points.object, points.world, points.eye, points.clip, points.ndc, points.window);
    std::get<Result<P> &>(results) = finite(point);
    const std::size_t given = decltype(GivenPoint::point)(point).index();
    addBackward(pipeline, points, given);
    addForward(pipeline, points, given);
    return points;
}

} // namespace

const glm::dmat4 &Pipeline::matrix(PipelineStage stage, PipelineDirection direction) const
{
    const auto index = static_cast<std::size_t>(stage);
    return direction == PipelineDirection::Forward ? forward[index] : backward[index];
}

Result<Pipeline> pipelineOf(const Setup &setup, const glm::dmat4 &worldFromObject)
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

} // namespace unprojector::pipeline
