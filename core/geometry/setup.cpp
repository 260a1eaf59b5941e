#include "core/geometry/setup.h"

#include "core/geometry/finite.h"
#include "core/geometry/view_matrix.h"
#include "core/geometry/way_forward.h"

#include <cmath>
#include <utility>

namespace unprojector::geometry {
namespace {

Result<glm::dmat4> finite(const glm::dmat4 &m)
{
    if (const Check valid = checkFinite(m); !valid)
        return valid.error();
    return m;
}

Check checkedLens(const Lens &lens)
{
    if (const auto *projection = std::get_if<Projection>(&lens))
        return check(*projection);
    return checkFinite(std::get<MatrixProjection>(lens).clipFromEye);
}

Check checkedPose(const Pose &pose)
{
    if (const auto *matrix = std::get_if<glm::dmat4>(&pose))
        return checkFinite(*matrix);
    if (const Result<EyeFrame> frame = eyeFrame(std::get<LookAt>(pose)); !frame)
        return frame.error();
    return std::monostate{};
}

/// Sets lens and depth range from a matrix of a form that the window draws.
Check takeLens(Setup &setup, const MatrixProjection &matrix)
{
    const Result<RecognisedProjection> form = recognised(matrix);
    if (!form)
        return form.error();
    if (form->looksAlongPlusZ)
        return Error{ErrorCode::MatrixNotAProjection, matrix.clipFromEye[2][3], 11.0};
    Projection projection = std::visit([](const auto &p) { return Projection(p); }, form->parameters);
    if (form->infiniteFar) {
        auto &frustum = std::get<Frustum>(projection);
        frustum.farDistance = 1e6 * frustum.nearDistance;
    }
    if (form->reversed)
        std::swap(setup.depthRange.atNear, setup.depthRange.atFar);
    setup.lens = projection;
    return std::monostate{};
}

} // namespace

bool Setup::isByParameters() const
{
    return std::holds_alternative<Projection>(lens) && std::holds_alternative<LookAt>(pose);
}

const Projection &Setup::projection() const
{
    return std::get<Projection>(lens);
}

Projection &Setup::projection()
{
    return std::get<Projection>(lens);
}

const LookAt &Setup::camera() const
{
    return std::get<LookAt>(pose);
}

LookAt &Setup::camera()
{
    return std::get<LookAt>(pose);
}

Check check(const Setup &setup)
{
    const Check checks[] = {check(setup.surface), check(setup.viewport), check(setup.depthRange),
                            checkedLens(setup.lens), checkedPose(setup.pose)};
    for (const Check &valid : checks) {
        if (!valid)
            return valid;
    }
    return std::monostate{};
}

bool hasAspectOf(const Projection &projection, const Viewport &viewport)
{
    const auto *perspective = std::get_if<Perspective>(&projection);
    return perspective && perspective->aspect == aspectOf(viewport);
}

NdcDepth ndcDepthOf(const Setup &setup)
{
    const auto *matrix = std::get_if<MatrixProjection>(&setup.lens);
    return matrix ? ndcDepthOf(*matrix) : NdcDepth::MinusOneToOne;
}

Result<glm::dmat4> clipFromEye(const Setup &setup)
{
    if (const auto *matrix = std::get_if<MatrixProjection>(&setup.lens))
        return finite(matrix->clipFromEye);
    return clipFromEye(std::get<Projection>(setup.lens));
}

Result<glm::dmat4> eyeFromWorld(const Setup &setup)
{
    if (const auto *matrix = std::get_if<glm::dmat4>(&setup.pose))
        return finite(*matrix);
    const Result<EyeFrame> frame = eyeFrame(std::get<LookAt>(setup.pose));
    if (!frame)
        return frame.error();
    return eyeFromWorld(*frame);
}

Result<glm::dmat4> clipFromWorld(const Setup &setup)
{
    const Result<glm::dmat4> projection = clipFromEye(setup);
    if (!projection)
        return projection;
    const Result<glm::dmat4> view = eyeFromWorld(setup);
    if (!view)
        return view;
    return *projection * *view;
}

Result<WindowPoint> windowFromWorld(const Setup &setup, const WorldPoint &point)
{
    const Result<WayForward> way = WayForward::of(setup);
    if (!way)
        return way.error();
    const PreciseStages stages = way->fromWorld({point.x, point.y, point.z});
    if (stages.clip[3].value == 0.0)
        return Error{ErrorCode::PointAtInfinity};
    return WindowPoint(stages.window[0].value, stages.window[1].value, stages.window[2].value);
}

Result<Setup> byParameters(const Setup &setup)
{
    Setup result = setup;
    if (const auto *matrix = std::get_if<MatrixProjection>(&setup.lens)) {
        if (const Check taken = takeLens(result, *matrix); !taken)
            return taken.error();
    }
    if (const auto *matrix = std::get_if<glm::dmat4>(&setup.pose)) {
        double distance = 1.0;
        if (const ProjectionWindow w = projectionWindow(result.projection()); w.nearDistance > 0.0)
            distance = std::sqrt(w.nearDistance) * std::sqrt(w.farDistance);
        const Result<LookAt> camera = lookAtFrom(*matrix, distance);
        if (!camera)
            return camera.error();
        result.pose = *camera;
    }
    if (const Check valid = check(result); !valid)
        return valid.error();
    return result;
}

} // namespace unprojector::geometry
