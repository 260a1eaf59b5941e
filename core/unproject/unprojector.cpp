#include "core/unproject/unprojector.h"

#include "core/geometry/finite.h"
#include "core/geometry/view_matrix.h"
#include "core/unproject/closed_form.h"

#include <utility>

namespace unprojector::unproject {
using namespace geometry;

template <class Space>
Unprojector::Inverses<Space> Unprojector::Inverses<Space>::of(const Result<glm::dmat4> &clipFromSpace,
                                                              const Setup &setup)
{
    if (!clipFromSpace)
        return {clipFromSpace.error(), clipFromSpace.error()};
    const NdcDepth depth = ndcDepthOf(setup);
    return {MatrixInverse<Space, double>::of(*clipFromSpace, setup.viewport, setup.depthRange, depth),
            MatrixInverse<Space, float>::of(*clipFromSpace, setup.viewport, setup.depthRange, depth)};
}

template <class Space>
Result<Point<Space>> Unprojector::Inverses<Space>::at(Method method, const WindowPoint &window) const
{
    const auto by = [&](const auto &inverse) -> Result<Point<Space>> {
        return inverse ? inverse->at(window) : inverse.error();
    };
    return method == Method::MatrixInFloat ? by(inFloat) : by(inDouble);
}

Unprojector::Unprojector(const Setup &setup)
    : m_setup(setup), m_eye(Inverses<EyeSpace>::of(clipFromEye(setup), setup)),
      m_world(Inverses<WorldSpace>::of(clipFromWorld(setup), setup))
{
    if (const auto *camera = std::get_if<LookAt>(&m_setup.pose)) {
        if (const Result<PreciseEyeFrame> frame = preciseEyeFrame(*camera))
            m_frame = *frame;
    }
}

Result<Unprojector> Unprojector::of(const Setup &setup)
{
    if (const Check valid = check(setup); !valid)
        return valid.error();
    return Unprojector(setup);
}

Result<PrecisePoint<EyeSpace>> Unprojector::preciseEyeAt(const WindowPoint &window) const
{
    return std::visit(
        [&](const auto &lens) { return preciseEyePoint(lens, m_setup.viewport, m_setup.depthRange, window); },
        m_setup.lens);
}

Result<WorldPoint> Unprojector::worldByFormula(const Result<PrecisePoint<EyeSpace>> &eye) const
{
    if (!eye)
        return eye.error();
    const Result<WorldPoint> world = m_frame ? Result<WorldPoint>(worldFromEye(*m_frame, *eye))
                                             : worldFromEye(std::get<glm::dmat4>(m_setup.pose), *eye);
    if (world && !isFinite(*world))
        return Error{ErrorCode::PointAtInfinity};
    return world;
}

Result<EyePoint> Unprojector::eyeAt(Method method, const WindowPoint &window) const
{
    if (method != Method::Formula)
        return m_eye.at(method, window);
    const Result<PrecisePoint<EyeSpace>> eye = preciseEyeAt(window);
    if (!eye)
        return eye.error();
    return eye->rounded();
}

Result<WorldPoint> Unprojector::worldAt(Method method, const WindowPoint &window) const
{
    if (method != Method::Formula)
        return m_world.at(method, window);
    return worldByFormula(preciseEyeAt(window));
}

Unprojected Unprojector::at(const WindowPoint &window) const
{
    const Result<PrecisePoint<EyeSpace>> precise = preciseEyeAt(window); // shared by both spaces
    return {Answers<EyeSpace>::of([&](Method method) -> Result<EyePoint> {
                if (method != Method::Formula)
                    return eyeAt(method, window);
                if (!precise)
                    return precise.error();
                return precise->rounded();
            }),
            Answers<WorldSpace>::of([&](Method method) {
                return method == Method::Formula ? worldByFormula(precise) : worldAt(method, window);
            })};
}

} // namespace unprojector::unproject
