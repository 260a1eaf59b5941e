#include "core/unproject/unprojector.h"

#include "core/geometry/finite.h"
#include "core/geometry/view_matrix.h"
#include "core/unproject/closed_form.h"

#include <utility>

namespace unprojector::unproject {
using namespace geometry;
namespace {

template <class Space>
Result<Point<Space>> rounded(const Result<PrecisePoint<Space>> &point)
{
    return point ? Result<Point<Space>>(point->rounded()) : point.error();
}

} // namespace

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
Result<Point<Space>> Unprojector::Inverses<Space>::at(Method method, const PreciseWindow &window) const
{
    const auto by = [&](const auto &inverse) -> Result<Point<Space>> {
        return inverse ? inverse->at(window.rounded()) : inverse.error();
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

Result<PrecisePoint<EyeSpace>> Unprojector::preciseEyeAt(const PreciseWindow &window) const
{
    return std::visit(
        [&](const auto &lens) { return preciseEyePoint(lens, m_setup.viewport, m_setup.depthRange, window); },
        m_setup.lens);
}

Result<PrecisePoint<WorldSpace>> Unprojector::worldByFormula(const Result<PrecisePoint<EyeSpace>> &eye) const
{
    using World = Result<PrecisePoint<WorldSpace>>;
    if (!eye)
        return eye.error();
    const World world = m_frame ? World(preciseWorldFromEye(*m_frame, *eye))
                                : preciseWorldFromEye(std::get<glm::dmat4>(m_setup.pose), *eye);
    if (world && !isFinite(world->rounded()))
        return Error{ErrorCode::PointAtInfinity};
    return world;
}

Result<EyePoint> Unprojector::eyeAt(Method method, const PreciseWindow &window) const
{
    if (method != Method::Formula)
        return m_eye.at(method, window);
    return rounded(preciseEyeAt(window));
}

Result<WorldPoint> Unprojector::worldAt(Method method, const PreciseWindow &window) const
{
    if (method != Method::Formula)
        return m_world.at(method, window);
    return rounded(worldByFormula(preciseEyeAt(window)));
}

Result<ObjectPoint> Unprojector::objectAt(Method method, const PreciseWindow &window,
                                          const ObjectFromWorld &object) const
{
    const auto placed = [&object](const auto &world) {
        return world ? object.at(*world) : Result<ObjectPoint>(world.error());
    };
    return method == Method::Formula ? placed(worldByFormula(preciseEyeAt(window))) : placed(worldAt(method, window));
}

Unprojected Unprojector::at(const PreciseWindow &window) const
{
    const Result<PrecisePoint<EyeSpace>> precise = preciseEyeAt(window); // shared by both spaces
    return {Answers<EyeSpace>::of([&](Method method) -> Result<EyePoint> {
                return method == Method::Formula ? rounded(precise) : eyeAt(method, window);
            }),
            Answers<WorldSpace>::of([&](Method method) {
                return method == Method::Formula ? rounded(worldByFormula(precise)) : worldAt(method, window);
            })};
}

} // namespace unprojector::unproject
