#pragma once

#include "core/geometry/matrix_projection.h"
#include "core/unproject/closed_form.h"
#include "core/unproject/matrix_inverse.h"
#include "core/unproject/pick.h"
#include "core/unproject/unprojector.h"

// Shortcuts for a single point of a setup, without preparing an Unprojector.

/// @pre the setup is valid
inline unprojector::unproject::Unprojected
unprojectedAt(const unprojector::geometry::Setup &setup,
              const unprojector::unproject::Unprojector::PreciseWindow &window)
{
    return unprojector::unproject::Unprojector::of(setup).value().at(window);
}

inline unprojector::geometry::Result<unprojector::unproject::Pick>
pickAt(const unprojector::geometry::Setup &setup, const unprojector::geometry::WidgetPoint &position,
       const unprojector::unproject::DepthSample &sample)
{
    const auto prepared = unprojector::unproject::Unprojector::of(setup);
    if (!prepared)
        return prepared.error();
    const auto pixel = devicePixelFromWidget(setup.surface, position);
    if (!pixel)
        return pixel.error();
    return unprojector::unproject::pickAt(*prepared, {position, *pixel, sample});
}

/// preciseEyePoint of any lens, rounded.
template <class Lens>
unprojector::geometry::Result<unprojector::geometry::EyePoint>
unprojectClosedForm(const Lens &lens, const unprojector::geometry::Viewport &viewport,
                    const unprojector::geometry::DepthRange &range, const unprojector::geometry::WindowPoint &window)
{
    using unprojector::unproject::preciseEyePoint; // for a Projection; ADL finds the one for a matrix
    const auto point = preciseEyePoint(lens, viewport, range, window);
    if (!point)
        return point.error();
    return point->rounded();
}

template <class Space, class Scalar = double>
unprojector::geometry::Result<unprojector::geometry::Point<Space>>
unprojectByInverse(const glm::dmat4 &clipFromSpace, const unprojector::geometry::Viewport &viewport,
                   const unprojector::geometry::DepthRange &range, const unprojector::geometry::WindowPoint &window)
{
    const auto inverse = unprojector::unproject::MatrixInverse<Space, Scalar>::of(clipFromSpace, viewport, range);
    if (!inverse)
        return inverse.error();
    return inverse->at(window);
}
