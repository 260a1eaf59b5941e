#include "core/unproject/unprojector.h"

#include "core/geometry/condition_number.h"
#include "core/geometry/finite.h"
#include "core/geometry/view_matrix.h"
#include "core/unproject/closed_form.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <utility>

namespace unprojector::unproject {
namespace {

Result<glm::dmat4> projectionTaken(const Picture &picture, const Conventions &conventions)
{
    using Transposed = Conventions::Transposed;
    const Result<glm::dmat4> projection = clipFromEye(picture);
    if (projection && (conventions.transposed == Transposed::Projection || conventions.transposed == Transposed::Both))
        return glm::transpose(*projection);
    return projection;
}

Result<glm::dmat4> viewTaken(const Picture &picture, const Conventions &conventions)
{
    using Transposed = Conventions::Transposed;
    const Result<glm::dmat4> view = eyeFromWorld(picture);
    if (!view)
        return view;
    glm::dmat4 taken = *view;
    if (conventions.inverse == Conventions::Inverse::ViewInvertedTwice)
        taken = glm::inverse(taken);
    if (conventions.transposed == Transposed::View || conventions.transposed == Transposed::Both)
        taken = glm::transpose(taken);
    return taken;
}

/// The matrix whose inverse a program with these conventions applies to clip space for world coordinates.
Result<glm::dmat4> clipFromWorldTaken(const Picture &picture, const Conventions &conventions)
{
    const Result<glm::dmat4> projection = projectionTaken(picture, conventions);
    if (!projection)
        return projection;
    const Result<glm::dmat4> view = viewTaken(picture, conventions);
    if (!view)
        return view;
    // inverse(P) inverse(V) is the inverse of V P.
    const bool isTurnedRound = conventions.order == Conventions::Order::InversesInTheOrderOfTheFactors;
    glm::dmat4 product = isTurnedRound ? *view * *projection : *projection * *view;
    if (conventions.transposed == Conventions::Transposed::Product)
        product = glm::transpose(product);
    if (conventions.inverse == Conventions::Inverse::Forgotten)
        return glm::inverse(product);
    return product;
}

std::optional<glm::dmat4> modelTaken(const Conventions &conventions, const glm::dmat4 &worldFromObject)
{
    switch (conventions.model) {
    case Conventions::Model::Apart: break;
    case Conventions::Model::LeftIn: return glm::inverse(worldFromObject);
    case Conventions::Model::AppliedAgain: return worldFromObject;
    }
    return std::nullopt;
}

} // namespace

template <class Space>
Unprojector::Inverses<Space> Unprojector::Inverses<Space>::of(const Result<glm::dmat4> &clipFromSpace,
                                                              const Picture &picture)
{
    if (!clipFromSpace)
        return {clipFromSpace.error(), clipFromSpace.error()};
    const NdcDepth depth = ndcDepthOf(picture);
    return {MatrixInverse<Space, double>::of(*clipFromSpace, picture.viewport, picture.depthRange, depth),
            MatrixInverse<Space, float>::of(*clipFromSpace, picture.viewport, picture.depthRange, depth)};
}

template <class Space>
Result<Point<Space>> Unprojector::Inverses<Space>::at(Method method, const Conventions &conventions,
                                                      const WindowPoint &window) const
{
    const auto by = [&](const auto &inverse) -> Result<Point<Space>> {
        if (!inverse)
            return inverse.error();
        if (conventions.w == Conventions::W::Divided)
            return inverse->at(window);
        const auto homogeneous = inverse->homogeneousAt(window);
        if (!homogeneous)
            return homogeneous.error();
        return Point<Space>(homogeneous->x, homogeneous->y, homogeneous->z);
    };
    const bool isFloat = method == Method::MatrixInFloat || conventions.singlePrecision;
    return isFloat ? by(inFloat) : by(inDouble);
}

Unprojector::Unprojector(const Picture &picture, const Conventions &conventions, const glm::dmat4 &worldFromObject)
    : m_asTaken(picture), m_picture(misread(picture, conventions)), m_conventions(conventions),
      m_model(modelTaken(conventions, worldFromObject)),
      m_eye(Inverses<EyeSpace>::of(projectionTaken(m_picture, conventions), m_picture)),
      m_world(Inverses<WorldSpace>::of(clipFromWorldTaken(m_picture, conventions), m_picture))
{
    if (const auto *camera = std::get_if<LookAt>(&m_picture.pose)) {
        if (const Result<PreciseEyeFrame> frame = preciseEyeFrame(*camera))
            m_frame = *frame;
    }
}

Result<Unprojector> Unprojector::of(const Picture &picture, const Conventions &conventions,
                                    const glm::dmat4 &worldFromObject)
{
    if (const Check valid = check(picture); !valid)
        return valid.error();
    return Unprojector(picture, conventions, worldFromObject);
}

Result<WindowPoint> Unprojector::windowAt(const WidgetPoint &widget, double depth) const
{
    return windowOfClick(m_asTaken, m_conventions, widget, depth);
}

Result<PrecisePoint<EyeSpace>> Unprojector::preciseEyeAt(const WindowPoint &window) const
{
    return std::visit(
        [&](const auto &lens) { return preciseEyePoint(lens, m_picture.viewport, m_picture.depthRange, window); },
        m_picture.lens);
}

Result<WorldPoint> Unprojector::worldByFormula(const Result<PrecisePoint<EyeSpace>> &eye) const
{
    if (!eye)
        return eye.error();
    const Result<WorldPoint> world = m_frame ? Result<WorldPoint>(worldFromEye(*m_frame, *eye))
                                             : worldFromEye(std::get<glm::dmat4>(m_picture.pose), *eye);
    return withModel(world);
}

Result<WorldPoint> Unprojector::withModel(Result<WorldPoint> world) const
{
    if (world && m_model)
        world = WorldPoint(glm::dvec3(*m_model * glm::dvec4(world->coordinates(), 1.0)));
    if (world && !isFinite(*world))
        return Error{ErrorCode::PointAtInfinity};
    return world;
}

Result<EyePoint> Unprojector::eyeAt(Method method, const WindowPoint &window) const
{
    if (method != Method::Formula)
        return m_eye.at(method, m_conventions, window);
    const Result<PrecisePoint<EyeSpace>> eye = preciseEyeAt(window);
    if (!eye)
        return eye.error();
    return eye->rounded();
}

Result<WorldPoint> Unprojector::worldAt(Method method, const WindowPoint &window) const
{
    if (method != Method::Formula)
        return withModel(m_world.at(method, m_conventions, window));
    return worldByFormula(preciseEyeAt(window));
}

Unprojected Unprojector::at(const WindowPoint &window) const
{
    const Result<PrecisePoint<EyeSpace>> precise = preciseEyeAt(window); // once for both spaces
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
