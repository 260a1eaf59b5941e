#include "core/unproject/picture_geometry.h"

#include "core/unproject/closed_form.h"
#include "core/unproject/matrix_inverse.h"

#include <cmath>

namespace unprojector::unproject {
namespace {

Result<glm::dmat4> finite(const glm::dmat4 &m)
{
    for (int i = 0; i < 16; ++i) {
        if (!std::isfinite(m[i / 4][i % 4]))
            return Error{ErrorCode::NotFinite, m[i / 4][i % 4], double(i)};
    }
    return m;
}

using PreciseEye = PrecisePoint<EyeSpace>;

Result<PreciseEye> eyeByFormula(const PictureGeometry &g, const WindowPoint &window)
{
    return std::visit([&](const auto &p) { return preciseEyePoint(p, g.viewport, g.depthRange, window); },
                      g.projection);
}

Result<WorldPoint> worldByFormula(const PictureGeometry &g, const Result<PreciseEye> &eye)
{
    if (!eye)
        return eye.error();
    if (const auto *matrix = std::get_if<glm::dmat4>(&g.view))
        return worldFromEye(*matrix, *eye);
    const Result<PreciseEyeFrame> frame = preciseEyeFrame(std::get<LookAt>(g.view));
    if (!frame)
        return frame.error();
    return worldFromEye(*frame, *eye);
}

template <class Space>
TwoWays<Space> twoWays(const Result<Point<Space>> &formula, const Result<glm::dmat4> &clipFromSpace,
                       const PictureGeometry &g, const WindowPoint &window)
{
    if (!clipFromSpace)
        return {formula, clipFromSpace.error(), clipFromSpace.error()};
    const NdcDepth depth = ndcDepthOf(g);
    return {formula, unprojectByInverse<Space, double>(*clipFromSpace, g.viewport, g.depthRange, window, depth),
            unprojectByInverse<Space, float>(*clipFromSpace, g.viewport, g.depthRange, window, depth)};
}

Result<glm::dmat4> clipFromWorld(const PictureGeometry &g)
{
    const Result<glm::dmat4> projection = clipFromEye(g);
    if (!projection)
        return projection;
    const Result<glm::dmat4> view = eyeFromWorld(g);
    if (!view)
        return view;
    return *projection * *view;
}

} // namespace

NdcDepth ndcDepthOf(const PictureGeometry &g)
{
    const auto *matrix = std::get_if<MatrixProjection>(&g.projection);
    return matrix ? ndcDepthOf(*matrix) : NdcDepth::MinusOneToOne;
}

Result<glm::dmat4> clipFromEye(const PictureGeometry &g)
{
    if (const auto *matrix = std::get_if<MatrixProjection>(&g.projection))
        return finite(matrix->clipFromEye);
    return clipFromEye(std::get<Projection>(g.projection));
}

Result<glm::dmat4> eyeFromWorld(const PictureGeometry &g)
{
    if (const auto *matrix = std::get_if<glm::dmat4>(&g.view))
        return finite(*matrix);
    const Result<EyeFrame> frame = eyeFrame(std::get<LookAt>(g.view));
    if (!frame)
        return frame.error();
    return eyeFromWorld(*frame);
}

Result<WindowPoint> windowFromWorld(const PictureGeometry &g, const WorldPoint &point)
{
    const Result<glm::dmat4> matrix = clipFromWorld(g);
    if (!matrix)
        return matrix.error();
    const glm::dvec4 clip = *matrix * glm::dvec4(point.coordinates(), 1.0);
    if (clip.w == 0.0)
        return Error{ErrorCode::PointAtInfinity};
    return windowFromNdc(g.viewport, g.depthRange, NdcPoint(clip.x / clip.w, clip.y / clip.w, clip.z / clip.w),
                         ndcDepthOf(g));
}

Comparison compareUnprojections(const PictureGeometry &g, const WindowPoint &window)
{
    const Result<PreciseEye> eye = eyeByFormula(g, window);
    const Result<EyePoint> rounded = eye ? Result<EyePoint>(eye->rounded()) : eye.error();
    return {twoWays<EyeSpace>(rounded, clipFromEye(g), g, window),
            twoWays<WorldSpace>(worldByFormula(g, eye), clipFromWorld(g), g, window)};
}

Result<ViewGeometry> viewGeometry(const PictureGeometry &g)
{
    ViewGeometry result{g.surface, g.viewport, g.depthRange, {}, {}};
    double distance = 1.0;
    if (const auto *matrix = std::get_if<MatrixProjection>(&g.projection)) {
        const Result<RecognisedProjection> form = recognised(*matrix);
        if (!form)
            return form.error();
        if (form->looksAlongPlusZ)
            return Error{ErrorCode::MatrixNotAProjection, matrix->clipFromEye[2][3], 11.0};
        result.projection = std::visit([](const auto &p) { return Projection(p); }, form->parameters);
        if (form->infiniteFar) {
            auto &frustum = std::get<Frustum>(result.projection);
            frustum.farDistance = 1e6 * frustum.nearDistance;
        }
        if (form->reversed)
            std::swap(result.depthRange.atNear, result.depthRange.atFar);
    } else {
        result.projection = std::get<Projection>(g.projection);
    }
    const ProjectionWindow w = projectionWindow(result.projection);
    if (w.nearDistance > 0.0)
        distance = std::sqrt(w.nearDistance) * std::sqrt(w.farDistance);
    if (const auto *matrix = std::get_if<glm::dmat4>(&g.view)) {
        const Result<LookAt> camera = lookAtFrom(*matrix, distance);
        if (!camera)
            return camera.error();
        result.camera = *camera;
    } else {
        result.camera = std::get<LookAt>(g.view);
    }
    if (const Check valid = check(result); !valid)
        return valid.error();
    return result;
}

} // namespace unprojector::unproject
